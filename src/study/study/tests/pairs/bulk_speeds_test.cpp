// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/bulk_speeds.hpp"

#include <gtest/gtest.h>

namespace setae::study::bulk_speeds_test {
namespace {

Hysteresis with(double factor, double error, double rest, double share) {
    Hysteresis h;
    ElastomerEdgeSpeed edge;
    edge.law = {TracedValue(1e-6), TracedValue(0.6), TracedValue(rest)};
    h.elastomers.push_back({"soft", edge, {{TracedValue(share), TracedValue(1.0)}}});
    for (const auto* surface : {"A", "B"}) {
        PairHysteresis pair;
        pair.surface = surface;
        pair.elastomer = "soft";
        pair.speed_factor =
            TracedValue(Estimate{.value = *surface == 'A' ? factor : 0.9 * factor, .standard_error = error}, "φ");
        h.pairs.push_back(pair);
    }
    return h;
}

TEST(SpeedsBeyondBulk, NamesTheBoundAndTheMostDistantPair) {
    const auto alerts = speeds_beyond_bulk(with(2.4, 0.1, 1.2, 0.5));
    ASSERT_EQ(alerts.size(), 1U);
    EXPECT_EQ(alerts[0].code, "SPEED_BEYOND_BULK");
    EXPECT_EQ(alerts[0].subject, "soft");
    EXPECT_NE(alerts[0].message.find("on A the contact edge needs 2.00"), std::string::npos) << alerts[0].message;
    EXPECT_NE(alerts[0].message.find("at most 1.5 times"), std::string::npos) << alerts[0].message;
}

TEST(SpeedsBeyondBulk, AreEmptyWithinTheBoundAndItsErrors) {
    EXPECT_TRUE(speeds_beyond_bulk(with(1.5, 0.01, 1.0, 0.6)).empty());
    EXPECT_TRUE(speeds_beyond_bulk(with(1.7, 0.1, 1.0, 0.6)).empty());
    auto unknown = with(9.0, 0.1, 1.0, 0.6);
    unknown.elastomers[0].relaxation.clear();
    EXPECT_TRUE(speeds_beyond_bulk(unknown).empty());
}

}  // namespace
}  // namespace setae::study::bulk_speeds_test
