// SPDX-License-Identifier: GPL-3.0-or-later
#include "finite_height.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "setae/contact/jkr.hpp"
#include "setae/contact/layer.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::finite_height_test {
namespace {

constexpr contact::AdhesiveContact lens{.radius = 1.25e-3, .contact_modulus = 0.92e6, .work_of_adhesion = 0.040};

/// A lens so high pressed to a contact radius and pulled off, in equilibrium under fixed grips, without noise.
Loop record_of(double height, double largest_radius, bool radius_measured) {
    const contact::layer::Layer layer(height, 0.5);
    const auto separation = contact::layer::pull_off_at_fixed_grips(lens, layer);
    const double jump_in = contact::layer::contact_radius_at_displacement(0.0, lens, layer);
    tests::detail::Series series;
    const auto branch = [&](double from, double to) {
        constexpr int samples = 400;
        for (int i = 0; i <= samples; ++i) {
            const double a = from + (to - from) * i / samples;
            series.add(contact::layer::force(a, lens, layer), contact::layer::displacement(a, lens, layer), a);
        }
    };
    const double far = 3.0 * separation.displacement;
    tests::detail::add_free_flight(series, far, 0.0, 300);
    branch(jump_in, largest_radius);
    branch(largest_radius, separation.contact_radius);
    tests::detail::add_free_flight(series, separation.displacement, far, 300);
    using tests::detail::Series;
    Loop loop{.force = Series::array(series.force),
              .displacement = Series::array(series.displacement),
              .contact_radius = Series::array(series.radius)};
    const Index n = loop.force.size();
    loop.time = Array1D::LinSpaced(n, 0.0, 0.1 * static_cast<double>(n - 1));
    if (!radius_measured) loop.contact_radius = Array1D();
    return loop;
}

LoopAnalysis analysed(const Loop& loop, std::optional<double> height) {
    LensAndCounterBody bodies{.radius = lens.radius, .counter_youngs_modulus = INFINITY};
    bodies.lens_height = height;
    return analyse(loop, bodies);
}

bool has_alert(const LoopAnalysis& analysis, const std::string& code, const std::string& words = "") {
    return std::any_of(analysis.alerts.begin(), analysis.alerts.end(), [&](const Alert& alert) {
        return alert.code == code && alert.message.find(words) != std::string::npos;
    });
}

TEST(FiniteHeight, EveryRouteRecoversALensOfKnownHeight) {
    for (const double height : {1.4e-3, 0.7e-3})
        for (const bool radius_measured : {true, false}) {
            const LoopAnalysis analysis = analysed(record_of(height, 1.37e-4, radius_measured), height);
            ASSERT_TRUE(analysis.unloading) << analysis.unloading.reason;
            for (const auto* branch : {&analysis.loading, &*analysis.unloading}) {
                // the last sample of unloading lies at the fold, on one side of it or the other
                const double within = branch == &analysis.loading ? 1e-6 : 1e-4;
                for (const auto* fit : {&branch->radius_force, &branch->linear_form, &branch->force_displacement}) {
                    if (!radius_measured && fit != &branch->force_displacement) continue;
                    ASSERT_TRUE(*fit) << fit->reason;
                    EXPECT_NEAR((*fit)->contact_modulus.value / 0.92e6, 1.0, within) << (*fit)->method << height;
                    EXPECT_NEAR((*fit)->work_of_adhesion.value / 0.040, 1.0, 10.0 * within) << (*fit)->method << height;
                }
                EXPECT_NEAR(branch->force_displacement->contact_point.value, 0.0, 1e-5 * within);
                if (radius_measured) {
                    EXPECT_NEAR(branch->pointwise->contact_modulus.value / 0.92e6, 1.0, within) << height;
                }
            }
        }
}

TEST(FiniteHeight, HalfSpaceAssumptionOverestimatesTheModulus) {
    // 12 % at a/h = 0.1 and 25 % at 0.19 from F–δ, some 0.1 % from a(F): why the height counts
    const auto excess = [](double height, bool radius_measured) {
        const LoopAnalysis analysis = analysed(record_of(height, 1.37e-4, radius_measured), std::nullopt);
        return radius_measured ? analysis.loading.radius_force->contact_modulus.value / 0.92e6 - 1.0
                               : analysis.loading.force_displacement->contact_modulus.value / 0.92e6 - 1.0;
    };
    EXPECT_NEAR(excess(1.37e-3, false), 0.12, 0.03);
    EXPECT_NEAR(excess(0.72e-3, false), 0.25, 0.05);
    EXPECT_LT(std::abs(excess(1.37e-3, true)), 0.002);
    EXPECT_LT(std::abs(excess(0.72e-3, true)), 0.006);
}

TEST(FiniteHeight, WarningsStateTheEffect) {
    const Loop loop = record_of(0.72e-3, 1.37e-4, true);
    EXPECT_TRUE(has_alert(analysed(loop, 0.72e-3), "THIN_LAYER", "a/h reaches 0.19"));
    EXPECT_FALSE(has_alert(analysed(loop, 0.72e-3), "HEIGHT_UNKNOWN"));
    const LoopAnalysis unknown = analysed(loop, std::nullopt);
    EXPECT_TRUE(has_alert(unknown, "HEIGHT_UNKNOWN", "too high if the height is"));
    EXPECT_FALSE(has_alert(unknown, "THIN_LAYER"));
    Loop without_depth = loop;
    without_depth.displacement = Array1D();
    EXPECT_FALSE(has_alert(analysed(without_depth, std::nullopt), "HEIGHT_UNKNOWN"));
}

TEST(FiniteHeight, ExcessMatchesTheLayerFactors) {
    // to first order in χ = √(Rδ)/h Dimitriadis (2002) has F larger by 1.133 χ at ν = 1/2
    EXPECT_NEAR(modulus_excess(1e-6, 1e-4, 0.5) / (1.133 * 0.01), 1.0, 0.03);
    EXPECT_NEAR(modulus_excess(1.37e-4, 1.37e-3, 0.5), 0.12, 0.02);
    EXPECT_NEAR(modulus_excess(1.37e-4, 0.72e-3, 0.5), 0.25, 0.03);
}

}  // namespace
}  // namespace setae::loops::finite_height_test
