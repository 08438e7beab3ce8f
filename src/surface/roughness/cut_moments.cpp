// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut_moments.hpp"

#include <algorithm>
#include <cmath>

#include <boost/math/quadrature/gauss.hpp>

namespace setae::roughness {
namespace {

/// Antiderivatives of q^n/√(s² − q²).
struct Antiderivatives {
    double first, second, third, fifth;
};

Antiderivatives antiderivatives(double q, double s) {
    const double q2 = q * q, s2 = s * s, root = std::sqrt(std::max(0.0, s2 - q2));
    return {-root, 0.5 * (s2 * std::asin(std::min(1.0, q / s)) - q * root), -root * (2.0 * s2 + q2) / 3.0,
            -root * (8.0 * s2 * s2 + 4.0 * s2 * q2 + 3.0 * q2 * q2) / 15.0};
}

class CutIntegrals {
public:
    explicit CutIntegrals(const Band& band) : band_(band) {}

    /// Adds −2 C1D'(s) K_n(s) ds.
    void add(const LinePiece& piece, double s, double ds) {
        const auto lower = antiderivatives(band_.lower, s), upper = antiderivatives(std::min(s, band_.upper), s);
        const double weight = -2.0 * piece.exponent * piece.level * std::pow(s / piece.left, piece.exponent) / s * ds;
        moments_.first += weight * (upper.first - lower.first);
        moments_.second += weight * (upper.second - lower.second);
        moments_.third += weight * (upper.third - lower.third);
        moments_.fifth += weight * (upper.fifth - lower.fifth);
    }

    /// From one wavevector to another within a piece. K behaves like a root above either end of the band; s = from +
    /// (to − from) t² makes it smooth.
    void add_finite(const LinePiece& piece, double from, double to) {
        using Rule = boost::math::quadrature::gauss<double, 10>;
        constexpr double widest = 1.6;  // a fifth of a decade
        const auto parts = static_cast<Index>(std::ceil(std::log(to / from) / std::log(widest)));
        const double growth = std::pow(to / from, 1.0 / static_cast<double>(parts));
        for (Index i = 0; i < parts; ++i) {
            const double left = from * std::pow(growth, static_cast<double>(i)), width = left * (growth - 1.0);
            for_each_node<Rule>(
                [&](double t, double weight) { add(piece, left + width * t * t, 2.0 * width * t * weight); });
        }
    }

    /// To infinity: s = from/v, v = 1 − t².
    void add_tail(const LinePiece& piece, double from) {
        using Rule = boost::math::quadrature::gauss<double, 30>;
        for_each_node<Rule>([&](double t, double weight) {
            const double v = 1.0 - t * t;
            add(piece, from / v, from / (v * v) * 2.0 * t * weight);
        });
    }

    /// For C1D that drops to zero at the end of a piece.
    void add_drop(const LinePiece& last) {
        const double s = last.right, level = last.level * std::pow(s / last.left, last.exponent);
        const auto lower = antiderivatives(band_.lower, s), upper = antiderivatives(std::min(s, band_.upper), s);
        moments_.first += 2.0 * level * (upper.first - lower.first);
        moments_.second += 2.0 * level * (upper.second - lower.second);
        moments_.third += 2.0 * level * (upper.third - lower.third);
        moments_.fifth += 2.0 * level * (upper.fifth - lower.fifth);
    }

    [[nodiscard]] const CutMoments& moments() const { return moments_; }

private:
    /// Nodes and weights on 0 … 1.
    template <class Rule, class Function>
    static void for_each_node(Function function) {
        for (std::size_t i = 0; i < Rule::abscissa().size(); ++i)
            for (const double sign : {-1.0, 1.0}) {
                if (Rule::abscissa()[i] == 0.0 && sign > 0.0) continue;
                function(0.5 + 0.5 * sign * Rule::abscissa()[i], 0.5 * Rule::weights()[i]);
            }
    }

    Band band_;
    CutMoments moments_;
};

}  // namespace

CutMoments cut_moments(std::span<const LinePiece> pieces, const Band& band) {
    CutIntegrals sum(band);
    for (const auto& piece : pieces) {
        double from = std::max(piece.left, band.lower);
        if (from >= piece.right) continue;
        if (from < band.upper && band.upper < piece.right) {
            sum.add_finite(piece, from, band.upper);
            from = band.upper;
        }
        if (std::isinf(piece.right)) sum.add_tail(piece, from);
        else sum.add_finite(piece, from, piece.right);
    }
    if (!pieces.empty() && std::isfinite(pieces.back().right)) sum.add_drop(pieces.back());
    return sum.moments();
}

}  // namespace setae::roughness
