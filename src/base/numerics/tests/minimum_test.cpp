// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/numerics/minimum.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>

#include "setae/core/errors.hpp"
#include "setae/parallel/cancellation.hpp"

namespace setae::numerics::minimum_test {
namespace {

TEST(Minimum, FindsTheMinimumOfAParabola) {
    const auto minimum = minimum_between([](double x) { return (x - 0.3) * (x - 0.3) + 2.0; }, -1.0, 4.0, 26);
    EXPECT_NEAR(minimum.place, 0.3, 1e-7);
    EXPECT_NEAR(minimum.value, 2.0, 1e-13);
}

TEST(Minimum, TerminatesForUndefinedAndInfiniteValues) {
    for (const double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity(), 0.0}) {
        int asked = 0;
        const auto function = [&](double) {
            ++asked;
            return value;
        };
        for (const double reach : {1.0, 1e-300, 5e-324, 1e300, std::numeric_limits<double>::infinity()})
            static_cast<void>(minimum_between(function, 0.0, reach, 20));
        EXPECT_LE(asked, 5 * 202) << value;
    }
}

TEST(Minimum, CanBeCancelled) {
    std::atomic<bool> cancelled{false};
    const parallel::CancellationScope scope(cancelled);
    int asked = 0;
    const auto function = [&](double x) {
        cancelled = ++asked == 3;
        return x * x;
    };
    EXPECT_THROW((void)minimum_between(function, -1.0, 2.0, 20), Cancelled);
    EXPECT_EQ(asked, 3);
}

}  // namespace
}  // namespace setae::numerics::minimum_test
