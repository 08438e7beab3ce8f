// SPDX-License-Identifier: GPL-3.0-or-later
#include "pixel_kernels.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "setae/core/constants.hpp"
#include "setae/numerics/legendre.hpp"

namespace setae::half_space {
namespace {

/// asinh(t/s) − asinh(r/s) for t > r, s > 0, without cancellation where t and r have one sign.
double asinh_difference(double t, double r, double s) {
    if (t * r <= 0.0) return std::asinh(t / s) - std::asinh(r / s);
    const double at_t = std::hypot(t, s), at_r = std::hypot(r, s);
    return std::asinh((t - r) * (t + r) / (t * at_r + r * at_t));
}

/// Rules by which the mean of 1/distance is exact to 1e-14 beyond so many half-widths.
const numerics::GaussRule& rule_at(double distance_in_half_widths) {
    static const std::array rules{numerics::gauss_rule(3), numerics::gauss_rule(4), numerics::gauss_rule(8)};
    if (distance_in_half_widths > 400.0) return rules[0];
    return distance_in_half_widths > 60.0 ? rules[1] : rules[2];
}

double by_rule(double x, double y, const HalfPixel& half) {
    const double distance = std::hypot(x, y);
    const auto &along_x = rule_at(distance / half.x), &along_y = rule_at(distance / half.y);
    double sum = 0.0;
    for (std::size_t i = 0; i < along_x.nodes.size(); ++i) {
        const double dx = x - half.x * along_x.nodes[i];
        for (std::size_t j = 0; j < along_y.nodes.size(); ++j) {
            const double dy = y - half.y * along_y.nodes[j];
            sum += along_x.weights[i] * along_y.weights[j] / std::sqrt(dx * dx + dy * dy);
        }
    }
    return half.x * half.y * sum / pi;
}

/// The first two terms of 1/distance averaged over the rectangle, exact to 1e-14 beyond 4000 half-widths.
double by_moments(double x, double y, const HalfPixel& half) {
    const double a = half.x * half.x, b = half.y * half.y, square = x * x + y * y;
    const double correction = (a * (3.0 * x * x - square) + b * (3.0 * y * y - square)) / (6.0 * square * square);
    return 4.0 * half.x * half.y * (1.0 + correction) / (pi * std::sqrt(square));
}

/// ∫ ln|y'| dy' from y − b to y + b.
double log_integral(double y, double b) {
    if (y > 8.0 * b) {
        const auto& rule = rule_at(y / b);
        double sum = 0.0;
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) sum += rule.weights[i] * std::log1p(b * rule.nodes[i] / y);
        return b * (sum + 2.0 * std::log(y));
    }
    const auto antiderivative = [](double s) { return s == 0.0 ? 0.0 : s * std::log(std::abs(s)) - s; };
    return antiderivative(y + b) - antiderivative(y - b);
}

/// ∫ K_0(q|y'|) dy' from y − b to y + b, by K_0(z) = ∫_0^∞ exp(−z cosh t) dt.
double bessel_integral(double q, double y, double b) {
    constexpr double step = 0.25, negligible = 40.0;  // exp(−π²/step) = 7e-18
    double sum = 0.0;
    for (Index i = 0;; ++i) {
        const double cosh = std::cosh(step * static_cast<double>(i)), decay = q * cosh;
        const bool inside = y < b;
        if ((inside ? std::log(cosh) : decay * (y - b)) > negligible) break;
        const double term = inside ? (2.0 - std::exp(-decay * (b - y)) - std::exp(-decay * (b + y))) / decay
                                   : std::exp(-decay * (y - b)) * -std::expm1(-2.0 * decay * b) / decay;
        sum += i == 0 ? 0.5 * term : term;
    }
    return step * sum;
}

}  // namespace

double rectangle_displacement(double x, double y, const HalfPixel& half) {
    const double a = half.x, b = half.y;
    x = std::abs(x);
    y = std::abs(y);
    if (std::max(x, y) > 4000.0 * std::max(a, b)) return by_moments(x, y, half);
    if (std::max(x, y) > 8.0 * std::max(a, b)) return by_rule(x, y, half);
    const auto along = [](double at, double to, double from) {  // at · ∫ dt/√(at² + t²) between them
        return at == 0.0 ? 0.0 : at * asinh_difference(to, from, std::abs(at));
    };
    return (along(x + a, y + b, y - b) - along(x - a, y + b, y - b) + along(y + b, x + a, x - a) -
            along(y - b, x + a, x - a)) /
           pi;
}

double strip_displacement(double wavevector, double y, double half_width, double repeat) {
    y = std::abs(y);
    if (wavevector > 0.0) return 2.0 / pi * bessel_integral(wavevector, y, half_width);
    constexpr double euler = 0.57721566490153286061;
    return -2.0 / pi * (log_integral(y, half_width) + 2.0 * half_width * (euler - std::log(2.0 * repeat)));
}

}  // namespace setae::half_space
