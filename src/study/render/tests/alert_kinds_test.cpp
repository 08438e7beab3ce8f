// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/alert_kinds.hpp"

#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "setae/output/alert_groups.hpp"

namespace setae::output::alert_kinds_test {
namespace {

TEST(WarningKinds, StateTheBasisOfEachThreshold) {
    const std::regex threshold(R"(\d (%|times|robust)|(above|below|than) ([1-9]|0[.])|p < |\d+ GiB)");
    int with_threshold = 0;
    for (const auto& kind : alert_kinds()) {
        if (!std::regex_search(kind.said, threshold)) continue;
        ++with_threshold;
        EXPECT_NE(kind.rests_on, "") << kind.code << ": " << kind.said;
    }
    EXPECT_GT(with_threshold, 30);
}

TEST(WarningKinds, StateEffectAndActionInFullSentences) {
    for (const auto& kind : alert_kinds())
        for (const auto* text : {&kind.said, &kind.effect, &kind.action}) {
            ASSERT_FALSE(text->empty()) << kind.code;
            EXPECT_EQ(text->back(), '.') << kind.code << ": " << *text;
        }
}

TEST(WarningKinds, IncludeGeneralWarnings) {
    int general = 0;
    for (const auto& kind : alert_kinds()) general += is_general_warning(kind.code) ? 1 : 0;
    EXPECT_EQ(general, 17);
}

TEST(WarningKinds, AreListedOnce) {
    std::set<std::string> codes;
    for (const auto& kind : alert_kinds()) EXPECT_TRUE(codes.insert(kind.code).second) << kind.code;
}

}  // namespace
}  // namespace setae::output::alert_kinds_test
