// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/texture/height_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::texture {
namespace {

/// Sums of powers of heights from an origin, and extremes, of one block.
struct Powers {
    double weight = 0.0, first = 0.0, second = 0.0, third = 0.0, fourth = 0.0, absolute = 0.0;
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;

    void add(const Powers& other) {
        weight += other.weight;
        first += other.first;
        second += other.second;
        third += other.third;
        fourth += other.fourth;
        absolute += other.absolute;
        lowest = std::min(lowest, other.lowest);
        highest = std::max(highest, other.highest);
    }
};

constexpr Index block_points = 1 << 15;

/// Summed quantities: heights for their mean, or all powers.
enum class Summed { first, all };

/// Σ over the points of a series, in lanes that vectorise. Unchecked, a NaN makes the sum of heights NaN; checked, it
/// is left out. Both add defined heights in the same order.
template <Summed summed, bool checked>
Powers powers_of_points(const double* heights, Index n, double origin) {
    constexpr Index lanes = 4;
    double weight[lanes] = {}, first[lanes] = {}, second[lanes] = {}, third[lanes] = {}, fourth[lanes] = {},
           absolute[lanes] = {}, lowest[lanes], highest[lanes];
    std::fill_n(lowest, lanes, std::numeric_limits<double>::infinity());
    std::fill_n(highest, lanes, -std::numeric_limits<double>::infinity());
    const auto add = [&](Index k, double h) {
        const bool defined = !checked || !std::isnan(h);
        const double z = defined ? h - origin : 0.0;
        if constexpr (checked) weight[k] += defined ? 1.0 : 0.0;
        first[k] += z;
        if constexpr (summed == Summed::all) {
            const double z2 = z * z;
            second[k] += z2;
            third[k] += z2 * z;
            fourth[k] += z2 * z2;
            absolute[k] += std::abs(z);
            lowest[k] = defined && z < lowest[k] ? z : lowest[k];
            highest[k] = defined && z > highest[k] ? z : highest[k];
        }
    };
    Index i = 0;
    for (; i + lanes <= n; i += lanes)
        for (Index k = 0; k < lanes; ++k) add(k, heights[i + k]);
    for (; i < n; ++i) add(i % lanes, heights[i]);
    Powers sums;
    for (Index k = 0; k < lanes; ++k)
        sums.add({weight[k], first[k], second[k], third[k], fourth[k], absolute[k], lowest[k], highest[k]});
    if constexpr (!checked) sums.weight = static_cast<double>(n);
    return sums;
}

template <Summed summed>
Powers powers_of_points(const double* heights, Index n, double origin) {
    const auto quick = powers_of_points<summed, false>(heights, n, origin);
    return std::isnan(quick.first) ? powers_of_points<summed, true>(heights, n, origin) : quick;
}

/// ∫ over a segment from height a to b of length dx.
Powers powers_of_segment(double a, double b, double dx) {
    const double a2 = a * a, b2 = b * b;
    const double absolute = a * b >= 0.0 ? 0.5 * std::abs(a + b) : 0.5 * (a2 + b2) / (std::abs(a) + std::abs(b));
    return {dx,
            dx * 0.5 * (a + b),
            dx * (a2 + a * b + b2) / 3.0,
            dx * (a + b) * (a2 + b2) / 4.0,
            dx * (a2 * a2 + a2 * a * b + a2 * b2 + a * b2 * b + b2 * b2) / 5.0,
            dx * absolute,
            std::min(a, b),
            std::max(a, b)};
}

template <Summed>
Powers powers(const topography::Profile& profile, double origin, parallel::Threads) {
    Powers sums;
    for (Index i = 0; i + 1 < profile.heights.size(); ++i)
        sums.add(powers_of_segment(profile.heights[i] - origin, profile.heights[i + 1] - origin,
                                   profile.positions[i + 1] - profile.positions[i]));
    return sums;
}

template <Summed summed, class Uniform>
Powers powers(const Uniform& data, double origin, parallel::Threads threads) {
    const auto n = data.heights.size();
    std::vector<Powers> blocks(static_cast<std::size_t>((n + block_points - 1) / block_points));
    parallel::for_each_index(blocks.size(), threads, [&](std::size_t b) {
        const auto first = static_cast<Index>(b) * block_points;
        blocks[b] = powers_of_points<summed>(data.heights.data() + first, std::min(block_points, n - first), origin);
    });
    Powers sums;
    for (const auto& block : blocks) sums.add(block);
    return sums;
}

double first_defined(const Eigen::Ref<const Array1D>& heights, const topography::Metadata& metadata) {
    for (const double h : heights)
        if (!std::isnan(h)) return h;
    throw UndefinedDataError(topography::label(metadata) + ": no height is defined");
}

template <class Kind>
HeightParameters parameters_of(const Kind& data, parallel::Threads threads, std::optional<double> mean_line) {
    const Eigen::Map<const Array1D> heights(data.heights.data(), data.heights.size());
    const double start = first_defined(heights, data.metadata);
    const auto mean_height = [&] {
        const auto sums = powers<Summed::first>(data, start, threads);
        return start + sums.first / sums.weight;
    };
    const double mean = mean_line ? *mean_line : mean_height();
    const auto sums = powers<Summed::all>(data, mean, threads);
    HeightParameters result;
    const double rest = mean_line ? 0.0 : sums.first / sums.weight;  // remainder from rounding of the mean
    const double variance = sums.second / sums.weight - rest * rest;
    // heights equal up to the rounding of their mean have no shape
    const bool constant = !mean_line && !(sums.highest - sums.lowest > 0.0);
    result.mean = constant ? start : mean;
    result.Sq = constant ? 0.0 : std::sqrt(std::max(0.0, variance));
    result.Ssk = constant ? undefined : sums.third / sums.weight / (variance * result.Sq);
    result.Sku = constant ? undefined : sums.fourth / sums.weight / (variance * variance);
    result.Sp = constant ? 0.0 : sums.highest;
    result.Sv = constant ? 0.0 : -sums.lowest;
    result.Sz = result.Sp + result.Sv;
    result.Sa = constant ? 0.0 : sums.absolute / sums.weight;
    if constexpr (std::is_same_v<Kind, topography::Profile>) result.defined = (!heights.isNaN()).count();
    else result.defined = static_cast<Index>(sums.weight);
    return result;
}

}  // namespace

HeightParameters height_parameters(const MeasurementView& measurement, parallel::Threads threads,
                                   std::optional<double> mean_line) {
    if (const auto* profile = measurement.as<topography::Profile>()) topography::validate(*profile);
    return measurement.visit([=](const auto& m) { return parameters_of(m, threads, mean_line); });
}

}  // namespace setae::texture
