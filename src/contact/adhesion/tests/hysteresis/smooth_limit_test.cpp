// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/hysteresis/smooth_limit.hpp"

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"

namespace setae::hysteresis::smooth_limit_test {
namespace {

/// OTS on the softest elastomer, published: W_app 40, W_ret 52 mJ/m².
SmoothReference reference() {
    return {.work_approach = {{.value = 0.040, .standard_error = 0.001}, "W_app of the reference"},
            .work_retraction = {{.value = 0.052, .standard_error = 0.002}, "W_ret of the reference"}};
}

constexpr double W_int = 0.037;

SmoothLimit limit_of(Law law, Tip tip = Tip::none, double parameter = 0.0) {
    return smooth_limit({.model = {law, tip}, .parameter = parameter, .scatter = {}}, reference(), W_int);
}

TEST(SmoothLimit, EqualsTheReferenceForModelsThatTendToIt) {
    for (const auto& model : retraction_models({Tip::none, Tip::reference, Tip::speed})) {
        const auto limit = limit_of(model.law, model.tip, model.law == Law::fitted_pinning ? 2.0 : 0.05);
        const double own = model.tip == Tip::none ? 0.040 : 0.052;
        EXPECT_EQ(limit.tends_to_reference, has_smooth_limit(model)) << model.name();
        if (has_smooth_limit(model)) EXPECT_NEAR(limit.work_retraction.value, own, 1e-15) << model.name();
        else EXPECT_GT(limit.work_retraction.value, own) << model.name();
    }
}

TEST(SmoothLimit, OfAWorkPerTrueAreaEqualsThatWork) {
    const auto limit = limit_of(Law::opening_work, Tip::none, 0.081);
    EXPECT_NEAR(limit.work_retraction.value, 0.081, 1e-15);
    EXPECT_NEAR(limit.distance.value, 0.029, 1e-15);
    EXPECT_FALSE(limit.tends_to_reference);
}

TEST(SmoothLimit, OfTrueAreaLossExceedsTheReferenceByWInt) {
    EXPECT_NEAR(limit_of(Law::conformal_loss).work_retraction.value, 0.077, 1e-15);
    EXPECT_NEAR(limit_of(Law::conformal_loss, Tip::reference).work_retraction.value, 1.3 * 0.077, 1e-15);
    const auto with_jumps = smooth_limit({.model = {Law::conformal_loss, Tip::none}, .parameter = {}, .scatter = {}},
                                         reference(), W_int, 0.010);
    EXPECT_NEAR(with_jumps.work_retraction.value, 0.067, 1e-15);
}

TEST(SmoothLimit, PropagatesErrorsOfTheReferenceOnce) {
    EXPECT_NEAR(limit_of(Law::reversible, Tip::reference).distance.standard_error(), 0.0, 1e-9)
        << "the tip's factor is the reference's: it cannot be off";
    EXPECT_NEAR(limit_of(Law::reversible).distance.standard_error(), std::hypot(0.001, 0.002), 1e-9);
}

TEST(SmoothLimit, ExistsForTheDefaultModelWithoutMeasurements) {
    EXPECT_TRUE(has_smooth_limit(model_without_measurements()));
    EXPECT_FALSE(model_without_measurements().fitted());
}

TEST(SmoothLimit, RequiresAReference) {
    EXPECT_THROW((void)smooth_limit({.model = {}, .parameter = {}, .scatter = {}}, {0.0, 0.052}, W_int),
                 InvalidArgument);
}

}  // namespace
}  // namespace setae::hysteresis::smooth_limit_test
