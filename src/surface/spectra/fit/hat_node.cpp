// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectral_fit/hat_node.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <boost/math/quadrature/gauss.hpp>

#include "setae/core/constants.hpp"

namespace setae::spectral_fit::hat_node {
namespace {

constexpr double h = node_spacing;
constexpr double longest = 3000.0;

/// a(z) = ∫_0^z (J0(t) − 1)/t dt and b(z) = ∫_0^z a(t)/t dt: the first and second integral of J0(e^u) − 1 over u = ln
/// z.
class BesselIntegrals {
public:
    struct Values {
        double first, second;
    };

    BesselIntegrals() {
        const auto count = static_cast<std::size_t>(longest * std::exp(h) / step) + 3;
        first_.resize(count);
        second_.resize(count);
        const auto below = static_cast<std::size_t>(1.0 / step);
        for (std::size_t i = 0; i <= below; ++i) {
            const auto [a, b] = series(step * static_cast<double>(i));
            first_[i] = a;
            second_[i] = b;
        }
        using Rule = boost::math::quadrature::gauss<double, 7>;
        for (std::size_t i = below + 1; i < count; ++i) {
            // b by parts: ∫ a/t dt = [a ln t] − ∫ (J0 − 1) ln t/t dt
            const double from = step * static_cast<double>(i - 1), to = step * static_cast<double>(i);
            const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
            double da = 0.0, weighted = 0.0;
            const auto add = [&](double t, double weight) {
                const double value = weight * half * (::j0(t) - 1.0) / t;
                da += value;
                weighted += value * std::log(t);
            };
            add(middle, Rule::weights()[0]);
            for (std::size_t g = 1; g < Rule::abscissa().size(); ++g)
                for (const double sign : {-1.0, 1.0})
                    add(middle + sign * half * Rule::abscissa()[g], Rule::weights()[g]);
            first_[i] = first_[i - 1] + da;
            second_[i] = second_[i - 1] + first_[i] * std::log(to) - first_[i - 1] * std::log(from) - weighted;
        }
    }

    /// 0 <= z <= longest e^h. Cubic Hermite interpolation with the derivatives (J0 − 1)/z and a/z.
    [[nodiscard]] Values operator()(double z) const {
        if (z < 1.0) return series(z);
        const auto i = static_cast<std::size_t>(z / step);
        const double from = step * static_cast<double>(i), to = from + step, t = (z - from) / step;
        const double a = hermite(first_[i], first_[i + 1], slope_of_first(i) * step, slope_of_first(i + 1) * step, t);
        const double b = hermite(second_[i], second_[i + 1], first_[i] / from * step, first_[i + 1] / to * step, t);
        return {a, b};
    }

private:
    static constexpr double step = 0.05;

    static Values series(double z) {
        const double x = -0.25 * z * z;
        double term = 1.0, a = 0.0, b = 0.0;
        for (int m = 1; m <= 10; ++m) {
            term *= x / (m * m);
            a += term / (2.0 * m);
            b += term / (4.0 * m * m);
        }
        return {a, b};
    }

    /// da/dz at a node, by central differences of the table (exact to step⁴); the one-sided ends are never used.
    [[nodiscard]] double slope_of_first(std::size_t i) const {
        const std::size_t n = first_.size();
        if (i < 2 || i + 2 >= n)
            return i + 1 < n ? (first_[i + 1] - first_[i]) / step : (first_[i] - first_[i - 1]) / step;
        return (8.0 * (first_[i + 1] - first_[i - 1]) - (first_[i + 2] - first_[i - 2])) / (12.0 * step);
    }

    static double hermite(double y0, double y1, double d0, double d1, double t) {
        const double s = 1.0 - t;
        return s * s * ((1.0 + 2.0 * t) * y0 + t * d0) + t * t * ((3.0 - 2.0 * t) * y1 - s * d1);
    }

