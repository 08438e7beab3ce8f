// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/channel_remedy.hpp"

#include <gtest/gtest.h>

namespace setae::study::channel_remedy_test {
namespace {

using loops::ChannelFault;
using tables::ChannelNames, tables::ChosenColumns;

const ChannelNames plain{{"force", {"load", "mN", "load"}}, {"displacement", {"extension", "um", "extension"}}};

TEST(ChannelRemedy, InvertsTheSignOfColumns) {
    EXPECT_EQ(columns_that_undo(ChannelFault::force_reversed, plain), (ChosenColumns{{"force", "-1 * load"}}));
    EXPECT_EQ(columns_that_undo(ChannelFault::displacement_reversed, plain),
              (ChosenColumns{{"displacement", "-1 * extension"}}));
    EXPECT_EQ(columns_that_undo(ChannelFault::both_reversed, plain),
              (ChosenColumns{{"force", "-1 * load"}, {"displacement", "-1 * extension"}}));
}

TEST(ChannelRemedy, RemovesAnInversionAndKeepsUnits) {
    const ChannelNames turned{{"force", {"kraft", "uN", "-1 * kraft[uN]"}},
                              {"displacement", {"gap", "um", "-1 * gap"}}};
    EXPECT_EQ(columns_that_undo(ChannelFault::both_reversed, turned),
              (ChosenColumns{{"force", "kraft[uN]"}, {"displacement", "gap"}}));
    const ChannelNames computed{{"force", {"", "", "3 N/m * mems"}}};
    EXPECT_EQ(columns_that_undo(ChannelFault::force_reversed, computed),
              (ChosenColumns{{"force", "-1 * (3 N/m * mems)"}}));
}

TEST(ChannelRemedy, SwapsColumnsAndKeepsUnitsOfTheirRoles) {
    EXPECT_EQ(columns_that_undo(ChannelFault::swapped, plain),
              (ChosenColumns{{"force", "extension[mN]"}, {"displacement", "load[um]"}}));
    EXPECT_EQ(channel_remedy(ChannelFault::swapped, {{"force", {"", "", "a - b"}}, {"displacement", {"c", "m", "c"}}}),
              "check which column is the force and which the displacement");
}

TEST(ChannelRemedy, CanBeTypedAsPrinted) {
    EXPECT_EQ(channel_remedy(ChannelFault::force_reversed, plain),
              "use --column force=\"-1 * load\" (in a study columns = { force = \"-1 * load\" })");
}

}  // namespace
}  // namespace setae::study::channel_remedy_test
