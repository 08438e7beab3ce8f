// SPDX-License-Identifier: GPL-3.0-or-later
// The straight edge of a contact that opens and closes under a mean gap, between flat bodies.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/half_space/adhesive_cell.hpp"

namespace setae::half_space::straight_front_test {
namespace {

constexpr Index points = 256;
constexpr double period = points, modulus = 1.0, work = 1.0;  // units: a pixel, E*, w

/// An open strip of half-width c in every period: tension and mean gap at G = w.
///
///   G = T² L tan(πc/L)/2E*,   ⟨g⟩ = 2TL/(πE*) ln sec(πc/L)
///
/// Source: collinear cracks, Westergaard, J. Appl. Mech. 6 (1939) 49; one of the faces is rigid.
struct OpenStrip {
    explicit OpenStrip(double half_width) {
        const double x = pi * half_width / period;
        tension = std::sqrt(2.0 * modulus * work / (period * std::tan(x)));
        mean_gap = 2.0 * tension * period / (pi * modulus) * std::log(1.0 / std::cos(x));
    }
    double tension, mean_gap;
};

/// G of the strip that has this tension at this mean gap.
double energy_release_rate(const AdhesiveState& state) {
    const double x = std::acos(std::exp(-state.mean_gap * pi * modulus / (2.0 * state.tension * period)));
    return state.tension * state.tension * period * std::tan(x) / (2.0 * modulus);
}

/// Opened and closed once more between two mean gaps.
struct Cycle {
    double loss = 0.0;             ///< W_open − W_close, an area that opens and closes
    double opens = 0.0;            ///< the greatest G on opening
    double closes = 1e300;         ///< the least on closing
    double min_dissipation = 0.0;  ///< of a step
};

class Front {
public:
    explicit Front(double squared_ratio)
        : cell_(Array2D::Zero(points, 1), {points, 1, period, 1.0}, {.contact_modulus = modulus, .layer = {}},
                {work, std::sqrt(work / (modulus * squared_ratio))}, {.tolerance = 1e-7, .max_iterations = 2000}, {1}) {
        const double c = 0.12 * period, tension = OpenStrip(c).tension;
        cell_.begin_with(Array2D::NullaryExpr(points, 1, [&](Index i, Index) {
            const double x = static_cast<double>(i) + 0.5 - 0.5 * period;
            return 2.0 * tension / modulus * std::sqrt(std::max(0.0, c * c - x * x));
        }));
        state_ = cell_.solve(HeldGap{OpenStrip(c).mean_gap});
    }

    Cycle cycle() {
        const double narrow = OpenStrip(0.14 * period).mean_gap, wide = OpenStrip(0.2 * period).mean_gap;
        (void)move_to(narrow), (void)move_to(wide);
        Cycle cycle;
        const double touched = state_.area_fraction;
        double dissipated = move_to(narrow, [&](double G) { cycle.closes = std::min(cycle.closes, G); });
        const double swept = state_.area_fraction - touched;
        dissipated += move_to(wide, [&](double G) { cycle.opens = std::max(cycle.opens, G); });
        cycle.loss = dissipated / swept;
        cycle.min_dissipation = least_;
        return cycle;
    }

private:
    template <class Visit>
    double move_to(double mean_gap, const Visit& visit) {
        const double step = 0.005;
        double dissipated = 0.0;
        while (state_.mean_gap != mean_gap) {
            const double next = std::clamp(mean_gap, state_.mean_gap - step, state_.mean_gap + step);
            (void)cell_.find_tangent();
            cell_.follow_tangent(next - state_.mean_gap);
            const auto now = cell_.solve(HeldGap{next});
            EXPECT_TRUE(now.converged) << next;
            const double lost =
                0.5 * (state_.tension + now.tension) * (next - state_.mean_gap) - (now.energy() - state_.energy());
            least_ = std::min(least_, lost);
            dissipated += lost;
            state_ = now;
            visit(energy_release_rate(state_));
        }
        return dissipated;
    }
    double move_to(double mean_gap) {
        return move_to(mean_gap, [](double) {});
    }

    AdhesiveCell cell_;
    AdhesiveState state_;
    double least_ = 0.0;
};

// Griffith: the edge moves where G is w, by tension and mean gap alone. What pixels catch stands as much above w on
// opening as below on closing.
TEST(StraightFront, MovesAtTheWorkOfAdhesion) {
    const auto fine = Front(0.25).cycle();
    EXPECT_NEAR(0.5 * (fine.opens + fine.closes) / work, 1.0, 1e-2);
    EXPECT_LT(fine.opens - fine.closes, 0.02 * work);
    EXPECT_GT(fine.min_dissipation, -1e-6 * work);
}

// (W_open − W_close)/w by another program: 0.042 ± 0.01 at μ² = 0.64, 0.165 ± 0.02 at 1
TEST(StraightFront, IsPinnedByCoarsePixels) {
    const double fine = Front(0.25).cycle().loss, coarse = Front(0.64).cycle().loss, limit = Front(1.0).cycle().loss;
    EXPECT_LT(fine, 5e-3 * work);
    EXPECT_NEAR(coarse / work, 0.042, 0.01);
    EXPECT_NEAR(limit / work, 0.165, 0.02);
}

}  // namespace
}  // namespace setae::half_space::straight_front_test
