// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_elasticity.hpp"

#include <algorithm>
#include <cmath>

namespace setae::crack_front {

LineElasticity::LineElasticity(Index points, double longest_wave)
    : forward_(points),
      back_(points),
      longest_wave_(longest_wave),
      line_(static_cast<std::size_t>(points)),
      modes_(static_cast<std::size_t>(forward_.modes())) {
    double sum = 0.0;
    for (Index n = 0; n < points; ++n) sum += static_cast<double>(std::min(n, points - n));
    own_ = longest_wave * sum / static_cast<double>(points);
}

void LineElasticity::filtered(const Array1D& in, Array1D& out, double s, double c, bool inverse) {
    std::copy_n(in.data(), in.size(), line_.data());
    forward_.forward(line_.data(), modes_.data());
    const double share = 1.0 / static_cast<double>(points());
    for (std::size_t n = 0; n < modes_.size(); ++n) {
        const double factor = s + c * longest_wave_ * static_cast<double>(n);
        modes_[n] *= share * (inverse ? 1.0 / factor : factor);
    }
    back_.apply(modes_.data(), line_.data());
    out = Eigen::Map<const Array1D>(line_.data(), points());
}

void LineElasticity::slopes(const Array1D& in, Array1D& out) {
    std::copy_n(in.data(), in.size(), line_.data());
    forward_.forward(line_.data(), modes_.data());
    const double share = longest_wave_ / static_cast<double>(points());
    for (std::size_t n = 0; n < modes_.size(); ++n)
        modes_[n] = fourier::Complex(-modes_[n].imag(), modes_[n].real()) * (share * static_cast<double>(n));
    if (points() % 2 == 0) modes_.back() = 0.0;
    back_.apply(modes_.data(), line_.data());
    out = Eigen::Map<const Array1D>(line_.data(), points());
}

}  // namespace setae::crack_front
