// SPDX-License-Identifier: GPL-3.0-or-later
#include "abel_integral.hpp"

#include <algorithm>
#include <cmath>

#include <boost/math/quadrature/gauss.hpp>

#include "setae/core/constants.hpp"

namespace setae::spectra {
namespace {

constexpr double far = 1.5;
constexpr Index terms = 30;  // of the series at q = 1.5 q_x: c_30 1.5^-60 = 3e-12

}  // namespace

AbelIntegral::AbelIntegral(const ArrayView1D& nodes, const ArrayView1D& spectrum)
    : nodes_(nodes), spectrum_(spectrum), slopes_(nodes.size() - 1), sums_(Array2D::Zero(nodes.size(), terms)) {
    for (Index i = nodes.size() - 2; i >= 0; --i) {
        const double span = std::log(nodes[i + 1] / nodes[i]);
        slopes_[i] = std::log(spectrum[i + 1] / spectrum[i]) / span;
        for (Index k = 0; k < terms; ++k) {
            const double twice = 2.0 * static_cast<double>(k), exponent = slopes_[i] + 1.0 - twice,
                         growth = exponent * span;
            const double piece = std::abs(growth) < 1e-12 ? span : std::expm1(growth) / exponent;
            sums_(i, k) = spectrum[i] * nodes[i] * piece + std::exp(-twice * span) * sums_(i + 1, k);
        }
    }
}

double AbelIntegral::operator()(double q_x) const {
    const Index last = nodes_.size() - 1;
    const auto first_above = [&](double q) {
        return static_cast<Index>(std::upper_bound(nodes_.begin(), nodes_.end(), q) - nodes_.begin());
    };
    double sum = q_x < nodes_[0] ? spectrum_[0] * std::sqrt((nodes_[0] - q_x) * (nodes_[0] + q_x)) : 0.0;
    Index i = std::max<Index>(first_above(q_x) - 1, 0);
    for (const Index end = std::min(first_above(far * q_x), last); i < end; ++i) sum += near_piece(i, q_x);
    if (i < last) sum += far_pieces(i, q_x);
    return sum / pi;
}

double AbelIntegral::near_piece(Index i, double q_x) const {
    const double lower = std::max(nodes_[i], q_x), upper = nodes_[i + 1];
    if (!(lower < upper)) return 0.0;
    // in v the integrand is analytic up to ± i q_x, and the width of a piece of 2 % is at most a fifth of that
    if (upper < 1.02 * lower) return gauss<4>(i, q_x, lower, upper);
    if (upper < 1.2 * lower) return gauss<10>(i, q_x, lower, upper);
    // half a decade at most for the long rule
    const int parts = std::max(1, static_cast<int>(std::ceil(2.0 * std::log10(upper / lower))));
    double sum = 0.0, from = lower;
    for (int part = 1; part <= parts; ++part) {
        const double to = part == parts ? upper : lower * std::pow(upper / lower, static_cast<double>(part) / parts);
        sum += gauss<20>(i, q_x, from, to);
        from = to;
    }
    return sum;
}

template <unsigned points>
double AbelIntegral::gauss(Index i, double q_x, double lower, double upper) const {
    const double v_lower = std::sqrt((lower - q_x) * (lower + q_x)), v_upper = std::sqrt((upper - q_x) * (upper + q_x));
    const double half_slope = 0.5 * slopes_[i], share = q_x / nodes_[i], scale = 1.0 / nodes_[i];
    const auto integrand = [&](double v) { return std::pow(share * share + (scale * v) * (scale * v), half_slope); };
    return spectrum_[i] * boost::math::quadrature::gauss<double, points>::integrate(integrand, v_lower, v_upper);
}

double AbelIntegral::far_pieces(Index i, double q_x) const {
    const double ratio = q_x / nodes_[i];
    double sum = 0.0, factor = 1.0;
    for (Index k = 0; k < terms; ++k) {
        sum += factor * sums_(i, k);
        factor *= ratio * ratio * (2.0 * static_cast<double>(k) + 1.0) / (2.0 * static_cast<double>(k) + 2.0);
    }
    return sum;
}

}  // namespace setae::spectra
