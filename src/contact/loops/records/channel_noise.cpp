// SPDX-License-Identifier: GPL-3.0-or-later
#include "channel_noise.hpp"

#include <algorithm>
#include <cmath>

#include "baseline.hpp"

namespace setae::loops {
namespace {

Array1D differences(const Array1D& series) {
    const Index n = series.size() - 1;
    return series.tail(n) - series.head(n);
}

/// The step that values are multiples of, where they repeat as rounded ones do; else 0.
double rounding_step(const Array1D& series) {
    constexpr double equal_share = 0.1, multiples_share = 0.95, near = 1e-3;
    const Array1D steps = differences(series).abs();
    double least = INFINITY;
    Index changed = 0;
    for (const double step : steps)
        if (step > 0.0) {
            ++changed;
            least = std::min(least, step);
        }
    if (changed == 0 || static_cast<double>(changed) > (1.0 - equal_share) * static_cast<double>(steps.size()))
        return 0.0;
    Index multiples = 0;
    for (const double step : steps)
        if (step > 0.0 && std::abs(step / least - std::round(step / least)) < near) ++multiples;
    return static_cast<double>(multiples) >= multiples_share * static_cast<double>(changed) ? least : 0.0;
}

}  // namespace

double white_noise(const ArrayView1D& series) {
    const Index n = series.size();
    if (n < 3) return 0.0;
    return std::sqrt((series.head(n - 2) - 2.0 * series.segment(1, n - 2) + series.tail(n - 2)).square().mean() / 6.0);
}

double record_noise(const ArrayView1D& series) {
    constexpr Index fewest = 4;
    if (series.size() < fewest) return 0.0;
    constexpr double sigma_over_median = 1.4826;
    const double scatter = sigma_over_median * median_of(differences(differences(differences(series))).abs());
    return std::max(scatter / std::sqrt(20.0), rounding_step(series) / std::sqrt(12.0));
}

FreeFlightNoise free_flight_noise(const ArrayView1D& series) {
    constexpr Index fewest = 16;
    constexpr double clear = 2.5, most = 0.99;
    const Index n = series.size();
    FreeFlightNoise noise{.sigma = white_noise(series)};
    if (n < fewest) return noise;
    const auto count = static_cast<double>(n);
    const Array1D at = Array1D::LinSpaced(n, -0.5 * (count - 1.0), 0.5 * (count - 1.0));
    Array1D rest = series - series.mean();
    rest -= (at * rest).sum() / at.square().sum() * at;
    constexpr double rounding = 1e-24;  // share of the squares: a straight line without noise
    const double squares = rest.square().sum();
    if (!(squares > rounding * (series - series.mean()).square().sum())) return noise;
    const double neighbours = (rest.head(n - 1) * rest.tail(n - 1)).sum() / squares;
    const double correlation = std::min((count * neighbours + 2.0) / (count - 4.0), most);
    if (!(correlation > clear / std::sqrt(count))) return noise;
    noise.correlation = correlation;
    noise.sigma = std::sqrt(squares / std::max(count - 2.0 * noise.correlated_samples(), 0.25 * count));
    return noise;
}

}  // namespace setae::loops
