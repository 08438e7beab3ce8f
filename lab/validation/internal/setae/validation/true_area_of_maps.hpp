// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/core/table.hpp"
#include "setae/figures/figure.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::validation {

inline constexpr std::uint64_t maps_each = 3;  ///< maps of each Hurst exponent

struct TrueAreaOptions {
    Index points = 4096;     ///< points of a map along x and y
    std::uint64_t seed = 1;  ///< same seed, same maps
    parallel::Threads threads;
};

/// One map at one slope.
struct AreaOfMap {
    double hurst_exponent = 0.0;
    double rms_slope = 0.0;   ///< rms slope of the triangles
    double area_ratio = 1.0;  ///< A_true/A_app of the triangles

    /// (A_true/A_app − 1) divided by that of Eq. 9, minus 1.
    [[nodiscard]] double deviation() const;
};

/// Mean over the maps of one Hurst exponent at one slope.
struct MeanArea {
    double hurst_exponent = 0.0, rms_slope = 0.0;
    double excess_area = 0.0;     ///< A_true/A_app − 1
    double deviation = 0.0;       ///< as AreaOfMap::deviation
    double standard_error = 0.0;  ///< standard error of the deviation, between maps
};

/// True area of self-affine maps, H = 0.3 and 0.8, three of each, each scaled to every rms slope from 0.01 to 10.
///
/// Fourier-filtered; shortest wavelength 4 points, longest 1/16 of the map, below which the spectrum is flat. Area of
/// the triangles through the heights, both diagonals averaged. In order of Hurst exponent, map and slope; equal for any
/// number of threads.
/// @throws InvalidArgument for maps smaller than 128 points.
/// Source: [D19], Eq. S3, Fig. S7.
[[nodiscard]] std::vector<AreaOfMap> true_area_of_maps(const TrueAreaOptions& options);

/// Means over the maps, in order of Hurst exponent and slope.
[[nodiscard]] std::vector<MeanArea> means(const std::vector<AreaOfMap>& areas);

/// A row for each map at each slope.
[[nodiscard]] Table area_table(const std::vector<AreaOfMap>& areas);
/// Excess area against rms slope, with Eq. 9 and its limits, and the deviation from Eq. 9.
/// Source: [D19], Fig. S7.
[[nodiscard]] figures::Figure area_figure(const std::vector<MeanArea>& areas);

}  // namespace setae::validation
