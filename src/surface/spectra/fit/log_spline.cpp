// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectral_fit/log_spline.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::spectral_fit {

LogSpline::LogSpline(double lowest, double shortest) : shortest_(shortest), spacing_(std::log(10.0) / 10.0) {
    if (!(lowest > 0.0) || !(shortest > lowest) || !std::isfinite(shortest))
        throw InvalidArgument(
            fmt::format("a spectrum between {} and {} 1/m; expected 0 < lowest < shortest", lowest, shortest));
    intervals_ = std::max<Index>(1, static_cast<Index>(std::ceil(std::log(shortest / lowest) / spacing_ - 1e-9)));
    origin_ = std::log(shortest) - spacing_ * static_cast<double>(intervals_);
    coefficients_ = intervals_ + 3;
}

double LogSpline::position(Index coefficient) const {
    return origin_ + spacing_ * static_cast<double>(coefficient - 1);
}

LogSpline::Piece LogSpline::piece(double wavevector) const {
    const double place = std::clamp((std::log(wavevector) - origin_) / spacing_, 0.0, static_cast<double>(intervals_));
    const Index first = std::min(static_cast<Index>(place), intervals_ - 1);
    const double t = place - static_cast<double>(first), s = 1.0 - t;
    return {first,
            {s * s * s / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0, (3.0 * s * s * s - 6.0 * s * s + 4.0) / 6.0,
             t * t * t / 6.0}};
}

Eigen::MatrixXd LogSpline::design(const ArrayView1D& wavevectors) const {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(wavevectors.size(), coefficients_);
    for (Index i = 0; i < wavevectors.size(); ++i) {
        const auto [first, weight] = piece(wavevectors[i]);
        for (Index m = 0; m < 4; ++m) matrix(i, first + m) = weight[m];
    }
    return matrix;
}

double LogSpline::value(const Eigen::VectorXd& theta, double wavevector) const {
    if (wavevector > shortest_ * (1.0 + 1e-12)) return 0.0;
    const auto [first, weight] = piece(std::max(wavevector, 1e-300));
    double sum = 0.0;
    for (Index m = 0; m < 4; ++m) sum += weight[m] * theta[first + m];
    return std::exp(sum);
}

}  // namespace setae::spectral_fit
