// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/shared_inputs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <string>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::shared_inputs_test {
namespace {

using tests::SyntheticLoop;

/// A record with what it is analysed by.
struct Case {
    Loop loop;
    LensAndCounterBody bodies = tests::rubber_on_diamond();
    AnalysisOptions options;

    [[nodiscard]] LoopAnalysis analysis() const { return analyse(loop, bodies, options); }
    [[nodiscard]] double derivative(SharedInput input, double (*number)(const ContactAnalysis&)) const {
        const auto found = analysis();
        return InputDerivative(loop, bodies, options, found, input).of(number);
    }
    /// ∂ln y/∂ln x.
    [[nodiscard]] double exponent(SharedInput input, double (*number)(const ContactAnalysis&)) const {
        return derivative(input, number) * value(input) / number(analysis());
    }
    [[nodiscard]] double value(SharedInput input) const {
        switch (input) {
            case SharedInput::sphere_radius: return bodies.radius;
            case SharedInput::sphere_height: return *bodies.lens_height;
            case SharedInput::poisson_ratio: return bodies.lens_poisson_ratio;
            case SharedInput::machine_stiffness: return *options.machine_stiffness;
            default: return 1.0;
        }
    }
    [[nodiscard]] Case with(SharedInput input, double value) const {
        Case changed = *this;
        switch (input) {
            case SharedInput::sphere_radius: changed.bodies.radius = value; break;
            case SharedInput::sphere_height: changed.bodies.lens_height = value; break;
            case SharedInput::poisson_ratio: changed.bodies.lens_poisson_ratio = value; break;
            case SharedInput::machine_stiffness: changed.options.machine_stiffness = value; break;
            case SharedInput::force_calibration: changed.loop.force *= value; break;
            case SharedInput::displacement_calibration: changed.loop.displacement *= value; break;
            case SharedInput::contact_radius_calibration: changed.loop.contact_radius *= value; break;
        }
        return changed;
    }
};

double contact_modulus(const ContactAnalysis& a) { return a.loading.primary().contact_modulus.value; }
double youngs_modulus(const ContactAnalysis& a) { return a.loading.primary().youngs_modulus.value; }
double approach(const ContactAnalysis& a) { return a.loading.primary().work_of_adhesion.value; }
double pull_off(const ContactAnalysis& a) { return a.pull_off->work_of_adhesion.value; }
double retraction(const ContactAnalysis& a) { return a.retraction->work_of_adhesion.value; }
double loss(const ContactAnalysis& a) { return a.loop->energy; }

const std::map<std::string, double (*)(const ContactAnalysis&)> numbers{{"E*", contact_modulus}, {"E", youngs_modulus},
                                                                        {"W_app", approach},     {"W_po", pull_off},
                                                                        {"W_ret", retraction},   {"E_loss", loss}};

Loop exact_loop() { return SyntheticLoop{.retraction_work = 0.060, .samples = 120}.make(); }

Loop noisy_loop() {
    std::mt19937_64 generator(7);
    Loop loop = exact_loop();
    loop.force = tests::with_noise(loop.force, 2e-7, generator);
    loop.displacement = tests::with_noise(loop.displacement, 1e-9, generator);
    const Array1D radius = tests::with_noise(loop.contact_radius, 1e-7, generator);
    loop.contact_radius = (loop.contact_radius > 0.0).select(radius, 0.0);
    return loop;
}

Loop without_radius(Loop loop) {
    loop.contact_radius = Array1D();
    return loop;
}

/// The stage's record of a machine of stiffness k, where the loop has the contact's own displacement.
Loop behind_a_spring(Loop loop, double stiffness) {
    loop.displacement += loop.force / stiffness;
    return loop;
}

using enum SharedInput;

TEST(InputDerivative, FollowsJkrScalingWithMeasuredRadii) {
    for (const auto& loop : {exact_loop(), noisy_loop()}) {
        const Case c{.loop = loop};
        constexpr double rounding = 1e-5;
        EXPECT_NEAR(c.exponent(sphere_radius, contact_modulus), 1.0, rounding);
        EXPECT_NEAR(c.exponent(force_calibration, contact_modulus), 1.0, rounding);
        EXPECT_NEAR(c.exponent(contact_radius_calibration, contact_modulus), -3.0, rounding);
        EXPECT_NEAR(c.exponent(displacement_calibration, contact_modulus), 0.0, rounding);
        for (const auto& work : {approach, pull_off, retraction}) {
            EXPECT_NEAR(c.exponent(sphere_radius, work), -1.0, rounding);
            EXPECT_NEAR(c.exponent(force_calibration, work), 1.0, rounding);
            EXPECT_NEAR(c.exponent(contact_radius_calibration, work), 0.0, rounding);
            EXPECT_NEAR(c.exponent(displacement_calibration, work), 0.0, rounding);
        }
    }
}

TEST(InputDerivative, FollowsJkrScalingFromForceAndDisplacement) {
    for (const auto& loop : {exact_loop(), noisy_loop()}) {
        const Case c{.loop = without_radius(loop)};
        constexpr double rounding = 1e-5;
        EXPECT_NEAR(c.exponent(sphere_radius, contact_modulus), -0.5, rounding);
        EXPECT_NEAR(c.exponent(force_calibration, contact_modulus), 1.0, rounding);
        EXPECT_NEAR(c.exponent(displacement_calibration, contact_modulus), -1.5, rounding);
        for (const auto& work : {approach, pull_off, retraction}) {
            EXPECT_NEAR(c.exponent(sphere_radius, work), -1.0, rounding);
            EXPECT_NEAR(c.exponent(force_calibration, work), 1.0, rounding);
            EXPECT_NEAR(c.exponent(displacement_calibration, work), 0.0, rounding);
        }
    }
}

TEST(InputDerivative, OfTheLossFollowsForceTimesDisplacement) {
    const Case c{.loop = noisy_loop()};
    EXPECT_NEAR(c.exponent(force_calibration, loss), 1.0, 1e-6);
    EXPECT_NEAR(c.exponent(displacement_calibration, loss), 1.0, 1e-6);
    for (const auto input : {sphere_radius, contact_radius_calibration, poisson_ratio})
        EXPECT_EQ(c.derivative(input, loss), 0.0);
    // what a spring takes it gives back
    Case spring{.loop = behind_a_spring(exact_loop(), 500.0)};
    spring.options.machine_stiffness = 500.0;
    EXPECT_NEAR(spring.exponent(machine_stiffness, loss), 0.0, 1e-3);
}

// A height goes with the contact radius, else with √(Rδ); a machine stiffness with F/δ: sums of exponents are known.
TEST(InputDerivative, ExponentsHaveTheirSumWithHeightAndMachineStiffness) {
    constexpr double rounding = 2e-5;
    Case measured{.loop = noisy_loop()};
    measured.bodies.lens_height = 0.6e-3;
    const auto sum = [](const Case& c, auto number, std::map<SharedInput, double> shares) {
        double total = 0.0;
        for (const auto& [input, share] : shares) total += share * c.exponent(input, number);
        return total;
    };
    EXPECT_NEAR(sum(measured, contact_modulus, {{contact_radius_calibration, 1.0}, {sphere_height, 1.0}}), -3.0,
                rounding);
    EXPECT_NEAR(sum(measured, approach, {{contact_radius_calibration, 1.0}, {sphere_height, 1.0}}), 0.0, rounding);
    Case implied{.loop = without_radius(behind_a_spring(noisy_loop(), 800.0))};
    implied.bodies.lens_height = 0.6e-3;
    implied.options.machine_stiffness = 800.0;
    EXPECT_GT(std::abs(implied.exponent(sphere_height, contact_modulus)), 0.05);
    EXPECT_GT(std::abs(implied.exponent(machine_stiffness, contact_modulus)), 0.05);
    EXPECT_NEAR(sum(implied, contact_modulus, {{sphere_radius, 1.0}, {sphere_height, 0.5}}), -0.5, rounding);
    EXPECT_NEAR(sum(implied, contact_modulus, {{force_calibration, 1.0}, {machine_stiffness, 1.0}}), 1.0, rounding);
    EXPECT_NEAR(sum(implied, contact_modulus,
                    {{displacement_calibration, 1.0}, {machine_stiffness, -1.0}, {sphere_height, 0.5}}),
                -1.5, rounding);
    EXPECT_NEAR(sum(implied, approach, {{sphere_radius, 1.0}, {sphere_height, 0.5}}), -1.0, rounding);
    EXPECT_NEAR(sum(implied, approach, {{force_calibration, 1.0}, {machine_stiffness, 1.0}}), 1.0, rounding);
}

/// A central difference of the whole analysis, nothing held.
class WholeDifference {
public:
    WholeDifference(const Case& c, SharedInput input)
        : above_(c.with(input, c.value(input) * (1.0 + step)).analysis()),
          below_(c.with(input, c.value(input) * (1.0 - step)).analysis()),
          between_(2.0 * step * c.value(input)) {}

