// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables/smooth_limit_output.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "setae/output/field_json.hpp"
#include "setae/output/hysteresis_fields.hpp"
#include "setae/study/study.hpp"
#include "setae/study/study_result.hpp"

namespace setae::output::smooth_limits_test {
namespace {

// OTS on four elastomers: W_ret 52 to 59 mJ/m² published, while one work a true area is that of rough surfaces
TEST(SmoothLimits, OfThePublishedModelsAreComparedWithTheReference) {
    const auto result = study::run_study(study::read_study("examples/nanodiamond/published.toml"));
    ASSERT_TRUE(result.hysteresis);
    const auto& h = *result.hysteresis;
    EXPECT_EQ(h.smooth_limits.size(), 4 * h.all.models.size());
    const hysteresis::RetractionModel opening{hysteresis::Law::opening_work, hysteresis::Tip::none};
    const hysteresis::RetractionModel tip{hysteresis::Law::reversible, hysteresis::Tip::reference};
    for (const auto& of : h.smooth_limits) {
        EXPECT_GT(of.reference.value, 50e-3);
        EXPECT_LT(of.reference.value, 60e-3);
        if (of.limit.model == tip) EXPECT_NEAR(of.limit.distance.value, 0.0, 1e-12);
        if (of.limit.model == opening) {
            EXPECT_GT(of.limit.work_retraction.value, 75e-3);
            EXPECT_GT(of.limit.distance.value, 15e-3);
            EXPECT_FALSE(of.limit.tends_to_reference);
        }
    }
    const auto table = smooth_limit_table(h);
    EXPECT_EQ(table.rows.size(), h.all.models.size());
    EXPECT_EQ(described(HysteresisEntry{&h}).at("smooth_limits").size(), h.smooth_limits.size());
}

}  // namespace
}  // namespace setae::output::smooth_limits_test
