// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of SurfaceTopography 1.27.1 and scipy: README.md.
#include <gtest/gtest.h>

#include "patches.hpp"

namespace setae::diagnostics::surfacetopography_test {
namespace {

using topography::Mask;

Mask mask_below(Index threshold) {
    return Mask::NullaryExpr(48, 37, [threshold](Index i, Index j) {
        return static_cast<std::uint8_t>((7 * i * i + 5 * j * j + 3 * i * j) % 97 < threshold);
    });
}

struct Expected {
    Neighbours neighbours;
    bool periodic;
    std::int32_t count;
    long long weighted_numbers;  ///< Σ number · (storage index mod 13 + 1): the numbering itself
};

TEST(GeometryOfSurfaceTopography, NumbersPatchesEqually) {
    for (const auto& expected :
         {Expected{Neighbours::edges, false, 245, 589794}, Expected{Neighbours::edges, true, 237, 557182},
          Expected{Neighbours::edges_and_corners, false, 50, 96202},
          Expected{Neighbours::edges_and_corners, true, 32, 49592}}) {
        const auto found = patches(mask_below(37), expected.neighbours, expected.periodic);
        EXPECT_EQ(found.count, expected.count);
        long long sum = 0;
        for (Index k = 0; k < found.numbers.size(); ++k)
            sum += static_cast<long long>(found.numbers.data()[k]) * (k % 13 + 1);
        EXPECT_EQ(sum, expected.weighted_numbers);
    }
}

}  // namespace
}  // namespace setae::diagnostics::surfacetopography_test