    [[nodiscard]] double of(double (*number)(const ContactAnalysis&)) const {
        return (number(above_) - number(below_)) / between_;
    }

private:
    static constexpr double step = 2e-3;
    LoopAnalysis above_, below_;
    double between_;
};

void expect_whole_differences(const Case& c, const std::vector<SharedInput>& inputs, const char* which) {
    const auto analysis = c.analysis();
    for (const auto input : inputs) {
        const InputDerivative derivative(c.loop, c.bodies, c.options, analysis, input);
        const WholeDifference whole(c, input);
        for (const auto& [name, number] : numbers) {
            const double scale = std::abs(number(analysis) / c.value(input));
            EXPECT_NEAR(derivative.of(number), whole.of(number), 1e-4 * scale)
                << which << ": " << name << " by " << shared_input_name(input);
        }
    }
}

TEST(InputDerivative, MatchesDifferencesOfTheWholeAnalysis) {
    Case measured{.loop = noisy_loop()};
    measured.bodies.lens_poisson_ratio = 0.45;
    expect_whole_differences(
        measured,
        {sphere_radius, poisson_ratio, force_calibration, displacement_calibration, contact_radius_calibration},
        "measured radii");
    measured.bodies.lens_height = 0.6e-3;
    expect_whole_differences(
        measured, {sphere_radius, sphere_height, poisson_ratio, contact_radius_calibration, displacement_calibration},
        "measured radii, finite height");
    Case implied{.loop = without_radius(behind_a_spring(noisy_loop(), 800.0))};
    implied.bodies.lens_poisson_ratio = 0.45;
    implied.options.machine_stiffness = 800.0;
    expect_whole_differences(
        implied, {sphere_radius, poisson_ratio, machine_stiffness, force_calibration, displacement_calibration},
        "force and displacement");
    implied.bodies.lens_height = 0.6e-3;
    expect_whole_differences(implied, {sphere_radius, sphere_height, poisson_ratio, machine_stiffness},
                             "force and displacement, finite height");
}

// E = E*(1 − ν²)/(1 − E*(1 − ν2²)/E2): exact at ν = 1/2, beyond which there is no analysis.
TEST(InputDerivative, OfAnIncompressibleSolidIsOneSided) {
    const Case c{.loop = exact_loop()};
    const double E = youngs_modulus(c.analysis());
    EXPECT_NEAR(c.derivative(poisson_ratio, youngs_modulus) / (-2.0 * 0.5 / 0.75 * E), 1.0, 1e-6);
    EXPECT_EQ(c.derivative(poisson_ratio, contact_modulus), 0.0);
    Case cork = c;
    cork.bodies.lens_poisson_ratio = 0.0;
    EXPECT_NEAR(cork.derivative(poisson_ratio, youngs_modulus) / youngs_modulus(cork.analysis()), 0.0, 1e-6);
}

// The contact point was read off the same record: with it held, W does not move with the displacement's scale.
TEST(InputDerivative, ScalesAGivenContactPoint) {
    Case c{.loop = without_radius(exact_loop())};
    c.loop.displacement += 40e-6;
    c.options.contact_point = {.mode = ContactPointChoice::Mode::value, .value = 40e-6};
    EXPECT_NEAR(c.exponent(displacement_calibration, approach), 0.0, 1e-5);
    EXPECT_NEAR(c.exponent(displacement_calibration, contact_modulus), -1.5, 1e-5);
}

TEST(InputDerivative, RefusesAnInputTheLoopLacks) {
    const Case c{.loop = exact_loop()};
    EXPECT_THROW((void)c.derivative(sphere_height, approach), InvalidArgument);
    EXPECT_THROW((void)c.derivative(machine_stiffness, approach), InvalidArgument);
}

TEST(AddInputError, AddsTheRadiusToEveryRouteOnce) {
    const Case c{.loop = noisy_loop()};
    const auto own = c.analysis();
    auto all = own;
    constexpr double share = 0.01;
    add_input_error(all, c.bodies, InputDerivative(c.loop, c.bodies, c.options, own, sphere_radius),
                    share * c.bodies.radius);
    const auto expect_added = [&](const Estimate& with, const Estimate& without, double exponent) {
        EXPECT_EQ(with.value, without.value);
        EXPECT_NEAR(with.standard_error / std::hypot(without.standard_error, share * exponent * with.value), 1.0, 1e-5);
    };
    for (const auto route : {&BranchAnalysis::radius_force, &BranchAnalysis::radius_force_effective_variance}) {
        const auto &with = *(all.loading.*route), &without = *(own.loading.*route);
        expect_added(with.contact_modulus, without.contact_modulus, 1.0);
        expect_added(with.work_of_adhesion, without.work_of_adhesion, -1.0);
        // E* ∝ R and W ∝ 1/R: what both share is all but all there is
        EXPECT_LT(with.correlation, -0.9);
    }
    expect_added(all.loading.force_displacement->contact_modulus, own.loading.force_displacement->contact_modulus,
                 -0.5);
    expect_added(all.pull_off->work_of_adhesion, own.pull_off->work_of_adhesion, -1.0);
    expect_added(all.retraction->work_of_adhesion, own.retraction->work_of_adhesion, -1.0);
    EXPECT_EQ(all.loop->estimate().standard_error, own.loop->estimate().standard_error);
}

}  // namespace
}  // namespace setae::loops::shared_inputs_test
