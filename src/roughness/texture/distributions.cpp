// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/texture/distributions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "counted_values.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"
#include "setae/texture/height_parameters.hpp"
#include "setae/texture/material_ratio.hpp"

namespace setae::texture {
namespace {

/// Median of |x − median| to rms of a Gaussian: 1/Φ⁻¹(3/4).
constexpr double gaussian_mad = 1.482602218505602;

struct Quartiles {
    double first, median, third;
};

/// The quantile of values that count the same, linear between them; their order changes.
double quantile(std::vector<double>& values, double probability) {
    const double place = probability * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::ptrdiff_t>(place);
    std::nth_element(values.begin(), values.begin() + below, values.end());
    const double lower = values[static_cast<std::size_t>(below)];
    const double rest = place - static_cast<double>(below);
    if (rest == 0.0) return lower;
    return lower + rest * (*std::min_element(values.begin() + below + 1, values.end()) - lower);
}

/// The quantile of weighted values: linear between the middles of their weights.
double weighted_quantile(const CountedValues& all, double probability) {
    std::vector<std::size_t> order(all.values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return all.values[a] < all.values[b]; });
    const double wanted = probability * std::accumulate(all.weights.begin(), all.weights.end(), 0.0);
    double before = 0.0, last_middle = 0.0, last_value = all.values[order.front()];
    for (const auto k : order) {
        const double middle = before + 0.5 * all.weights[k];
        if (middle >= wanted)
            return middle > last_middle ? last_value + (all.values[k] - last_value) *
                                                           std::max(0.0, wanted - last_middle) / (middle - last_middle)
                                        : last_value;
        before += all.weights[k];
        last_middle = middle;
        last_value = all.values[k];
    }
    return last_value;
}

double quantile_of(CountedValues& all, double probability) {
    return all.weights.empty() ? quantile(all.values, probability) : weighted_quantile(all, probability);
}

/// Quartiles and the median of deviations.
void take_ranks(Distribution& result, CountedValues all) {
    const Quartiles at{quantile_of(all, 0.25), quantile_of(all, 0.5), quantile_of(all, 0.75)};
    for (auto& value : all.values) value = std::abs(value - at.median);
    result.median = at.median;
    result.mad = gaussian_mad * quantile_of(all, 0.5);
    result.interquartile_range = at.third - at.first;
    result.robust_skewness =
        result.interquartile_range > 0.0 ? (at.third + at.first - 2.0 * at.median) / result.interquartile_range : 0.0;
}

void take_moments(Distribution& result, const CountedValues& all) {
    const auto weight = [&all](std::size_t k) { return all.weights.empty() ? 1.0 : all.weights[k]; };
    double total = 0.0, sum = 0.0;
    const double origin = all.values.front();
    for (std::size_t k = 0; k < all.values.size(); ++k) {
        total += weight(k);
        sum += weight(k) * (all.values[k] - origin);
    }
    result.mean = origin + sum / total;
    std::array<double, 5> powers{};
    for (std::size_t k = 0; k < all.values.size(); ++k) {
        const double z = all.values[k] - result.mean;
        double power = weight(k);
        for (auto& entry : powers) {
            entry += power / total;
            power *= z;
        }
    }
    const double variance = std::max(0.0, powers[2] - powers[1] * powers[1]);
    result.rms = std::sqrt(variance);
    result.skewness = variance > 0.0 ? powers[3] / (variance * result.rms) : undefined;
    result.kurtosis = variance > 0.0 ? powers[4] / (variance * variance) : undefined;
}

/// The Gaussian beside the bins, and how far cumulated shares are apart.
void take_gaussian(Distribution& result, double lowest, double width) {
    const auto n = result.density.size();
    result.centre = Array1D::NullaryExpr(n, [=](Index k) { return lowest + (static_cast<double>(k) + 0.5) * width; });
    result.gaussian = Array1D::Zero(n);
    if (!(result.rms > 0.0)) return;
    const auto below = [&](Index k) {
        return normal_probability((lowest + static_cast<double>(k) * width - result.mean) / result.rms);
    };
    double share = 0.0;
    for (Index k = 0; k < n; ++k) {
        result.gaussian[k] = (below(k + 1) - below(k)) / width;
        share += result.density[k] * width;
        result.gaussian_distance = std::max(result.gaussian_distance, std::abs(share - below(k + 1)));
    }
}

Index bin_count(Index bins, double range, double interquartile_range, Index values) {
    if (bins > 0) return bins;
    const double width = 2.0 * interquartile_range / std::cbrt(static_cast<double>(values));
    return width > 0.0 ? std::clamp<Index>(static_cast<Index>(std::min(range / width, 1e9)), 8, 512) : 8;
}

/// Heights along straight segments: shares from the exact material ratio.
Distribution of_segments(const topography::Profile& profile, Index bins) {
    Distribution result;
    const auto heights = height_parameters(profile);
    const auto quartiles = heights_at_ratio(profile, (Array1D(3) << 0.25, 0.5, 0.75).finished());
    result.mean = heights.mean;
    result.rms = heights.Sq;
    result.skewness = heights.Ssk;
    result.kurtosis = heights.Sku;
    result.median = quartiles[1];
    result.mad = gaussian_mad * mad_height(profile, 0.5);
    result.interquartile_range = quartiles[0] - quartiles[2];
    result.robust_skewness = result.interquartile_range > 0.0
                                 ? (quartiles[0] + quartiles[2] - 2.0 * quartiles[1]) / result.interquartile_range
                                 : 0.0;
    result.values = heights.defined;
    const double lowest = profile.heights.minCoeff(), range = profile.heights.maxCoeff() - lowest;
    const auto n = bin_count(bins, range, result.interquartile_range, result.values);
    const double width = range > 0.0 ? range / static_cast<double>(n) : 1.0;
    Array1D edges = Array1D::NullaryExpr(n + 1, [=](Index k) { return lowest + static_cast<double>(k) * width; });
    edges[n] = std::numeric_limits<double>::infinity();  // the highest point belongs to the last bin
    const auto above = bearing_area(profile, edges);
    result.density = (above.head(n) - above.tail(n)) / width;
    take_gaussian(result, lowest, width);
    return result;
}

}  // namespace

