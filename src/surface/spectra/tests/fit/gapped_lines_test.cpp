// SPDX-License-Identifier: GPL-3.0-or-later
// Missing heights, and curves read by an instrument with a tip and noise.
#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "fit/gap_factor.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/random_numbers.hpp"
#include "setae/spectra/self_affine.hpp"
#include "setae/spectral_fit/likelihood_spectrum.hpp"
#include "setae/synthesis/random_surface.hpp"
#include "setae/topography/dilation.hpp"

namespace setae::spectral_fit::gapped_lines_test {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// Single gaps of white lines: an interpolated height is the mean of two others. A share f of n heights is e = (a +
/// b)/2, of variance 1/2 and covariance 1/2 with each neighbour:
///
///   ratio = 1 − f/2 + 2 f cos k
TEST(GapFactor, OfSingleGapsInWhiteNoiseMatchesTheClosedForm) {
    constexpr Index n = 256;
    constexpr Index every = 8;
    GappedLines gaps{{n, 1}, 1.0};
    for (Index i = 0; i < n; ++i) gaps.undefined(i, 0) = i % every == 3;
    const auto factor = gap_factor(gaps, {n, 0}, 1e-9, [](double) { return 1e-27; }, 1, {1});
    const ModeBins bins(n / 2);
    double worst = 0.0;
    for (Index b = 0; b < bins.size(); ++b) {
        if (bins.first(b) < 40) continue;
        const double angle = 2.0 * pi * bins.centre(b) / n;
        const double expected = 1.0 - 0.5 / every + 2.0 * std::cos(angle) / every;
        worst = std::max(worst, std::abs(factor[b] - expected));
    }
    EXPECT_LT(worst, 0.06);  // 256 lines, groups of 3 and more: 2 %
    gaps.share = 0.25;
    const auto quarter = gap_factor(gaps, {n, 0}, 1e-9, [](double) { return 1e-27; }, 1, {1});
    EXPECT_LT((quarter - (0.75 + 0.25 * factor)).abs().maxCoeff(), 1e-12);
}

TEST(BridgedLines, OmitsLinesThatAreMostlyMissing) {
    Array2D heights = Array2D::Random(20, 4);
    heights.col(1).head(11).setConstant(missing);
    heights(5, 2) = missing;
    const auto bridged = bridged_lines(heights, "map");
    ASSERT_EQ(bridged.heights.cols(), 3);
    EXPECT_NEAR(bridged.gaps.share, 1.0 / 3.0, 1e-15);
    EXPECT_NEAR(bridged.heights(5, 1), 0.5 * (heights(4, 2) + heights(6, 2)), 1e-15);
    heights.setConstant(missing);
    EXPECT_THROW((void)bridged_lines(heights, "map"), UndefinedDataError);
}

constexpr double shortest_wavelength = 20e-9;

spectra::SpectralDensity surface() {
    return spectra::density(spectra::SelfAffine{.plateau = 2e-30,
                                                .rolloff_wavevector = 2.0 * pi / 500e-9,
                                                .hurst_exponent = 0.8,
                                                .short_wavevector = 2.0 * pi / shortest_wavelength});
}

topography::HeightMap map(std::uint64_t seed) {
    constexpr Index n = 128, stride = 4;
    constexpr double pixel = 40e-9;
    const auto patch = synthesis::random_surface(
        surface(), {2 * n * stride, 2 * n * stride, 2 * n * pixel, 2 * n * pixel}, {.key = {seed, 1}, .threads = {1}});
    topography::HeightMap result{Array2D(n, n), {n * pixel, n * pixel}, false, {}};
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j) result.heights(i, j) = patch.heights(i * stride, j * stride);
    result.metadata.instrument.type = "optical";
    return result;
}

LikelihoodSpectrum fit(const std::vector<ObservedSurface>& observed) {
    return likelihood_spectrum(observed, {.shortest_wavelength = shortest_wavelength, .threads = {1}});
}

/// Differences of ln C_iso within the band of the first.
struct Difference {
    double max_errors = 0.0;  ///< in standard errors of the first
    double mean = 0.0;        ///< weighted by their inverse squares
};

Difference difference(const LikelihoodSpectrum& a, const LikelihoodSpectrum& b) {
    Difference result;
    double weights = 0.0;
    for (Index i = 0; i < a.C_iso.wavevector.size(); ++i) {
        const double q = a.C_iso.wavevector[i], error = a.log_standard_error[i];
        if (q < a.C_iso.band.lower || q > 0.95 * a.C_iso.band.upper) continue;
        const double change = std::log(b.C_iso.density[i] / a.C_iso.density[i]);
        result.max_errors = std::max(result.max_errors, std::abs(change) / error);
        result.mean += change / (error * error);
        weights += 1.0 / (error * error);
    }
    result.mean /= weights;
    return result;
}

