// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/texture/height_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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

/// Σ over defined points of a series, in lanes that vectorise.
Powers powers_of_points(const double* heights, Index n, double origin) {
    constexpr Index lanes = 4;
    Powers lane[lanes];
    const auto add = [origin](Powers& sums, double h) {
        const bool defined = h == h;
        const double z = defined ? h - origin : 0.0, z2 = z * z;
        sums.weight += defined ? 1.0 : 0.0;
        sums.first += z;
        sums.second += z2;
        sums.third += z2 * z;
        sums.fourth += z2 * z2;
        sums.absolute += std::abs(z);
        sums.lowest = defined && z < sums.lowest ? z : sums.lowest;
        sums.highest = defined && z > sums.highest ? z : sums.highest;
    };
    Index i = 0;
    for (; i + lanes <= n; i += lanes)
        for (Index k = 0; k < lanes; ++k) add(lane[k], heights[i + k]);
    for (; i < n; ++i) add(lane[i % lanes], heights[i]);
    for (Index k = 1; k < lanes; ++k) lane[0].add(lane[k]);
    return lane[0];
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

Powers powers(const topography::Profile& profile, double origin, parallel::Threads) {
    Powers sums;
    for (Index i = 0; i + 1 < profile.heights.size(); ++i)
        sums.add(powers_of_segment(profile.heights[i] - origin, profile.heights[i + 1] - origin,
                                   profile.positions[i + 1] - profile.positions[i]));
    return sums;
}

template <class Uniform>
Powers powers(const Uniform& data, double origin, parallel::Threads threads) {
    const auto n = data.heights.size();
    std::vector<Powers> blocks(static_cast<std::size_t>((n + block_points - 1) / block_points));
    parallel::for_each_index(blocks.size(), threads, [&](std::size_t b) {
        const auto first = static_cast<Index>(b) * block_points;
        blocks[b] = powers_of_points(data.heights.data() + first, std::min(block_points, n - first), origin);
    });
    Powers sums;
    for (const auto& block : blocks) sums.add(block);
    return sums;
}

double first_defined(const Eigen::Ref<const Array1D>& heights, const topography::Metadata& metadata) {
    for (const double h : heights)
        if (h == h) return h;
    throw UndefinedDataError(topography::label(metadata) + ": no defined height");
}

template <class Kind>
HeightParameters parameters_of(const Kind& data, parallel::Threads threads, std::optional<double> mean_line) {
    const Eigen::Map<const Array1D> heights(data.heights.data(), data.heights.size());
    const double start = first_defined(heights, data.metadata);
    const auto rough = powers(data, start, threads);
    const double mean = mean_line.value_or(start + rough.first / rough.weight);
    const auto sums = powers(data, mean, threads);
    HeightParameters result;
    const double rest = mean_line ? 0.0 : sums.first / sums.weight;  // what rounding of the mean leaves
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
    result.defined = (heights == heights).count();
    return result;
}

}  // namespace

HeightParameters height_parameters(const MeasurementView& measurement, parallel::Threads threads,
                                   std::optional<double> mean_line) {
    if (const auto* profile = measurement.as<topography::Profile>()) topography::validate(*profile);
    return measurement.visit([=](const auto& m) { return parameters_of(m, threads, mean_line); });
}

}  // namespace setae::texture
