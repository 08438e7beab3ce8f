// SPDX-License-Identifier: GPL-3.0-or-later
#include "baseline.hpp"

#include <cmath>

#include <fmt/format.h>

#include "channel_noise.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"

namespace setae::loops {
namespace {

Array1D second_differences(const ArrayView1D& series) {
    const Index n = series.size();
    if (n < 3) return Array1D();
    return series.head(n - 2) - 2.0 * series.segment(1, n - 2) + series.tail(n - 2);
}

/// Covariance of two channels, from second differences as for white noise, in proportion to the excess of their noise.
double covariance_of(const Array1D& x, const FreeFlightNoise& of_x, const Array1D& y, const FreeFlightNoise& of_y) {
    const double white = white_noise(x) * white_noise(y);
    if (!(white > 0.0)) return 0.0;
    return (second_differences(x) * second_differences(y)).mean() / 6.0 * (of_x.sigma * of_y.sigma / white);
}

}  // namespace

Array1D clock_of(const Loop& loop) {
    const Index n = loop.force.size();
    const auto runs_on = [&] {
        return (loop.time.tail(n - 1) >= loop.time.head(n - 1)).all() && loop.time[n - 1] > loop.time[0];
    };
    if (n > 1 && loop.time.size() == n && loop.time.allFinite() && runs_on()) return loop.time;
    return Array1D::LinSpaced(n, 0.0, static_cast<double>(n - 1));
}

Baseline given_baseline(const Loop& loop, const GivenRange& given, const std::string& name) {
    constexpr Index fewest = 5;
    const IndexRange range = samples_of(given, loop, name);
    if (range.count() < fewest)
        throw InvalidArgument(fmt::format("{}: samples {} to {} are {} samples; a zero of force needs at least {}",
                                          name, range.first, range.last, range.count(), fewest));
    return baseline_over(loop, range);
}

SampleNoise sample_noise(const Baseline& baseline) {
    const double phi = baseline.force_noise_correlation;
    return {.sigma = baseline.force_noise, .correlated_samples = (1.0 + phi) / (1.0 - phi)};
}

double median_of(Array1D values) { return median({values.data(), static_cast<std::size_t>(values.size())}); }

Baseline baseline_over(const Loop& loop, const IndexRange& range) {
    const Array1D force = loop.force.segment(range.first, range.count());
    const FreeFlightNoise noise = free_flight_noise(force);
    Baseline baseline{.range = range,
                      .force = median_of(force),
                      .force_noise = noise.sigma,
                      .force_noise_correlation = noise.correlation};
    // the median of n normal values: σ √(π/2n)
    baseline.force_standard_error =
        noise.sigma * std::sqrt(0.5 * pi * noise.correlated_samples() / static_cast<double>(range.count()));
    if (loop.displacement.size() > 0) {
        const Array1D displacement = loop.displacement.segment(range.first, range.count());
        const FreeFlightNoise of_displacement = free_flight_noise(displacement);
        baseline.displacement_noise = of_displacement.sigma;
        baseline.displacement_noise_correlation = of_displacement.correlation;
        baseline.force_displacement_covariance = covariance_of(force, noise, displacement, of_displacement);
    }
    return baseline;
}

}  // namespace setae::loops
