// SPDX-License-Identifier: GPL-3.0-or-later
// W_ret along the retraction: loops whose works are known, energies by the trapezoidal rule over force and depth.
#include "setae/loops/work_along_retraction.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"
#include "setae/loops/analysis.hpp"
#include "setae/loops/spring_jumps.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::work_along_retraction_test {
namespace {

using tests::detail::Series;

/// A lens under fixed grips whose W_ret is a straight line in the contact radius.
struct VaryingLoop {
    double radius = 1.25e-3, modulus = 0.92e6, work_approach = 0.040;
    double largest_radius = 1.2e-4, at_largest = 0.085, slope = 400.0;  ///< [J/m³]
    int samples = 400;

    [[nodiscard]] double work(double a) const { return at_largest - slope * (largest_radius - a); }
    [[nodiscard]] contact::jkr::Contact at(double a) const { return {radius, modulus, work(a)}; }

    [[nodiscard]] Loop make() const {
        using namespace contact::jkr;
        const contact::jkr::Contact approach{radius, modulus, work_approach};
        Series series;
        tests::detail::add_free_flight(series, -3e-6, 0.0, samples);
        tests::detail::add_branch(series, approach, jump_in_at_fixed_grips(approach).contact_radius, largest_radius,
                                  samples, false);
        const double high = series.displacement.back(), low = displacement(largest_radius, at(largest_radius));
        for (int i = 1; i < samples; ++i) {
            const double d = high + (low - high) * i / samples;
            series.add(force_at(largest_radius, d, {radius, modulus}), d, largest_radius);
        }
        double a = largest_radius, depth = displacement(a, at(a));
        const double step = largest_radius / (2.0 * samples);
        while (true) {
            series.add(force(a, at(a)), depth, a);
            const double next = displacement(a - step, at(a - step));
            if (!(next < depth)) break;
            a -= step;
            depth = next;
        }
        tests::detail::add_free_flight(series, depth, -3e-6, samples);
        const auto n = static_cast<Index>(series.force.size());
        return {.time = Array1D::LinSpaced(n, 0.0, 0.1 * static_cast<double>(n - 1)),
                .force = Series::array(series.force),
                .displacement = Series::array(series.displacement),
                .contact_radius = Series::array(series.radius)};
    }
};

double trapezoid(const Loop& loop) {
    double sum = 0.0;
    for (Index i = 1; i < loop.force.size(); ++i)
        sum += 0.5 * (loop.force[i] + loop.force[i - 1]) * (loop.displacement[i] - loop.displacement[i - 1]);
    return sum;
}

Loop noisy(Loop loop, unsigned seed, double force = 2e-7, double displacement = 5e-9, double radius = 3e-7) {
    std::mt19937_64 generator(seed);
    loop.force = tests::with_noise(loop.force, force, generator);
    loop.displacement = tests::with_noise(loop.displacement, displacement, generator);
    const Array1D seen = tests::with_noise(loop.contact_radius, radius, generator);
    for (Index i = 0; i < seen.size(); ++i)
        if (loop.contact_radius[i] > 0.0) loop.contact_radius[i] = seen[i];
    return loop;
}

const WorkAlongRetraction& course_of(const LoopAnalysis& analysis) {
    if (!analysis.work_along_retraction) throw std::runtime_error(analysis.work_along_retraction.reason);
    return *analysis.work_along_retraction;
}

TEST(WorkAlongRetraction, OfAConstantWorkHasNoSlope) {
    const tests::SyntheticLoop constant{.retraction_work = 0.080};
    const auto exact = analyse(constant.make(), tests::rubber_on_diamond());
    EXPECT_NEAR(course_of(exact).slope.value, 0.0, 1e-3 * 0.080 / 1.2e-4);
    EXPECT_NEAR(course_of(exact).at_pull_off.value, 0.080, 1e-4);
    EXPECT_NEAR(course_of(exact).energy_loss.value / constant.loss(), 1.0, 2e-3);
    double squares = 0.0;
    constexpr int loops = 12;
    for (unsigned seed = 1; seed <= loops; ++seed) {
        const auto found = course_of(analyse(noisy(constant.make(), seed), tests::rubber_on_diamond()));
        EXPECT_LT(std::abs(found.slope.value), 4.0 * found.slope.standard_error) << seed;
        squares += std::pow(found.slope.value / found.slope.standard_error, 2);
    }
    EXPECT_LT(squares, 26.2);  // χ² of 12, 1 %
    EXPECT_GT(squares, 3.1);   // 0.5 %
}

TEST(WorkAlongRetraction, RecoversTheTrueSlopeWithinItsError) {
    const VaryingLoop known;
    const auto exact = course_of(analyse(known.make(), tests::rubber_on_diamond()));
    EXPECT_NEAR(exact.slope.value / known.slope, 1.0, 0.01);
    EXPECT_NEAR(exact.at_largest_contact.value, known.at_largest, 2e-4);
    double squares = 0.0;
    constexpr int loops = 12;
    for (unsigned seed = 1; seed <= loops; ++seed) {
        const auto found = course_of(analyse(noisy(known.make(), seed), tests::rubber_on_diamond()));
        EXPECT_GT(found.slope.value, 5.0 * found.slope.standard_error);
        squares += std::pow((found.slope.value - known.slope) / found.slope.standard_error, 2);
    }
    EXPECT_LT(squares, 26.2);
}

TEST(WorkAlongRetraction, LossMatchesTheLoop) {
    for (const double slope : {-200.0, 0.0, 400.0}) {
        VaryingLoop known{.slope = slope};
        if (slope < 0.0) known.at_largest = 0.070;
        const auto loop = known.make();
        const auto analysis = analyse(loop, tests::rubber_on_diamond());
        const auto& found = course_of(analysis);
        const double integral = trapezoid(loop);
        EXPECT_NEAR(found.energy_loss.value / integral, 1.0, 5e-3) << slope;
        EXPECT_NEAR(analysis.loop->energy / integral, 1.0, 1e-3) << slope;
        // W_ret at pull-off, which is read where the force is smallest, during the whole retraction: Maugis' jumps
        const double at_pull_off = found.at_pull_off.value,
                     approach = analysis.loading.primary().work_of_adhesion.value,
                     modulus = analysis.loading.primary().contact_modulus.value, k = analysis.budget->machine_stiffness;
        const double constant = spring_jumps({known.radius, modulus, approach}, k).jump_in_loss +
                                (at_pull_off - approach) * pi * std::pow(found.largest_radius, 2) +
                                spring_jumps({known.radius, modulus, at_pull_off}, k).jump_out_loss;
        EXPECT_NEAR(found.energy_loss_constant.value / constant, 1.0, 1e-5) << slope;
        if (slope != 0.0) {
            EXPECT_GT(std::abs(constant / integral - 1.0), 0.01) << slope;
        }
    }
}

// fixed grips, W_app in and W_ret out: 3/5 πW a0² + (W_ret − W_app) π a_max² + 2/5 πW_ret a_c² (Maugis)
TEST(WorkAlongRetraction, OfAConstantWorkHasTheClosedFormLoss) {
    const tests::SyntheticLoop constant{.retraction_work = 0.080};
    const auto lens = constant.retraction();
    constexpr int n = 50;
    BranchData data;
    data.contact_radius = Array1D::LinSpaced(n, constant.largest_radius, 0.5 * constant.largest_radius);
    data.force.resize(n);
    for (Index i = 0; i < n; ++i) data.force[i] = contact::jkr::force(data.contact_radius[i], lens);
    const auto found = fit_work_along_retraction(data, {.radius = lens.radius,
                                                        .contact_modulus = {lens.contact_modulus, 0.0},
                                                        .work_approach = {0.040, 0.0},
                                                        .largest_contact_radius = constant.largest_radius});
    EXPECT_NEAR(found.energy_loss.value / constant.loss(), 1.0, 1e-6);
    EXPECT_NEAR(found.energy_loss_constant.value / constant.loss(), 1.0, 1e-6);
}

TEST(WorkAlongRetraction, IsUndeterminedFromThePullOffOnly) {
    auto loop = tests::SyntheticLoop{.retraction_work = 0.080}.make();
    loop.contact_radius = Array1D();
    const auto analysis = analyse(loop, tests::rubber_on_diamond());
    EXPECT_FALSE(analysis.work_along_retraction);
    EXPECT_NE(analysis.work_along_retraction.reason.find("undetermined"), std::string::npos)
        << analysis.work_along_retraction.reason;
}

TEST(WorkAlongRetraction, RefusesInvalidInput) {
    BranchData data{.force = Array1D::Constant(10, -1e-4), .contact_radius = Array1D::Constant(10, 1e-4)};
    const RetractionCourse course{.radius = 1e-3, .contact_modulus = {1e6, 0.0}, .largest_contact_radius = 1e-4};
    EXPECT_THROW((void)fit_work_along_retraction(data, course), UndefinedDataError);
    EXPECT_THROW((void)fit_work_along_retraction(data, {.radius = 1e-3}), InvalidArgument);
}

}  // namespace
}  // namespace setae::loops::work_along_retraction_test
