// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/synthesis/transformed_heights.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/fourier/map_transform.hpp"

namespace transformed_heights_test {

using namespace setae;
using namespace setae::synthesis;

const spectra::SelfAffine model{1e-28, 2.0 * pi / 2e-7, 0.8, 2.0 * pi / 1.6e-8};
const SurfaceGrid grid{256, 192, 1e-6, 0.75e-6};

/// Σ |h_q|² over rings of q a factor 1.5 apart.
std::vector<double> ring_powers(const topography::HeightMap& map) {
    std::vector<double> rings(12, 0.0);
    const double unit_x = 2.0 * pi / map.size[0], unit_y = 2.0 * pi / map.size[1];
    fourier::transform_map(
        map.heights.rows(), map.heights.cols(),
        [&](Index i, double* line) { std::copy_n(map.heights.row(i).data(), map.heights.cols(), line); },
        [&](const fourier::SpectrumBlock& block) {
            for (Index m = 0; m < block.lines; ++m)
                for (Index k = 0; k < block.modes; ++k) {
                    const double qx = unit_x * static_cast<double>(2 * k > block.modes ? k - block.modes : k);
                    const double q = std::hypot(qx, unit_y * static_cast<double>(block.first + m));
                    if (q == 0.0) continue;
                    const double ring = std::floor(std::log(q / (0.9 * unit_x)) / std::log(1.5));
                    if (ring < 12.0) rings[static_cast<std::size_t>(ring)] += std::norm(block.line(m)[k]);
                }
        },
        {1});
    return rings;
}

HeightShape shape_of_map(const topography::HeightMap& map) {
    const Array2D h = map.heights / std::sqrt(map.heights.square().mean());
    return {h.cube().mean(), h.square().square().mean()};
}

struct Ensemble {
    std::vector<double> rings = std::vector<double>(12, 0.0);
    HeightShape shape{0.0, 0.0};
    double mean_square = 0.0;
};

template <class Make>
Ensemble ensemble(int samples, const Make& make) {
    Ensemble result;
    for (int seed = 0; seed < samples; ++seed) {
        const auto map = make(SurfaceOptions{.key = {static_cast<std::uint64_t>(seed), 0}, .threads = {1}});
        const auto rings = ring_powers(map);
        for (std::size_t i = 0; i < 12; ++i) result.rings[i] += rings[i] / samples;
        result.shape.skewness += shape_of_map(map).skewness / samples;
        result.shape.kurtosis += shape_of_map(map).kurtosis / samples;
        result.mean_square += map.heights.square().mean() / samples;
    }
    return result;
}

TEST(NonGaussianSurface, WithTheIdentityEqualsTheGaussianSurface) {
    for (const auto amplitudes : {Amplitudes::gaussian, Amplitudes::exact}) {
        const SurfaceOptions options{.key = {5, 1}, .amplitudes = amplitudes, .threads = {1}};
        const auto gaussian = random_surface(spectra::density(model), grid, options);
        const auto same = non_gaussian_surface(
            spectra::density(model), grid, [](double z) { return z; }, options);
        EXPECT_LT(same.dropped_share, 1e-12);
        EXPECT_LT((same.map.heights - gaussian.heights).abs().maxCoeff(),
                  1e-6 * std::sqrt(gaussian.heights.square().mean()));
    }
}

TEST(NonGaussianSurface, HasTheRequestedSpectrumAndHeightDistribution) {
    constexpr int samples = 12;
    const auto transform = lognormal_heights(1.5);
    double dropped = 0.0;
    const auto gaussian = ensemble(
        samples, [&](const SurfaceOptions& options) { return random_surface(spectra::density(model), grid, options); });
    const auto shaped = ensemble(samples, [&](const SurfaceOptions& options) {
        auto made = non_gaussian_surface(spectra::density(model), grid, transform, options);
        dropped = made.dropped_share;
        return made.map;
    });
    const auto plain = ensemble(samples, [&](const SurfaceOptions& options) {
        return transformed_heights(random_surface(spectra::density(model), grid, options), transform,
                                   expected_roughness(spectra::density(model), grid).rms_height);
    });
    EXPECT_LT(dropped, 0.002);
    // 12 maps of some 60 independent patches: the mean square of such heights (kurtosis 7) scatters by √(6/720) = 9 %,
    // and the skewness, whose estimate is low in small samples, by about twice that
    EXPECT_NEAR(shaped.shape.skewness, 1.5, 0.4);
    EXPECT_NEAR(shaped.mean_square / gaussian.mean_square, 1.0, 0.2);
    // rings 6 … 9 contain at least 500 modes per map; the same seeds, so most of their scatter is common
    double plain_deviation = 0.0;
    for (std::size_t i = 6; i <= 9; ++i) {
        EXPECT_NEAR(shaped.rings[i] / gaussian.rings[i], 1.0, 0.1) << i;
        plain_deviation = std::max(plain_deviation, std::abs(plain.rings[i] / gaussian.rings[i] - 1.0));
    }
    EXPECT_GT(plain_deviation, 0.15);  // correction by the spectrum of the parent
}

TEST(NonGaussianSurface, ReportsTheSpectrumThatNoTransformCanHave) {
    // alternating ridges: an autocorrelation down to −1, which skew heights cannot have
    const auto ridge = [](double q) { return std::abs(q - 2.0 * pi / 1.25e-7) < 1e5 ? 1e-30 : 0.0; };
    const auto made = non_gaussian_surface(ridge, {64, 64, 1e-6, 1e-6}, lognormal_heights(3.0), {.threads = {1}});
    EXPECT_GT(made.dropped_share, 0.05);
}

TEST(NonGaussianSurface, HasExactRmsHeightAndZeroMeanForAnyNumberOfThreads) {
    SurfaceOptions options{.key = {2, 2}, .exact_rms_height = 3e-9, .threads = {1}};
    const auto single = non_gaussian_surface(spectra::density(model), grid, lognormal_heights(-1.0), options);
    EXPECT_NEAR(std::sqrt(single.map.heights.square().mean()), 3e-9, 1e-20);
    EXPECT_LT(std::abs(single.map.heights.mean()), 1e-20);
    EXPECT_TRUE(single.map.periodic);
    options.threads = {3};
    EXPECT_TRUE((non_gaussian_surface(spectra::density(model), grid, lognormal_heights(-1.0), options).map.heights ==
                 single.map.heights)
                    .all());
}

TEST(TransformedHeights, ReplaceDefinedHeightsOnly) {
    topography::HeightMap map{Array2D::Constant(2, 3, 2e-9), {1.0, 1.5}};
    map.heights(0, 1) = NAN;
    map.heights(1, 2) = -4e-9;
    const auto cubed = transformed_heights(
        map, [](double z) { return z * z * z; }, 2e-9);
    EXPECT_TRUE(std::isnan(cubed.heights(0, 1)));
    const double mean = (4 * 2e-9 - 16e-9) / 5;  // 1³ and (−2)³ in units of 2 nm
    EXPECT_NEAR(cubed.heights(0, 0), 2e-9 - mean, 1e-22);
    EXPECT_NEAR(cubed.heights(1, 2), -16e-9 - mean, 1e-22);
    EXPECT_THROW((void)transformed_heights(
                     map, [](double z) { return z; }, 0.0),
                 InvalidArgument);
}

}  // namespace transformed_heights_test
