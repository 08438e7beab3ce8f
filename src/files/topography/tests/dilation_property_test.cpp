// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/dilation.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "samples.hpp"

namespace setae::topography::dilation_property_test {
namespace {

HeightMap any_map() {
    const auto nx = *rc::gen::inRange<Index>(12, 40), ny = *rc::gen::inRange<Index>(12, 40);
    const auto seed = *rc::gen::arbitrary<unsigned>();
    return {tests::random_map(nx, ny, seed),
            {static_cast<double>(nx), static_cast<double>(ny)},
            *rc::gen::arbitrary<bool>()};
}

Tip any_tip() {
    const double radius = *rc::gen::inRange(2, 7);
    switch (*rc::gen::inRange(0, 3)) {
        case 0: return SphereTip{radius};
        case 1: return ConeTip{0.2 + 0.1 * *rc::gen::inRange(0, 8), 0.1 * radius};
        default: return ParabolicTip{radius};
    }
}

void check(const std::function<void()>& property) { ASSERT_TRUE(rc::check(property)); }

TEST(Dilation, IsNeverBelowTheSurfaceNorIsTheReconstruction) {
    check([] {
        const auto surface = any_map();
        const Tip tip = any_tip();
        const auto image = dilated(surface, tip);
        const auto back = eroded(image, tip);
        RC_ASSERT((image.heights >= surface.heights).all());
        RC_ASSERT((back.heights >= surface.heights - 1e-12).all());
        RC_ASSERT((back.heights <= image.heights).all());
        // surfaces that the tip cannot distinguish have equal images
        RC_ASSERT((dilated(back, tip).heights - image.heights).abs().maxCoeff() < 1e-12);
    });
}

TEST(Dilation, IsMonotonicInTheSurface) {
    check([] {
        const auto lower = any_map();
        auto upper = lower;
        upper.heights +=
            tests::random_map(lower.heights.rows(), lower.heights.cols(), *rc::gen::arbitrary<unsigned>()).abs();
        const Tip tip = SphereTip{4.0};
        RC_ASSERT((dilated(upper, tip).heights >= dilated(lower, tip).heights).all());
    });
}

TEST(Dilation, FollowsShiftsOfAPeriodicSurfaceAndMirrors) {
    check([] {
        auto surface = any_map();
        surface.periodic = true;
        const Tip tip = any_tip();
        const auto nx = surface.heights.rows(), shift = *rc::gen::inRange<Index>(0, nx);
        const auto image = dilated(surface, tip);
        auto moved = surface;
        for (Index i = 0; i < nx; ++i) moved.heights.row((i + shift) % nx) = surface.heights.row(i);
        const auto moved_image = dilated(moved, tip);
        for (Index i = 0; i < nx; ++i)
            RC_ASSERT((moved_image.heights.row((i + shift) % nx) == image.heights.row(i)).all());
        auto mirror = surface;
        mirror.heights = surface.heights.reverse().eval();
        RC_ASSERT((dilated(mirror, tip).heights == image.heights.reverse()).all());
    });
}

}  // namespace
}  // namespace setae::topography::dilation_property_test
