// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/half_space/composite.hpp"

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"

namespace setae::half_space::composite_test {
namespace {

TEST(CompositeHeights, TurnTheSecondSurfaceOver) {
    const Array2D first = Array2D{{1.0, 2.0}, {3.0, 4.0}, {5.0, 6.0}},
                  second = Array2D{{10., 20.}, {30., 40.}, {50., 60.}};
    const Array2D expected = Array2D{{51.0, 62.0}, {33.0, 44.0}, {15.0, 26.0}};
    EXPECT_TRUE((composite_heights(first, second) == expected).all());
    EXPECT_THROW((void)composite_heights(first, second.topRows(2)), InvalidArgument);
}

}  // namespace
}  // namespace setae::half_space::composite_test
