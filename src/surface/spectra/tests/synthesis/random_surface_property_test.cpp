// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/synthesis/random_surface.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace random_surface_property_test {

using namespace setae;
using namespace setae::synthesis;

const spectra::SpectralDensity C_iso = spectra::density(spectra::SelfAffine{1e-27, 2e7, 0.8, 2e9});

SurfaceGrid any_grid() {
    return {*rc::gen::inRange<Index>(2, 60), *rc::gen::inRange<Index>(2, 60), 1e-6, 1e-7 * *rc::gen::inRange(1, 100)};
}

RC_GTEST_PROP(RandomSurface, OfExactAmplitudesHasTheExpectedRmsHeightOnAnyGrid,
              (std::uint64_t seed, std::uint64_t stream)) {
    const auto grid = any_grid();
    const SurfaceOptions options{.key = {seed, stream}, .amplitudes = Amplitudes::exact, .threads = {1}};
    const auto map = random_surface(C_iso, grid, options);
    const double made = std::sqrt(map.heights.square().mean()),
                 expected = expected_roughness(C_iso, grid, options).rms_height;
    RC_ASSERT(std::abs(made / expected - 1.0) < 1e-12);
    RC_ASSERT(std::abs(map.heights.mean()) < 1e-13 * expected);
}

RC_GTEST_PROP(RandomSurface, ScalesWithTheRootOfTheSpectrum, (std::uint64_t seed)) {
    // a power of four is exact in binary: every height doubles to the last bit
    const auto grid = any_grid();
    const auto once = random_surface(C_iso, grid, {.key = {seed}, .threads = {1}});
    const auto twice = random_surface([](double q) { return 4.0 * C_iso(q); }, grid, {.key = {seed}, .threads = {1}});
    RC_ASSERT((twice.heights == 2.0 * once.heights).all());
}

RC_GTEST_PROP(NormalNumbers, AreFiniteAndIndependentOfTheFirstIndex,
              (std::uint64_t seed, std::uint64_t stream, std::uint64_t counter)) {
    const numerics::RandomKey key{seed, stream};
    const auto numbers = numerics::normal_numbers(key, counter, 9);
    RC_ASSERT(numbers.isFinite().all());
    RC_ASSERT(numbers.abs().maxCoeff() < 8.6);
    for (Index i = 0; i < 9; ++i)
        RC_ASSERT(numbers[i] == numerics::normal_number(key, counter + static_cast<std::uint64_t>(i)));
}

}  // namespace random_surface_property_test
