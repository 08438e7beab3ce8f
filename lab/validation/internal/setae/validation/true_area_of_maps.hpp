// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/core/table.hpp"
#include "setae/fields/describe.hpp"
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

/// Output of `setae lab area`.
struct AreaOutput {
    Index points = 0;
    std::uint64_t seed = 0;
    std::string folder;
    std::vector<MeanArea> areas;

    [[nodiscard]] double largest_deviation() const {
        double largest = 0.0;
        for (const auto& area : areas) largest = std::max(largest, std::abs(area.deviation));
        return largest;
    }
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

template <>
struct setae::fields::Described<setae::validation::MeanArea> {
    using T = validation::MeanArea;
    static constexpr std::array rows{
        field<&T::hurst_exponent>("H", "Hurst exponent"),
        field<&T::rms_slope>("rms_slope", "rms slope h'_rms"),
        field<&T::excess_area>("excess_area", "excess area A_true/A_app − 1"),
        field<&T::deviation>("deviation", "excess area divided by that of Gaussian roughness (Eq. 9), minus 1"),
        field<&T::standard_error>("deviation_standard_error", "standard error of the deviation"),
    };
    static constexpr Description description{"", "mean over the maps of one Hurst exponent at one rms slope", rows};
};
static_assert(setae::fields::complete<setae::validation::MeanArea>);

template <>
struct setae::fields::Described<setae::validation::AreaOutput> {
    using T = validation::AreaOutput;
    static constexpr std::array rows{
        made<T>("points", "number of points along x and y",
                [](const T& of) {
                    return std::array{of.points, of.points};
                }),
        field<&T::seed>("seed", "seed of the random numbers"),
        made<T>("maps_each", "number of maps of each Hurst exponent", [](const T&) { return validation::maps_each; }),
        field<&T::folder>("folder", "folder of the table and the figure"),
        made<T>("largest_deviation", "largest size of a deviation", [](const T& of) { return of.largest_deviation(); }),
        field<&T::areas>("areas", "one entry per Hurst exponent and rms slope"),
        inner<&T::points>(),
    };
    static constexpr Description description{"", "areas of maps with known area", rows};
};
static_assert(setae::fields::complete<setae::validation::AreaOutput>);
