// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "setae/parallel/for_each.hpp"
#include "setae/processing/parameters.hpp"
#include "setae/processing/processed.hpp"

namespace setae::processing {

/// Keeps only wavelengths within a band with sharp limits: modes with 2π/longest <= |q| <= 2π/shortest. The mean height
/// is always kept.
///
/// |q| = sqrt(qx² + qy²) on maps, so a grating along an axis is treated as one along the diagonal. Only for periodic
/// data without undefined points: ends and holes of other data would cause ringing (use the ISO 16610 filters,
/// iso_filter.hpp). A wavelength within 1e-9 of a limit is kept. O(n log n).
struct FourierCut {
    std::optional<double> shortest = {};  ///< shorter wavelengths [m] are removed
    std::optional<double> longest = {};   ///< longer wavelengths [m] are removed, except the mean
};

/// @throws InvalidArgument for data that are not periodic, limits that are not positive or in the wrong order, or no
/// limit;
///   UndefinedDataError for undefined heights.
[[nodiscard]] topography::HeightMap cut(topography::HeightMap map, const FourierCut& band,
                                        parallel::Threads threads = {});
[[nodiscard]] topography::LineScan cut(topography::LineScan scan, const FourierCut& band);

[[nodiscard]] Processed apply(const FourierCut& step, topography::Measurement measurement,
                              parallel::Threads threads = {});

inline constexpr std::string_view step_name(const FourierCut&) { return "fourier_cut"; }
template <class Visitor>
void visit_parameters(FourierCut& step, Visitor& visitor) {
    visitor.optional_length("shortest", step.shortest, "wavelength below which nothing stays");
    visitor.optional_length("longest", step.longest, "wavelength above which nothing but the mean stays");
}

}  // namespace setae::processing
