// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/seam.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "record_number.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/spectra/spectral_density.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::processing::seam_test {
namespace {

topography::HeightMap periodic_map(Index n, std::uint64_t seed, double short_cutoff) {
    const auto density = spectra::density(spectra::SelfAffine{1.0, 2.0 * pi / 0.25e-6, 0.8, 2.0 * pi / short_cutoff});
    auto map = synthesis::random_surface(density, {n, n, 1e-6, 1e-6}, {.key = {seed}});
    map.heights *= 1e-9 / rms_of(map.heights);
    return map;
}

topography::HeightMap tilted(topography::HeightMap map, double rise) {
    for (Index i = 0; i < map.heights.rows(); ++i)
        map.heights.row(i) += rise * static_cast<double>(i) / static_cast<double>(map.heights.rows());
    return map;
}

topography::HeightMap left_half(const topography::HeightMap& map) {
    const Index n = map.heights.rows() / 2;
    return {map.heights.topLeftCorner(n, n), {0.5 * map.size[0], 0.5 * map.size[1]}, false, {}};
}

TEST(Seam, IsClosedOnPeriodicSurfaces) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed)
        EXPECT_TRUE(seam_of(periodic_map(128, seed, 40e-9)).closed) << seed;
}

TEST(Seam, OfPeriodicWavesIsClosedAtAnyPhase) {
    for (int k = 0; k < 16; ++k) {
        topography::LineScan line{.heights = Array1D(64), .size = 1e-6, .periodic = false, .metadata = {}};
        for (Index i = 0; i < 64; ++i)
            line.heights[i] = std::sin(2.0 * pi * (static_cast<double>(i) / 64.0 + k / 16.0));
        EXPECT_TRUE(seam_of(line).closed) << k;
    }
}

TEST(Seam, IsOpenOnAPartOfASurface) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed)
        EXPECT_FALSE(seam_of(left_half(periodic_map(256, seed, 40e-9))).closed) << seed;
}

TEST(Seam, DetectsATiltSmallerThanTheRoughness) {
    auto map = periodic_map(256, 1, 8e-9);
    EXPECT_TRUE(seam_of(map).closed);
    EXPECT_FALSE(seam_of(tilted(map, 3e-9)).closed);
}

// h = 60 nm x/L on 4 x 4 points: the last row is 45 nm above the first, neighbours 15 nm apart
TEST(Seam, StepOfAPlaneEqualsItsRise) {
    topography::HeightMap flat{Array2D::Zero(4, 4), {1e-6, 1e-6}, false, {}};
    const auto seam = seam_of(tilted(flat, 60e-9));
    EXPECT_NEAR(seam.height_step, 45e-9, 1e-20);
    EXPECT_NEAR(seam.usual_step, 15e-9, 1e-20);
    EXPECT_FALSE(seam.closed);
    EXPECT_TRUE(seam_of(flat).closed);
}

TEST(Window, ClosesASeamAndKeepsTheMiddle) {
    const auto piece = left_half(periodic_map(256, 3, 40e-9));
    const auto result = windowed(piece);
    const auto& map = map_of(result);
    EXPECT_TRUE(map.periodic);
    EXPECT_LT(seam_of(map).height_step, 1e-2 * seam_of(piece).height_step);
    EXPECT_TRUE((map.heights.block(32, 32, 64, 64) == piece.heights.block(32, 32, 64, 64)).all());
    EXPECT_NEAR(number_of(result.record, "windowed_share"), 1.0 - 0.64, 0.02);  // 0.8² is unchanged
    EXPECT_NEAR(number_of(result.record, "height_step_at_seam"), seam_of(piece).height_step, 1e-20);
}

TEST(Window, IsRefusedBeyondHalfTheExtent) {
    EXPECT_THROW((void)windowed(periodic_map(16, 1, 200e-9), 0.6), InvalidArgument);
}

}  // namespace
}  // namespace setae::processing::seam_test
