// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/named_choice.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "setae/core/errors.hpp"

namespace setae::named_choice_test {
namespace {

const std::vector<std::string> names{"Height (trace)", "Height (retrace)", "Phase", "phase image", ""};

std::string refusal(const std::string& wanted) {
    try {
        (void)chosen_by_name(wanted, names, "channel");
    } catch (const InvalidArgument& error) {
        return error.what();
    }
    return {};
}

TEST(NamedChoice, AcceptsNumbersFromZero) {
    EXPECT_EQ(chosen_by_name("0", names, "channel"), 0u);
    EXPECT_EQ(chosen_by_name("4", names, "channel"), 4u);
    EXPECT_EQ(
        refusal("5"),
        "no channel 5; there are 0 'Height (trace)', 1 'Height (retrace)', 2 'Phase', 3 'phase image', 4, counted from 0");
    EXPECT_NE(refusal("99999999999999999999999").find("no channel 9"), std::string::npos);
}

TEST(NamedChoice, AcceptsNamesAndPrefixesInAnyCase) {
    EXPECT_EQ(chosen_by_name("height (RETRACE)", names, "channel"), 1u);
    EXPECT_EQ(chosen_by_name(" height (t", names, "channel"), 0u);
    EXPECT_EQ(chosen_by_name("phase", names, "channel"), 2u) << "a whole name goes before a beginning";
    EXPECT_EQ(chosen_by_name("phase i", names, "channel"), 3u);
}

TEST(NamedChoice, NamesAmbiguousAndMissingChoices) {
    EXPECT_EQ(
        refusal("hei"),
        "channel 'hei' is ambiguous: 0 'Height (trace)', 1 'Height (retrace)'; give the whole name or the number");
    EXPECT_NE(refusal("Phaze").find("no channel 'Phaze' (did you mean 'Phase'?)"), std::string::npos);
    EXPECT_NE(refusal("-1").find("no channel '-1'"), std::string::npos);
    EXPECT_NE(refusal("").find("no channel ''"), std::string::npos);
}

TEST(NamedChoice, ListsTheFirstOfManyNames) {
    const std::vector<std::string> many(100, "frame");
    const auto shown = numbered_names(many);
    EXPECT_NE(shown.find("11 'frame', … 99"), std::string::npos);
}

}  // namespace
}  // namespace setae::named_choice_test
