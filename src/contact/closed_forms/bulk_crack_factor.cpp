// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact/bulk_crack_factor.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include "domain.hpp"
#include "setae/core/constants.hpp"
#include "setae/numerics/bracketing.hpp"

namespace setae::contact::crack_speed {
namespace {

void require(const std::vector<RelaxationTerm>& terms) {
    for (const auto& term : terms) {
        require_not_negative(term.share, "share of a relaxation term");
        require_positive(term.time, "time of a relaxation term");
    }
}

/// E∞ Im E/|E|² at ω [1/s].
double lost(double frequency, const std::vector<RelaxationTerm>& terms) {
    std::complex<double> modulus = 1.0;
    for (const auto& term : terms) {
        const std::complex<double> at{0.0, frequency * term.time};
        modulus += term.share * at / (1.0 + at);
    }
    return modulus.imag() / std::norm(modulus);
}

/// f where the tip reaches frequencies up to ω₁ [1/s].
double factor_up_to(double highest, const std::vector<RelaxationTerm>& terms) {
    double longest = 0.0;
    for (const auto& term : terms)
        if (term.share > 0.0) longest = std::max(longest, term.time);
    if (!(longest > 0.0) || !(highest > 0.0)) return 1.0;
    // in ln(ω/ω₁); the loss is proportional to ω below 1/τ
    constexpr double below = 35.0, tolerance = 1e-11;
    constexpr unsigned depth = 15;
    const double slowest = std::min(0.0, -std::log(highest * longest)) - below;
    const auto integrand = [&](double logarithm) {
        const double share = std::exp(logarithm);
        return std::sqrt(std::max(0.0, 1.0 - share * share)) * lost(share * highest, terms);
    };
    using Rule = boost::math::quadrature::gauss_kronrod<double, 61>;
    return 1.0 / (1.0 - 2.0 / pi * Rule::integrate(integrand, slowest, 0.0, depth, tolerance));
}

}  // namespace

double largest_bulk_factor(const std::vector<RelaxationTerm>& terms) {
    require(terms);
    double sum = 1.0;
    for (const auto& term : terms) sum += term.share;
    return sum;
}

double bulk_factor(double speed, const std::vector<RelaxationTerm>& terms, double tip_radius) {
    require_not_negative(speed, "crack speed");
    require_positive(tip_radius, "radius of a crack's tip");
    const double largest = largest_bulk_factor(terms);
    if (!(speed > 0.0) || !(largest > 1.0)) return 1.0;
    const double sharp = 2.0 * pi * speed / tip_radius;
    // f(ω₁) ω₁ = 2π v/a0, and ω₁ f rises with ω₁
    const auto missing = [&](double logarithm) {
        return logarithm + std::log(factor_up_to(sharp * std::exp(logarithm), terms));
    };
    const double root = numerics::bracketed_root(missing, -std::log(largest) - 1e-9, 1e-9, 48);
    return factor_up_to(sharp * std::exp(root), terms);
}

}  // namespace setae::contact::crack_speed
