// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces that are rougher in some places than in others: how often intervals of the fit cover the mean over places.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/numerics/random_numbers.hpp"
#include "setae/spectra/self_affine.hpp"
#include "setae/spectral_fit/likelihood_spectrum.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::spectral_fit::place_scatter_test {
namespace {

constexpr double shortest_wavelength = 40e-9;

spectra::SelfAffine model() {
    return {.plateau = 2e-30,
            .rolloff_wavevector = 2.0 * pi / 200e-9,
            .hurst_exponent = 0.8,
            .short_wavevector = 2.0 * pi / shortest_wavelength};
}

/// 64 × 64 points of a patch twice as wide, whose power is exp(scatter · normal − scatter²/2) times that of the model:
/// equal on average.
ObservedSurface place(std::uint64_t seed, double scatter) {
    constexpr Index points = 64, fine = 2 * points;
    constexpr double pixel = 0.5 * shortest_wavelength, size = fine * pixel;
    const auto patch = synthesis::random_surface(spectra::density(model()), {fine, fine, size, size},
                                                 {.key = {seed, 1}, .threads = {1}});
    topography::HeightMap map{patch.heights.topLeftCorner(points, points), {0.5 * size, 0.5 * size}, false, {}};
    map.heights *= std::exp(0.5 * scatter * numerics::normal_number({seed, 2}, 0) - 0.25 * scatter * scatter);
    map.metadata.instrument.type = "afm";
    return {map, topography::Trend::tilt};
}

struct Coverage {
    double held = 0.0;
    double alerts = 0.0;
};

Coverage of_three_places(double scatter) {
    constexpr int sets = 100;
    const auto density = spectra::density(model());
    Coverage coverage;
    for (std::uint64_t set = 0; set < sets; ++set) {
        std::vector<ObservedSurface> places;
        for (std::uint64_t i = 0; i < 3; ++i) places.push_back(place(3 * set + i, scatter));
        const auto fit = likelihood_spectrum(places, {.shortest_wavelength = shortest_wavelength, .threads = {1}});
        const Index middle = fit.C_iso.wavevector.size() - 20;  // half a decade from the end: hundreds of waves
        const double off = std::log(fit.C_iso.density[middle] / density(fit.C_iso.wavevector[middle]));
        coverage.held += (std::abs(off) < 1.96 * fit.log_standard_error[middle]) / static_cast<double>(sets);
        coverage.alerts += std::any_of(fit.alerts.begin(), fit.alerts.end(),
                                       [](const Alert& a) { return a.code == "MEASUREMENTS_SCATTER"; }) /
                           static_cast<double>(sets);
    }
    return coverage;
}

// The error of a share of 0.95 from a hundred sets is 0.022.
TEST(SpotScatter, OfThreeSpotsIsCoveredByStudentT) {
    const auto alike = of_three_places(0.0), little = of_three_places(0.15), much = of_three_places(0.5);
    EXPECT_GE(alike.held, 0.93);
    EXPECT_GE(little.held, 0.90);
    EXPECT_LE(little.held, 0.98);
    EXPECT_GE(much.held, 0.86);
    EXPECT_LE(much.held, 0.98);
    EXPECT_LE(alike.alerts, 0.05);
    EXPECT_GE(much.alerts, 0.8);
}

}  // namespace
}  // namespace setae::spectral_fit::place_scatter_test
