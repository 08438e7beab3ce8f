// SPDX-License-Identifier: GPL-3.0-or-later
// Origins and digits: README.md beside this file.
#include <gtest/gtest.h>

#include <cmath>

#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/loops/loop_energy.hpp"

namespace setae::loops::ideal_loop_test {
namespace {

constexpr contact::jkr::Contact unit{.radius = 1.0, .contact_modulus = 0.75, .work_of_adhesion = 1.0 / pi};
constexpr double loss = 1.2749410291;

enum class Steps { even_in_radius, even_in_displacement };

/// Approach, jump at δ = 0, loading to a = 2, retraction to the fixed-grip pull-off, jump; n steps each way, both ends
/// of each jump sampled.
Loop sampled(Index n, Steps steps) {
    const contact::jkr::State in = contact::jkr::jump_in_at_fixed_grips(unit);
    const contact::jkr::State out = contact::jkr::pull_off_at_fixed_grips(unit);
    constexpr double far = -2.0, largest = 2.0;
    const auto branch = [&](double from, double to) -> Array1D {
        if (steps == Steps::even_in_radius) return Array1D::LinSpaced(n, from, to);
        const Array1D displacement =
            Array1D::LinSpaced(n, contact::jkr::displacement(from, unit), contact::jkr::displacement(to, unit));
        Array1D radius = contact::jkr::contact_radius_at_displacement(displacement, unit);
        radius[0] = from;  // the folds lie within rounding of the displacement
        radius[n - 1] = to;
        return radius;
    };
    Array1D radius(2 * n);
    radius << branch(in.contact_radius, largest), branch(largest, out.contact_radius);
    Loop loop{.force = Array1D::Zero(4 * n), .displacement = Array1D(4 * n)};
    loop.displacement.head(n).setLinSpaced(n, far, 0.0);
    for (Index i = 0; i < radius.size(); ++i) {
        loop.force[n + i] = contact::jkr::force(radius[i], unit);
        loop.displacement[n + i] = contact::jkr::displacement(radius[i], unit);
    }
    loop.displacement.tail(n).setLinSpaced(n, out.displacement, far);
    return loop;
}

double energy(Index n, Steps steps) {
    const Loop loop = sampled(n, steps);
    return loop_energy(loop, find_segments(loop)).energy;
}

TEST(IdealLoop, LosesTheTabulatedEnergy) { EXPECT_NEAR(energy(40000, Steps::even_in_radius), loss, 1e-8); }

TEST(IdealLoop, ConvergesWithSecondOrderForEqualStepsInRadius) {
    const double coarse = energy(200, Steps::even_in_radius) - loss;
    const double fine = energy(399, Steps::even_in_radius) - loss;
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.01);
}

TEST(IdealLoop, ConvergesWithOrderThreeHalvesInDisplacement) {
    const double coarse = energy(6400, Steps::even_in_displacement) - loss;
    const double fine = energy(12799, Steps::even_in_displacement) - loss;
    EXPECT_NEAR(std::log2(coarse / fine), 1.5, 0.05);
}

}  // namespace
}  // namespace setae::loops::ideal_loop_test
