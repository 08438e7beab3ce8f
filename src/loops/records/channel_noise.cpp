// SPDX-License-Identifier: GPL-3.0-or-later
#include "channel_noise.hpp"

#include <algorithm>
#include <cmath>

namespace setae::loops {

double white_noise(const ArrayView1D& series) {
    const Index n = series.size();
    if (n < 3) return 0.0;
    return std::sqrt((series.head(n - 2) - 2.0 * series.segment(1, n - 2) + series.tail(n - 2)).square().mean() / 6.0);
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
    constexpr double rounding = 1e-24;  // of the squares: a straight line without noise
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
