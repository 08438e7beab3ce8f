// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "setae/topography/measurement.hpp"
#include "setae/topography/tip.hpp"

namespace setae::simulation {

/// Metadata of a simulated measurement: instrument type, and the radius at the tip's apex where its shape names one.
[[nodiscard]] topography::Metadata simulated_with_tip(const std::string& type, const topography::Tip& tip,
                                                      std::optional<double> tip_radius_standard_error);

/// @throws InvalidArgument that names the quantity unless it is finite and >= 0.
void require_not_negative(double value, const char* what);

/// @throws InvalidArgument that names the quantity unless it is finite.
void require_finite(double value, const char* what);

/// bow (1 − (2s − 1)²) at the share s of a scan.
[[nodiscard]] inline double bow_at(double bow, double share) {
    return bow * (1.0 - (2.0 * share - 1.0) * (2.0 * share - 1.0));
}

}  // namespace setae::simulation
