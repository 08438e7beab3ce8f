// SPDX-License-Identifier: GPL-3.0-or-later
// The variance of the half derivative by three ways: sums over modes here, integrals of roughness/spectral_moments,
// autocorrelation.
#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/roughness/spectral_moments.hpp"
#include "setae/scales/autocorrelation.hpp"
#include "setae/scales/half_derivative.hpp"
#include "setae/spectra/power_spectrum.hpp"
#include "setae/spectra/self_affine.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace {

using namespace setae;
using namespace setae::scales;

constexpr Index points = 512;
const spectra::SelfAffine model{1.0, 2.0 * pi / 128.0, 0.8, 2.0 * pi / 8.0};

topography::HeightMap surface(std::uint64_t seed) {
    return synthesis::random_surface(spectra::density(model), {points, points, points, points}, {.key = {seed}});
}

double model_variance() { return spectra::moment(model, 1.0) / (2.0 * pi); }

TEST(StoredEnergy, OfALineIsThatOfItsModes) {
    topography::LineScan line{surface(1).heights.col(7), points, true, {}};
    spectra::SpectrumOptions options;
    options.window = spectra::Window::none;
    const auto spectrum = spectra::power_spectrum(line, options);
    const double half_step = pi / static_cast<double>(points);
    const roughness::SpectrumCurve curve{
        spectrum.wavevector, spectrum.C1D, {half_step, pi}, roughness::Density::C1D, roughness::Nodes::modes};
    const double per_modulus = roughness::spectral_parameters(curve).elastic_energy_per_modulus;
    EXPECT_NEAR(half_derivative_variance(line, SurfaceKind::isotropic).energy_per_area(1.0) / per_modulus, 1.0, 1e-4);
}

TEST(StoredEnergy, OfRandomSurfacesIsThatOfTheirModelEveryWay) {
    double of_map = 0.0, of_lines = 0.0, from_area = 0.0, from_lines = 0.0;
    constexpr int seeds = 4;
    for (int seed = 1; seed <= seeds; ++seed) {
        const auto map = surface(static_cast<std::uint64_t>(seed));
        const double rms = std::sqrt(map.heights.square().mean());
        of_map += half_derivative_variance(map).variance / seeds;
        for (Index j = 0; j < points; j += 16)
            of_lines +=
                half_derivative_variance({map.heights.col(j), points, true, {}}, SurfaceKind::isotropic).variance /
                (seeds * points / 16.0);
        from_area +=
            half_derivative_from_autocorrelation(autocorrelation_of_area(map), rms, SurfaceKind::isotropic).variance /
            seeds;
        from_lines +=
            half_derivative_from_autocorrelation(autocorrelation_of_lines(map), rms, SurfaceKind::isotropic).variance /
            seeds;
    }
    // a surface has some 50 independent wavevectors about its roll-off: a few per cent of scatter, the same in all four
    EXPECT_NEAR(of_map / model_variance(), 1.0, 0.05);
    EXPECT_NEAR(of_lines / of_map, 1.0, 0.02);
    EXPECT_NEAR(from_area / of_map, 1.0, 0.02);
    EXPECT_NEAR(from_lines / of_map, 1.0, 0.02);
}

}  // namespace
