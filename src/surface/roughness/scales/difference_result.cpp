// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference_result.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::scales {
namespace {

/// "slope" of "rms_slope".
std::string derivative_name(int order) { return order == 1 ? "slope" : order == 2 ? "curvature" : "third_derivative"; }

std::string unit_of(int power_of_length) {
    return power_of_length == 0 ? "1" : power_of_length == 1 ? "1/m" : fmt::format("1/m{}", power_of_length);
}

struct Named {
    Statistic statistic;
    const char* name;
};
constexpr Named statistics[] = {{Statistic::rms, "rms"},           {Statistic::variance, "variance"},
                                {Statistic::mean, "mean"},         {Statistic::skewness, "skewness"},
                                {Statistic::kurtosis, "kurtosis"}, {Statistic::minimum, "minimum"},
                                {Statistic::maximum, "maximum"}};

const char* name_of(Statistic statistic) {
    for (const auto& known : statistics)
        if (known.statistic == statistic) return known.name;
    throw InternalError("a statistic without a name");
}

}  // namespace

void require_differences(const DifferenceOptions& options, const topography::Metadata& metadata) {
    const auto label = topography::label(metadata);
    if (options.order < 1 || options.order > 3)
        throw InvalidArgument(fmt::format("{}: difference of order {}; expected 1, 2 or 3", label, options.order));
    if (options.order == 3 && options.along == Along::both)
        throw InvalidArgument(
            fmt::format("{}: third differences along both directions at once; compute x and y separately", label));
    if (options.distances)
        for (const double distance : *options.distances)
            if (!(distance > 0.0) || !std::isfinite(distance))
                throw InvalidArgument(fmt::format("{}: distance {} m; expected positive and finite", label, distance));
}

DifferenceStatistics statistics_of(const std::vector<DifferenceMoments>& moments, const DifferenceOptions& options,
                                   const topography::Metadata& metadata) {
    if (moments.empty())
        throw InvalidArgument(fmt::format(
            "{}: no distance has {} differences of order {}; choose distances between {} steps and the size",
            topography::label(metadata), options.fewest, options.order, options.order));
    const auto n = static_cast<Index>(moments.size());
    DifferenceStatistics result;
    result.order = options.order;
    result.along = options.along;
    result.metadata = metadata;
    for (auto* values : {&result.distance, &result.count, &result.mean, &result.rms, &result.variance, &result.skewness,
                         &result.kurtosis, &result.minimum, &result.maximum})
        *values = Array1D(n);
    for (Index k = 0; k < n; ++k) {
        const auto& m = moments[static_cast<std::size_t>(k)];
        const double m1 = m.powers[0] / m.count, m2 = m.powers[1] / m.count, m3 = m.powers[2] / m.count,
                     m4 = m.powers[3] / m.count;
        const double variance = std::max(0.0, m2 - m1 * m1);
        result.distance[k] = m.distance;
        result.count[k] = m.count;
        result.mean[k] = m.origin + m1;
        result.variance[k] = variance;
        result.rms[k] = std::sqrt(variance + result.mean[k] * result.mean[k]);
        result.skewness[k] =
            variance > 0.0 ? (m3 - 3.0 * m1 * m2 + 2.0 * m1 * m1 * m1) / std::pow(variance, 1.5) : undefined;
        result.kurtosis[k] =
            variance > 0.0 ? (m4 - 4.0 * m1 * m3 + 6.0 * m1 * m1 * m2 - 3.0 * m1 * m1 * m1 * m1) / (variance * variance)
                           : undefined;
        result.minimum[k] = m.minimum;
        result.maximum[k] = m.maximum;
    }
    return result;
}

FunctionOfScale function_of(const DifferenceStatistics& of, Statistic statistic) {
    const auto derivative = derivative_name(of.order);
    const int power = of.order - 1;
    FunctionOfScale result;
    result.distance = of.distance;
    result.count = of.count;
    result.count_unit = of.count_unit;
    result.standard_error = Array1D::Constant(of.distance.size(), undefined);
    result.reliable_from = of.reliable_from;
    result.metadata = of.metadata;
    result.quantity = fmt::format("{}_{}", name_of(statistic), derivative);
    result.unit = unit_of(power);
    switch (statistic) {
        case Statistic::rms: result.value = of.rms; break;
        case Statistic::mean: result.value = of.mean; break;
        case Statistic::minimum: result.value = of.minimum; break;
        case Statistic::maximum: result.value = of.maximum; break;
        case Statistic::variance:
            result.value = of.variance;
            result.unit = unit_of(2 * power);
            break;
        case Statistic::skewness:
            result.value = of.skewness;
            result.unit = "1";
            break;
        case Statistic::kurtosis:
            result.value = of.kurtosis;
            result.unit = "1";
            break;
    }
    if (of.along != Along::x) result.quantity += of.along == Along::y ? "_y" : "_xy";
    return result;
}

Statistic statistic_from_name(const std::string& name) {
    for (const auto& known : statistics)
        if (name == known.name) return known.statistic;
    throw InvalidArgument(fmt::format(
        "unknown statistic \"{}\"; expected rms, variance, mean, skewness, kurtosis, minimum or maximum", name));
}

Along along_from_name(const std::string& name) {
    if (name == "x") return Along::x;
    if (name == "y") return Along::y;
    if (name == "both") return Along::both;
    throw InvalidArgument(fmt::format("unknown direction \"{}\"; expected x, y or both", name));
}

}  // namespace setae::scales
