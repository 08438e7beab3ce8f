// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/model_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace setae::loops::model_curve_test {
namespace {

void expect_slope(double slope, double above, double below, double step, double scale, const std::string& what) {
    // central differences err by the step squared, 1e-8 of the value and its curvature
    EXPECT_NEAR(slope, (above - below) / (2.0 * step), 1e-6 * scale / step * 1e-3) << what;
}

TEST(ModelCurve, DerivativesMatchTheCurve) {
    LensAndCounterBody bodies{.radius = 1.25e-3, .counter_youngs_modulus = 1e12};
    bodies.layer_thickness = 30e-6;
    for (const ContactModel model : contact_models())
        for (const bool stress_given : {false, true}) {
            if (stress_given && model != ContactModel::maugis_dugdale) continue;
            const ModelCurve curve(model, bodies, stress_given);
            CurveParameters at(std::log(0.9e6), curve.work_slot(0.04), std::log(stress_given ? 1e5 : 0.8));
            if (model == ContactModel::transition) at = {std::log(6e-5), std::log(2.5e-4), 0.4};
            const double t = 5e-5;
            const CurvePoint point = curve.at(t, at);
            const auto scale = [](double value) { return std::abs(value) + 1e-12; };
            const std::string what = to_string(model) + (stress_given ? " with σ0" : "");
            const double dt = 1e-4 * t;
            const CurvePoint right = curve.at(t + dt, at), left = curve.at(t - dt, at);
            expect_slope(point.force_slope * t, right.force, left.force, 1e-4, scale(4e-4), what + " F'");
            expect_slope(point.displacement_slope * t, right.displacement, left.displacement, 1e-4, scale(4e-6),
                         what + " δ'");
            for (int slot = 0; slot < curve.parameters(); ++slot) {
                const double step = 1e-4 * std::max(0.01, std::abs(at[slot]) / 10.0);
                CurveParameters more = at, less = at;
                more[slot] += step;
                less[slot] -= step;
                const CurvePoint above = curve.at(t, more), below = curve.at(t, less);
                const auto k = static_cast<std::size_t>(slot);
                expect_slope(point.force_by[k], above.force, below.force, step, scale(4e-4),
                             what + " F by " + std::to_string(slot));
                expect_slope(point.displacement_by[k], above.displacement, below.displacement, step, scale(4e-6),
                             what + " δ by " + std::to_string(slot));
            }
        }
}

}  // namespace
}  // namespace setae::loops::model_curve_test
