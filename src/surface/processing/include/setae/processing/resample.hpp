// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "setae/parallel/for_each.hpp"
#include "setae/processing/parameters.hpp"
#include "setae/processing/processed.hpp"

namespace setae::processing {

enum class Resampling {
    linear,   ///< LinearInterpolator at the new points
    bicubic,  ///< BicubicInterpolator at the new points
    fourier,  ///< fourier_interpolated: only periodic data
    average,  ///< mean of the old pixels in a new pixel, weighted by the covered area; keeps the mean
};
inline constexpr std::array<Choice<Resampling>, 4> resampling_names{{{"linear", Resampling::linear},
                                                                     {"bicubic", Resampling::bicubic},
                                                                     {"fourier", Resampling::fourier},
                                                                     {"average", Resampling::average}}};

/// Other points for the same area.
///
/// Given are nx (maps: and ny), or pixel_size, from which n = round(size/pixel_size) and the exact step size/n.
/// Periodic
/// data: points at i · size/n. Others, linear and bicubic: n points from the first to the last old one, so none is
/// undefined; with pixel_size the step is exact and the rest at the far end is lost. A new pixel of `average` covers
/// [i, i+1) · size/n of old pixels [j, j+1) · size/n_old, and is undefined if more than half of it is; its height is
/// that of the pixel, as for the old ones, so the first point is (new − old step)/2 further inside. Polylines: linear,
/// from first to last point.
struct Resample {
    Index nx = 0;                           ///< points along x; 0: from pixel_size
    Index ny = 0;                           ///< points along y of maps; 0: from pixel_size, otherwise in proportion to
                                            ///< nx
    std::optional<double> pixel_size = {};  ///< [m]
    Resampling method = Resampling::average;
};

/// @throws InvalidArgument for a grid of fewer than two points per direction or neither nx nor pixel_size, `fourier` on
/// data that are not periodic.
[[nodiscard]] topography::HeightMap resampled(const topography::HeightMap& map, const Resample& grid,
                                              parallel::Threads threads = {});
[[nodiscard]] topography::LineScan resampled(const topography::LineScan& scan, const Resample& grid,
                                             parallel::Threads threads = {});
[[nodiscard]] topography::LineScan resampled(const topography::Profile& profile, const Resample& grid);

[[nodiscard]] Processed apply(const Resample& step, topography::Measurement measurement,
                              parallel::Threads threads = {});

inline constexpr std::string_view step_name(const Resample&) { return "resample"; }
template <class Visitor>
void visit_parameters(Resample& step, Visitor& visitor) {
    visitor.count("nx", step.nx, "points along x; 0: from pixel_size");
    visitor.count("ny", step.ny, "points along y; 0: from pixel_size, else in proportion to nx");
    visitor.optional_length("pixel_size", step.pixel_size, "distance of the new points");
    visitor.choice("method", step.method, resampling_names, "how heights between points are found");
}

}  // namespace setae::processing
