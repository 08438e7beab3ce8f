// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/words.hpp"

#include <gtest/gtest.h>

#include "setae/core/text.hpp"

namespace setae::words_test {
namespace {

TEST(Counted, UsesSingularAndPlural) {
    EXPECT_EQ(counted(0, "pair", "pairs"), "no pairs");
    EXPECT_EQ(counted(1, "pair", "pairs"), "1 pair");
    EXPECT_EQ(counted(3, "pair", "pairs"), "3 pairs");
}

TEST(Listed, ShortensLongLists) {
    EXPECT_EQ(listed({}), "");
    EXPECT_EQ(listed({"A"}), "A");
    EXPECT_EQ(listed({"A", "B", "C"}), "A, B and C");
    EXPECT_EQ(listed({"A", "B", "C", "D", "E", "F"}), "A, B, C, D, E and F");
    EXPECT_EQ(listed({"A", "B", "C", "D", "E", "F", "G"}), "A, B, C, D, E and 2 more");
}

TEST(Folded, RemovesCaseAndAccents) {
    EXPECT_EQ(folded("Déplacement"), "deplacement");
    EXPECT_EQ(folded("De\u0301placement"), "deplacement");
    EXPECT_EQ(folded("GRÖSSE Größe Ÿ ł"), "grosse grosse y l");
    EXPECT_EQ(folded("µm δ 5"), "µm δ 5");
    EXPECT_EQ(folded("\xe9"), "\xe9");
}

}  // namespace
}  // namespace setae::words_test