Distribution distribution(const MeasurementView& measurement, Counted counted, Index bins) {
    if (bins < 0)
        throw InvalidArgument(
            fmt::format("a distribution has {} bins, expected 1 or more, or 0 for a number by rule", bins));
    if (const auto* profile = measurement.as<topography::Profile>(); profile && counted == Counted::height) {
        topography::validate(*profile);
        return of_segments(*profile, bins);
    }
    auto all = counted_values(measurement, counted);
    if (all.values.size() < 2)
        throw UndefinedDataError(fmt::format("{}: {} values to make a distribution of, expected two or more",
                                             topography::label(measurement.metadata()), all.values.size()));
    Distribution result;
    result.values = static_cast<Index>(all.values.size());
    take_moments(result, all);
    const auto [least, greatest] = std::minmax_element(all.values.begin(), all.values.end());
    const double lowest = *least, range = *greatest - *least;
    take_ranks(result, all);
    const auto n = bin_count(bins, range, result.interquartile_range, result.values);
    const double width = range > 0.0 ? range / static_cast<double>(n) : 1.0;
    result.density = Array1D::Zero(n);
    double total = 0.0;
    for (std::size_t k = 0; k < all.values.size(); ++k) {
        const double weight = all.weights.empty() ? 1.0 : all.weights[k];
        result.density[std::min(n - 1, static_cast<Index>((all.values[k] - lowest) / width))] += weight;
        total += weight;
    }
    result.density /= total * width;
    take_gaussian(result, lowest, width);
    return result;
}

double central_moment(const MeasurementView& measurement, int order) {
    if (order < 1 || order > 8) throw InvalidArgument(fmt::format("order of a moment is {}, expected 1 … 8", order));
    const double mean = height_parameters(measurement).mean;
    const auto* profile = measurement.as<topography::Profile>();
    if (!profile) {
        const auto all = counted_values(measurement, Counted::height);
        double sum = 0.0;
        for (const double value : all.values) sum += std::pow(value - mean, order);
        return sum / static_cast<double>(all.values.size());
    }
    double sum = 0.0;
    for (Index i = 0; i + 1 < profile->heights.size(); ++i) {
        const double a = profile->heights[i] - mean, b = profile->heights[i + 1] - mean;
        double terms = 0.0;  // Σ a^k b^(order − k)
        for (int k = 0; k <= order; ++k) terms += std::pow(a, k) * std::pow(b, order - k);
        sum += (profile->positions[i + 1] - profile->positions[i]) * terms / (order + 1);
    }
    return sum / profile->size();
}

}  // namespace setae::texture
