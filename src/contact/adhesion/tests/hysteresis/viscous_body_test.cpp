// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/hysteresis/viscous_body.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "setae/contact/jkr.hpp"
#include "setae/core/errors.hpp"

namespace setae::hysteresis::viscous_body_test {
namespace {

using contact::ContactHistory;
using contact::relaxation_force;
using contact::relaxation_loss;
using contact::RelaxationTerm;

constexpr double radius = 1.25e-3, modulus = 0.92e6;
constexpr HystereticSphere sphere{
    .radius = radius, .contact_modulus = modulus, .work_approach = 0.04, .work_retraction = 0.08};
constexpr Pressing pressing{.maximum_force = 1e-3};
constexpr Drive drive{.approach_speed = 60e-9, .retraction_speed = 60e-9, .hold_time = 30.0};

double relaxed_modulus(const std::vector<RelaxationTerm>& terms, double loading) {
    double shown = 1.0;
    for (const auto& term : terms) shown += term.share * term.time / loading * -std::expm1(-loading / term.time);
    return modulus / shown;
}

/// Every element by itself, on a grid.
Array1D by_elements(const ContactHistory& history, const std::vector<RelaxationTerm>& terms, int elements) {
    const double largest = history.contact_radius.maxCoeff(), width = largest / elements;
    const double relaxed = relaxed_modulus(terms, history.time[history.turn] - history.time[0]);
    Array1D force = Array1D::Zero(history.time.size());
    for (int e = 0; e < elements; ++e) {
        const double x = (e + 0.5) * width;
        std::vector<double> z(terms.size(), 0.0);
        bool touches = false;
        for (Index i = 0; i < force.size(); ++i) {
            const double u = history.displacement[i] - x * x / radius;
            if (history.contact_radius[i] < x) {
                touches = false;
                continue;
            }
            for (std::size_t k = 0; k < terms.size(); ++k) {
                if (!touches) continue;
                const double before = history.displacement[i - 1] - x * x / radius;
                const double step = (history.time[i] - history.time[i - 1]) / terms[k].time, decay = std::exp(-step);
                const double mean = -std::expm1(-step) / step;  // u is straight between samples
                z[k] = decay * z[k] + (mean - decay) * before + (1.0 - mean) * u;
            }
            touches = true;
            double stress = (relaxed - modulus) * u;
            for (std::size_t k = 0; k < terms.size(); ++k) stress += relaxed * terms[k].share * (u - z[k]);
            force[i] += 2.0 * stress * width;
        }
    }
    return force;
}

TEST(BulkRelaxation, EqualsTheSumOfSeparateElements) {
    const std::vector<RelaxationTerm> terms{{0.1, 5.0}, {0.05, 60.0}};
    for (const auto& edge : {std::optional<MovingEdge>{}, std::optional<MovingEdge>({{1e-6, 0.6}, 60e-9, 0.0})}) {
        const auto history = contact_history(sphere, pressing, drive, edge, 1000);
        const Array1D found = relaxation_force(history, radius, modulus, terms),
                      expected = by_elements(history, terms, 4000);
        EXPECT_LT((found - expected).abs().maxCoeff() / expected.abs().maxCoeff(), 5e-3);
        EXPECT_GT(expected.abs().maxCoeff(), 1e-5) << "there is something to compare";
    }
}

TEST(BulkRelaxation, OfAGrowingContactMatchesLeeAndRadok) {
    // without adhesion: F = 4/(3R) ∫ E(t − s) d(a³), here for a² ∝ t
    constexpr Index n = 2001;
    ContactHistory history{.time = Array1D::LinSpaced(n, 0.0, 100.0), .turn = n - 1};
    history.contact_radius = 1e-4 * (history.time / 100.0).sqrt();
    history.displacement = history.contact_radius.square() / radius;
    const std::vector<RelaxationTerm> terms{{0.3, 20.0}};
    const Array1D beside = relaxation_force(history, radius, modulus, terms);
    const double relaxed = relaxed_modulus(terms, 100.0);
    double integral = 0.0;
    for (Index i = 1; i < n; ++i) {
        const double age = 100.0 - 0.5 * (history.time[i] + history.time[i - 1]);
        integral += (1.0 + 0.3 * std::exp(-age / 20.0)) *
                    (std::pow(history.contact_radius[i], 3.0) - std::pow(history.contact_radius[i - 1], 3.0));
    }
    const double elastic = 4.0 * modulus * 1e-12 / (3.0 * radius);
    EXPECT_NEAR((elastic + beside[n - 1]) / (4.0 * relaxed / (3.0 * radius) * integral), 1.0, 1e-5);
}

TEST(BulkRelaxation, VanishesForLoadingAtAConstantRateOfVolume) {
    constexpr Index n = 4001;
    ContactHistory history{.time = Array1D::LinSpaced(n, 0.0, 50.0), .turn = n - 1};
    history.contact_radius = 1e-4 * (history.time / 50.0).pow(1.0 / 3.0);
    history.displacement = history.contact_radius.square() / radius;
    const Array1D beside = relaxation_force(history, radius, modulus, {{0.3, 20.0}, {0.1, 2.0}});
    EXPECT_NEAR(beside[n - 1] / (4.0 * modulus * 1e-12 / (3.0 * radius)), 0.0, 1e-5);
}

TEST(BulkRelaxation, OfAHeldContactDecaysWithTheRelaxationTime) {
    const auto history = contact_history(sphere, pressing, drive, {}, 1000);
    const Array1D force = relaxation_force(history, radius, modulus, {{0.1, 8.0}});
    Index held = history.turn;
    while (history.time[held] - history.time[history.turn] < drive.hold_time - 1e-9) ++held;
    const double a = history.contact_radius[held];
    const double sum = 2.0 * (a * history.displacement[held] - a * a * a / (3.0 * radius));
    const double relaxed = relaxed_modulus({{0.1, 8.0}}, history.time[history.turn]), rest = (relaxed - modulus) * sum;
    const double expected = rest + (force[history.turn] - rest) * std::exp(-drive.hold_time / 8.0);
    EXPECT_NEAR(force[held] / expected, 1.0, 1e-6);
}

TEST(BulkRelaxation, OfAPunchMatchesAMaxwellElement) {
    // a stays: F₁ = E∞ g 2a (δ − z) beside a constant; a ramp up and down of slope V loses E∞ g 2a times
    // ∫(δ − z) dδ = V²τ [T + …] in closed form
    constexpr Index n = 20001;
    constexpr double a = 1e-4, end = 40.0, speed = 50e-9, tau = 6.0, share = 0.2;
    ContactHistory history{.time = Array1D::LinSpaced(n, 0.0, 2.0 * end), .turn = 0};
    history.contact_radius = Array1D::Constant(n, a);
    history.displacement = speed * (end - (history.time - end).abs());
    const double relaxed = modulus / (1.0 + share);  // loading took no time
    const double x = end / tau, lag = -std::expm1(-x);
    // δ − z = Vτ(1 − e^(−t/τ)) going up; going down from lag Vτ to −Vτ(1 − e^(−s/τ)) + lag Vτ e^(−s/τ)
    const double up = speed * tau * (end - tau * lag);
    const double down = -speed * tau * (lag * tau * lag - (end - tau * lag));
    // the elements have touched since the jump to −x²/R at t = 0, which relaxes as they move
    const double shape = 2.0 * a * a * a / (3.0 * radius);
    const double jump = -shape * speed * tau * (lag - std::exp(-x) * lag);
    const double expected = relaxed * share * (2.0 * a * speed * (up + down) + jump);
    EXPECT_NEAR(relaxation_loss(history, radius, modulus, {{share, tau}}) / expected, 1.0, 1e-5);
}

TEST(BulkRelaxation, HasNoLossForVeryFastOrSlowRelaxation) {
    const auto history = contact_history(sphere, pressing, drive, {}, 400);
    const double loss = relaxation_loss(history, radius, modulus, {{0.1, 10.0}});
    EXPECT_GT(loss, 0.0);
    EXPECT_LT(std::abs(relaxation_loss(history, radius, modulus, {{0.1, 1e-3}})), 1e-3 * loss);
    EXPECT_LT(std::abs(relaxation_loss(history, radius, modulus, {{0.1, 1e7}})), 1e-3 * loss);
    EXPECT_EQ(relaxation_loss(history, radius, modulus, {}), 0.0);
}

TEST(BulkRelaxation, RefusesInvalidInput) {
    const auto history = contact_history(sphere, pressing, drive, {}, 20);
    EXPECT_THROW((void)relaxation_loss(history, radius, modulus, {{-0.1, 10.0}}), InvalidArgument);
    EXPECT_THROW((void)relaxation_loss(history, radius, modulus, {{0.1, 0.0}}), InvalidArgument);
    EXPECT_THROW((void)relaxation_loss(history, 0.0, modulus, {{0.1, 1.0}}), InvalidArgument);
    auto backwards = history;
    backwards.time = backwards.time.reverse().eval();
    EXPECT_THROW((void)relaxation_loss(backwards, radius, modulus, {{0.1, 1.0}}), InvalidArgument);
    EXPECT_THROW((void)contact_history(sphere, pressing, {.approach_speed = 0.0, .retraction_speed = 1e-9}),
                 InvalidArgument);
}

}  // namespace
}  // namespace setae::hysteresis::viscous_body_test
