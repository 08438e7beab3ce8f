// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/validation/true_area_of_maps.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/roughness/true_area.hpp"
#include "setae/spectra/self_affine.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::validation {
namespace {

constexpr std::array hurst_exponents{0.3, 0.8};
constexpr std::array slopes{0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0};

}  // namespace

double AreaOfMap::deviation() const {
    return (area_ratio - 1.0) / (roughness::gaussian_area_ratio(rms_slope) - 1.0) - 1.0;
}

std::vector<AreaOfMap> true_area_of_maps(const TrueAreaOptions& options) {
    if (options.points < 128)
        throw InvalidArgument(fmt::format("maps of {0} x {0} points; expected at least 128", options.points));
    const double extent = static_cast<double>(options.points);
    std::vector<AreaOfMap> areas;
    std::uint64_t index = 0;
    for (const double hurst : hurst_exponents)
        for (std::uint64_t map_index = 0; map_index < maps_each; ++map_index) {
            // in units of the distance between points
            const spectra::SelfAffine model{1.0, 2.0 * pi * 16.0 / extent, hurst, 0.5 * pi};
            auto map = synthesis::random_surface(
                spectra::density(model), {options.points, options.points, extent, extent},
                {.key = numerics::substream({options.seed}, index++), .threads = options.threads});
            double slope_now = roughness::triangulated_area(map, options.threads).rms_slope;
            for (const double slope : slopes) {
                map.heights *= slope / slope_now;
                slope_now = slope;
                const auto area = roughness::triangulated_area(map, options.threads);
                areas.push_back({hurst, area.rms_slope, area.area_ratio});
            }
        }
    return areas;
}

std::vector<MeanArea> means(const std::vector<AreaOfMap>& areas) {
    constexpr auto count = static_cast<double>(maps_each);
    std::vector<MeanArea> result;
    for (std::size_t h = 0; h < hurst_exponents.size(); ++h)
        for (std::size_t s = 0; s < slopes.size(); ++s) {
            const auto of_map = [&](std::size_t map) -> const AreaOfMap& {
                return areas.at((h * maps_each + map) * slopes.size() + s);
            };
            double excess = 0.0, deviation = 0.0, square = 0.0;
            for (std::size_t map = 0; map < maps_each; ++map) {
                excess += (of_map(map).area_ratio - 1.0) / count;
                deviation += of_map(map).deviation() / count;
            }
            for (std::size_t map = 0; map < maps_each; ++map)
                square += std::pow(of_map(map).deviation() - deviation, 2.0);
            result.push_back(
                {hurst_exponents[h], slopes[s], excess, deviation, std::sqrt(square / (count - 1.0) / count)});
        }
    return result;
}

}  // namespace setae::validation
