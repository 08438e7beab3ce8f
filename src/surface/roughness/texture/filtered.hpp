// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/texture/profile_parameters.hpp"

namespace setae::texture {

/// A measurement after filters; empty if no filter applies.
/// @throws InvalidArgument for a polyline, nesting indices that are not positive or S >= L, waviness without L-filter.
[[nodiscard]] std::optional<topography::Measurement> filtered(const MeasurementView& measurement,
                                                              const Filters& filters, ProfileKind kind,
                                                              parallel::Threads threads);

/// "Gaussian S-filter 2.5 µm, Gaussian L-filter 800 µm"; "none".
[[nodiscard]] std::string description(const Filters& filters, ProfileKind kind);

/// The reliable band with its ends limited by filters, and warnings on it.
struct Bandwidth {
    Band band;
    std::vector<Alert> alerts;  ///< TIP_CUTOFF
};
[[nodiscard]] Bandwidth bandwidth(const MeasurementView& measurement, const Filters& filters, ProfileKind kind,
                                  parallel::Threads threads);

/// UNDEF if more than 1 % of the heights are undefined.
[[nodiscard]] std::vector<Alert> undefined_alerts(const MeasurementView& measurement);

/// Whether a parameter depends on the shortest waves, so a blunt tip makes it too small.
[[nodiscard]] bool depends_on_short_waves(std::string_view symbol);

}  // namespace setae::texture
