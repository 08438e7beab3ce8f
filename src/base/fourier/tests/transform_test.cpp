// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/fourier/transform.hpp"

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"

namespace setae::fourier::transform_test {
namespace {

TEST(Transform, RefusesLengthsBeyondTheRangeOfThePlanner) {
    constexpr Index beyond = Index{1} << 31;
    for (const Index n : {Index{0}, Index{-1}, beyond, 4 * beyond + 8}) {
        EXPECT_THROW(RealTransform{n}, InvalidArgument) << n;
        EXPECT_THROW(InverseRealTransform{n}, InvalidArgument) << n;
        EXPECT_THROW((ComplexTransform{n, ComplexTransform::Sign::minus}), InvalidArgument) << n;
    }
}

}  // namespace
}  // namespace setae::fourier::transform_test