// An optical profiler loses single points and patches: a sixth of each map.
TEST(LikelihoodSpectrum, UsesDefinedPointsOfMaps) {
    std::vector<ObservedSurface> whole, gapped;
    for (std::uint64_t seed : {1, 2, 3, 4}) {
        auto heights = map(seed);
        whole.push_back({heights, topography::Trend::tilt});
        for (Index i = 0; i < 128; ++i)
            for (Index j = 0; j < 128; ++j)
                if (numerics::uniform_number({seed, 7}, static_cast<std::uint64_t>(128 * i + j)) < 0.12)
                    heights.heights(i, j) = missing;
        heights.heights.block(40, 20, 24, 40).setConstant(missing);
        gapped.push_back({heights, topography::Trend::tilt});
    }
    const auto all = fit(whole), most = fit(gapped);
    const auto change = difference(all, most);
    EXPECT_LT(change.max_errors, 1.0);  // a sixth of the data is missing
    EXPECT_LT(std::abs(change.mean), 0.025);
    // interpolated lines treated as complete ones
    std::vector<ObservedSurface> filled;
    for (const auto& o : gapped) {
        auto copy = std::get<topography::HeightMap>(o.measurement);
        copy.heights = bridged_lines(copy.heights, "map").heights;
        filled.push_back({copy, o.trend});
    }
    EXPECT_LT(difference(all, fit(filled)).mean, -0.15);
}

constexpr double fine = 10e-9;

/// Lines of a strip that a sphere of 300 nm has read with noise, all points.
std::vector<Array1D> read_lines(std::uint64_t seed) {
    constexpr Index length = 2048, width = 512;
    auto strip = synthesis::random_surface(surface(), {length, width, length * fine, width * fine},
                                           {.key = {seed, 1}, .threads = {1}});
    strip = topography::dilated(strip, topography::SphereTip{300e-9});
    std::vector<Array1D> lines;
    for (const Index j : {0, 256}) {
        Array1D line = strip.heights.col(j);
        line += 3e-10 * numerics::normal_numbers({seed, static_cast<std::uint64_t>(10 + j)}, 0, length);
        lines.push_back(line);
    }
    return lines;
}

void by_stylus(topography::Metadata& metadata) {
    metadata.instrument.type = "stylus";
    metadata.instrument.tip_radius = 300e-9;
}

std::vector<ObservedSurface> scans(bool gapped) {
    std::vector<ObservedSurface> all;
    for (std::uint64_t seed : {11, 12})
        for (const auto& line : read_lines(seed)) {
            topography::LineScan scan{Array1D(line.size() / 2), static_cast<double>(line.size()) * fine, false, {}};
            for (Index i = 0; i < scan.heights.size(); ++i) scan.heights[i] = line[2 * i];
            if (gapped) scan.heights[300] = missing;
            by_stylus(scan.metadata);
            all.push_back({scan, topography::Trend::tilt});
        }
    return all;
}

/// Every first, second or third point of the lines.
std::vector<ObservedSurface> irregular_scans() {
    std::vector<ObservedSurface> all;
    for (std::uint64_t seed : {11, 12})
        for (const auto& line : read_lines(seed)) {
            std::vector<Index> places;
            for (Index i = 0; i < line.size();
                 i += 1 + static_cast<Index>(3.0 * numerics::uniform_number({seed, 5}, static_cast<std::uint64_t>(i))))
                places.push_back(i);
            topography::Profile curve{Array1D(std::ssize(places)), Array1D(std::ssize(places)), {}};
            for (Index p = 0; p < std::ssize(places); ++p) {
                curve.positions[p] = fine * static_cast<double>(places[static_cast<std::size_t>(p)]);
                curve.heights[p] = line[places[static_cast<std::size_t>(p)]];
            }
            by_stylus(curve.metadata);
            all.push_back({curve, topography::Trend::tilt});
        }
    return all;
}

// One undefined height turned a scan of a stylus into an ideal contour, without tip and noise.
TEST(LikelihoodSpectrum, OfAScanWithAGapIncludesTipAndNoise) {
    const auto whole = fit(scans(false)), gapped = fit(scans(true));
    EXPECT_FALSE(gapped.tips.empty());
    EXPECT_NEAR(gapped.C_iso.band.upper / whole.C_iso.band.upper, 1.0, 0.02);
    const auto change = difference(whole, gapped);
    EXPECT_LT(change.max_errors, 0.1);
    EXPECT_LT(std::abs(change.mean), 0.005);
}

TEST(LikelihoodSpectrum, OfIrregularStylusScansIncludesTipAndNoise) {
    const auto regular = fit(scans(false)), irregular = fit(irregular_scans());
    EXPECT_FALSE(irregular.tips.empty());
    EXPECT_LT(irregular.C_iso.band.upper, 0.5 * pi / fine);
    const auto change = difference(regular, irregular);
    EXPECT_LT(change.max_errors, 2.0);  // they contain points between the regular ones
    EXPECT_LT(std::abs(change.mean), 0.03);
}

}  // namespace
}  // namespace setae::spectral_fit::gapped_lines_test