    std::vector<double> first_, second_;
};

const BesselIntegrals& bessel_integrals() {
    static const BesselIntegrals integrals;
    return integrals;
}

double autocovariance_from_integrals(double z) {
    const auto& integrals = bessel_integrals();
    return h + (integrals(z * std::exp(h)).second - 2.0 * integrals(z).second + integrals(z * std::exp(-h)).second) / h;
}

/// The autocovariance on a grid of z, four-point interpolation between.
class AutocovarianceTable {
public:
    AutocovarianceTable() : values_(static_cast<std::size_t>(longest / step) + 4) {
        for (std::size_t i = 0; i < values_.size(); ++i)
            values_[i] = autocovariance_from_integrals(
                step * (static_cast<double>(i) - 1.0 < 0.0 ? 1.0 : static_cast<double>(i) - 1.0));
    }
    [[nodiscard]] double operator()(double z) const {
        const double place = z / step;
        const auto i = static_cast<std::size_t>(place);
        const double t = place - static_cast<double>(i);
        const double* v = values_.data() + i;  // v[1] is the value at step · i; the function is even
        const double t1 = t - 1.0, t2 = t - 2.0, tp = t + 1.0;
        return -t * t1 * t2 / 6.0 * v[0] + tp * t1 * t2 / 2.0 * v[1] - tp * t * t2 / 2.0 * v[2] +
               tp * t * t1 / 6.0 * v[3];
    }

private:
    static constexpr double step = 0.025;
    std::vector<double> values_;
};

/// Line integrals of a node as an integral over its wavevectors p = e^u with weight hat(u):
///   ∫_0^q C1D = (1/π) ∫ hat(u) asin(min(1, q/p)) du,   ∫_0^q q' C1D = (1/π) ∫ hat(u) [p − √(p² − min(p,q)²)] du.
LineIntegrals integrate(double q, double lower, double upper) {
    using Rule = boost::math::quadrature::gauss<double, 15>;
    LineIntegrals sum;
    const auto piece = [&](double from, double to, bool towards_start) {
        if (!(to > from)) return;
        // u = from + (to − from) v² removes the root at u = ln q
        const double width = to - from, middle = 0.5, half = 0.5;
        const auto add = [&](double v, double weight) {
            const double u = towards_start ? from + width * v * v : to - width * v * v;
            const double p = std::exp(u), ratio = std::min(1.0, q / p);
            const double share = weight * half * 2.0 * width * v * (1.0 - std::abs(u) / h);
            sum.zeroth += share * std::asin(ratio);
            sum.first += share * p * ratio * ratio / (1.0 + std::sqrt((1.0 - ratio) * (1.0 + ratio)));
        };
        add(middle, Rule::weights()[0]);
        for (std::size_t g = 1; g < Rule::abscissa().size(); ++g)
            for (const double sign : {-1.0, 1.0}) add(middle + sign * half * Rule::abscissa()[g], Rule::weights()[g]);
    };
    const double edge = std::clamp(std::log(std::max(q, 1e-300)), lower, upper);
    for (const auto& [from, to] : {std::pair{lower, std::min(upper, 0.0)}, std::pair{std::max(lower, 0.0), upper}}) {
        piece(from, std::clamp(edge, from, std::max(from, to)), false);
        piece(std::clamp(edge, from, std::max(from, to)), to, true);
    }
    return {sum.zeroth / pi, sum.first / pi};
}

}  // namespace

double autocovariance(double distance) {
    static const AutocovarianceTable table;
    return distance >= longest ? 0.0 : table(distance);
}

double autocovariance_of_lower_half(double distance) {
    if (distance >= longest) return 0.0;
    const auto& integrals = bessel_integrals();
    const auto at = integrals(distance);
    return 0.5 * h + at.first - (at.second - integrals(distance * std::exp(-h)).second) / h;
}

double autocovariance_of_disc(double distance) { return distance < 1e-4 ? 0.5 : ::j1(distance) / distance; }

LineIntegrals line_integrals(double wavevector) { return integrate(wavevector, -h, h); }

LineIntegrals line_integrals_of_lower_half(double wavevector) { return integrate(wavevector, -h, 0.0); }

LineIntegrals line_integrals_of_disc(double wavevector) {
    // C1D = √(1 − q²)/π
    const double q = std::min(wavevector, 1.0), root = std::sqrt((1.0 - q) * (1.0 + q));
    return {0.5 * (q * root + std::asin(q)) / pi, (1.0 - root * root * root) / (3.0 * pi)};
}

}  // namespace setae::spectral_fit::hat_node
