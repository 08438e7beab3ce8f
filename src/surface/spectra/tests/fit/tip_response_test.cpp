// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectral_fit/tip_response.hpp"

#include <cmath>
#include <complex>
#include <map>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/synthesis/random_surface.hpp"
#include "setae/topography/dilation.hpp"

namespace setae::spectral_fit::tip_response_test {
namespace {

/// Constant below 2π/1 µm, decreasing as q^-5 above, with a given rms slope.
spectra::SpectralDensity gentle(double slope) {
    const double bend = 2.0 * pi / 1e-6;
    // h'² = (1/2π) ∫ q³ C dq = (c/2π) (1/4 + 1) q_b⁴
    const double level = 2.0 * pi * slope * slope / (1.25 * std::pow(bend, 4));
    return [=](double q) { return level * (q < bend ? 1.0 : std::pow(q / bend, -5.0)); };
}

TipSimulation simulation(double radius) {
    return {.probe = sphere({.value = radius}),
            .step = 10e-9,
            .points = 512,
            .length = 512,
            .repetitions = 1,
            .correlation_length = 300e-9,
            .threads = {1}};
}

double at(const Array1D& x, const Array1D& y, double wavevector) {
    Index i = 0;
    (x - wavevector).abs().minCoeff(&i);
    return y[i];
}

TEST(TipResponse, OfATipThatReachesEveryPointIsOne) {
    const auto response = tip_response(gentle(0.01), simulation(50e-9));
    EXPECT_LT(response.log_transfer.abs().maxCoeff(), 2e-3);
}

// The same ratio from other surfaces, dilated as a whole and summed over modes without smoothing: four patches of
// sixteen lines a correlation length apart and thirteen modes determine it to 3.5 %, the simulation of T to as much.
TEST(TipResponse, PredictsThePowerRatioOfOtherDilatedSurfaces) {
    auto options = simulation(1e-6);
    options.repetitions = 4;
    options.size_response = false;
    const auto response = tip_response(gentle(0.1), options);
    constexpr Index n = 512, first = 10, last = 22;
    double plain = 0.0, read = 0.0;
    const auto band_power = [](const Array2D& heights) {
        double sum = 0.0;
        for (Index j = 0; j < n; j += 8)
            for (Index k = first; k <= last; ++k) {
                std::complex<double> mode = 0.0;
                for (Index i = 0; i < n; ++i)
                    mode += heights(i, j) * std::polar(1.0, -2.0 * pi * static_cast<double>(i * k) / n);
                sum += std::norm(mode);
            }
        return sum;
    };
    for (std::uint64_t r = 0; r < 4; ++r) {
        const auto surface = synthesis::random_surface(gentle(0.1), {n, n, n * options.step, n * options.step},
                                                       {.key = {77, r}, .threads = {1}});
        plain += band_power(surface.heights);
        read += band_power(topography::dilated(surface, topography::SphereTip{1e-6}, {.threads = {1}}).heights);
    }
    double expected = 0.0, weight = 0.0;
    for (Index k = first; k <= last; ++k) {
        const double q = 2.0 * pi * static_cast<double>(k) / (n * options.step), C1D = std::pow(q, -4.0);
        expected += C1D * std::exp(at(response.wavevector, response.log_transfer, q));
        weight += C1D;
    }
    EXPECT_LT(read / plain, 0.9);
    EXPECT_NEAR(read / plain, expected / weight, 0.09);
}

/// Constant below 2π/0.5 µm and as rough as possible for a sphere of 5 µm: slope 1.4 with waves down to 80 nm; below
/// 2e6 1/m `raised` times as much.
spectra::SpectralDensity rough(double raised) {
    const double bend = 2.0 * pi / 0.5e-6, end = 2.0 * pi / 80e-9;
    const auto shape = [=](double q) { return q > end ? 0.0 : q < bend ? 1.0 : std::pow(q / bend, -3.6); };
    double moment = 0.0;
    constexpr int pieces = 2000;
    for (int i = 0; i < pieces; ++i) {
        const double q = end * (i + 0.5) / pieces;
        moment += q * q * q * shape(q) * end / pieces / (2.0 * pi);
    }
    return [=](double q) { return 1.4 * 1.4 / moment * shape(q) * (q < 2e6 ? raised : 1.0); };
}

/// Power of the modes 3e5 … 1.8e6 1/m that a sphere of 5 µm reads along lines of strips 41 µm long, by testing every
/// point within its reach: independent of the dilation of the library.
double long_power_read(double raised) {
    constexpr Index nx = 2048, ny = 256, reach = 110, lines = 4, strips = 3;
    constexpr double step = 20e-9, radius = 5e-6;
    double power = 0.0;
    for (std::uint64_t strip = 0; strip < strips; ++strip) {
        const auto surface = synthesis::random_surface(rough(raised), {nx, ny, nx * step, ny * step},
                                                       {.key = {91, strip}, .threads = {2}});
        for (Index line = 0; line < lines; ++line) {
            const Index j = line * ny / lines;
            Array1D read = Array1D::Constant(nx, -1.0);
            for (Index dj = -reach; dj <= reach; ++dj)
                for (Index di = -reach; di <= reach; ++di) {
                    const double d = step * std::hypot(static_cast<double>(di), static_cast<double>(dj));
                    if (d > reach * step) continue;
                    const double lift = std::sqrt(radius * radius - d * d) - radius;
                    const Index row = (j + dj + ny) % ny, shift = (di + nx) % nx;
                    const auto column = surface.heights.col(row);
                    read.head(nx - shift) = read.head(nx - shift).max(column.tail(nx - shift) + lift);
                    if (shift > 0) read.tail(shift) = read.tail(shift).max(column.head(shift) + lift);
                }
            for (Index k = 2; k <= 11; ++k) {
                std::complex<double> mode = 0.0;
                for (Index i = 0; i < nx; ++i)
                    mode += read[i] * std::polar(1.0, -2.0 * pi * static_cast<double>(i * k) / nx);
                power += std::norm(mode);
            }
        }
    }
    return power;
}

/// C1D at q of a spectrum, or of the part followed by the tip: (1/π) ∫ a² C_iso dv, |q|² = q² + v².
double line_density(const TipResponse& response, const spectra::SpectralDensity& C_iso, double q, bool followed) {
    constexpr int pieces = 4000;
    const double end = 2.0 * pi / 80e-9;
    double sum = 0.0;
    for (int i = 0; i < pieces; ++i) {
        const double k = std::hypot(q, end * (i + 0.5) / pieces);
        sum += C_iso(k) * (followed ? std::exp(at(response.wavevector, response.log_followed, k)) : 1.0);
    }
    return sum * end / pieces / pi;
}

// A sphere follows long waves, but long waves of a line are mostly oblique short ones, which the sphere replaces by its
// own power; this is unchanged if long waves are raised ninefold. The same strips with and without determine the ratio
// to a tenth.
TEST(TipResponse, IncludesPowerAddedToLongWaves) {
    const auto response = tip_response(rough(1.0), {.probe = sphere({.value = 5e-6}),
                                                    .step = 20e-9,
                                                    .points = 512,
                                                    .length = 2048,
                                                    .repetitions = 4,
                                                    .size_response = false,
                                                    .correlation_length = 0.25e-6,
                                                    .threads = {2}});
    const auto read = [&](double raised) {
        double power = 0.0;
        for (int k = 2; k <= 11; ++k) {
            const double q = 2.0 * pi * k / (2048 * 20e-9);
            power += line_density(response, rough(raised), q, true) +
                     std::exp(at(response.wavevector, response.log_added, q));
        }
        return power;
    };
    const double q = 8e5, of_surface = line_density(response, rough(1.0), q, false);
    EXPECT_GT(std::exp(at(response.wavevector, response.log_added, q)), 0.6 * of_surface);
    EXPECT_LT(line_density(response, rough(1.0), q, true), 0.3 * of_surface);
    EXPECT_GT(at(response.wavevector, response.log_followed, q), std::log(0.5));
    EXPECT_GT(line_density(response, rough(9.0), q, false), 1.8 * of_surface);
    const double expected = read(9.0) / read(1.0);
    const double found = long_power_read(9.0) / long_power_read(1.0);
    EXPECT_NEAR(found / expected, 1.0, 0.2) << found;
}

/// Linear in ln q.
double between(const Array1D& x, const Array1D& y, double wavevector) {
    Index i = 1;
    while (x[i] < wavevector) ++i;
    const double share = std::log(wavevector / x[i - 1]) / std::log(x[i] / x[i - 1]);
    return y[i - 1] + share * (y[i] - y[i - 1]);
}

/// Constant below 2π/1 µm, decreasing as q^-3.6 to waves of 50 nm, rms slope 1.2.
double knee(double q) {
    constexpr double bend = 2.0 * pi / 1e-6, end = 2.0 * pi / 50e-9;
    // h'² = (1/2π) ∫ q³ C dq
    const double moment = std::pow(bend, 4) * (0.25 + (std::pow(end / bend, 0.4) - 1.0) / 0.4) / (2.0 * pi);
    return q > end ? 0.0 : 1.44 / moment * (q < bend ? 1.0 : std::pow(q / bend, -3.6));
}

// Where T decreases from 0.8 to 0.3, steep in ln q: the followed and the added part are interpolated there, and every
// interpolation below its curve loses power. Line-by-line readings of the sphere on the patches of the simulation have
// no such loss; the rest are deviations of the patches from C_iso in the followed part, 0.5 %.
TEST(TipResponse, LosesNoPowerByInterpolation) {
    constexpr Index nx = 2048, ny = 1024, stride_x = 2, stride_y = 8, first = 9, last = 25;
    constexpr int patches = 8;
    constexpr double step = 25e-9, radius = 5e-6, length = nx * step;
    const auto response = tip_response(knee, {.probe = sphere({.value = radius}),
                                              .step = step,
                                              .points = ny,
                                              .length = nx,
                                              .repetitions = patches,
                                              .size_response = false,
                                              .correlation_length = 0.6e-6,
                                              .seed = 5,
                                              .threads = {2}});
    std::map<Index, double> read;  // C1D by mode
    for (std::uint64_t patch = 0; patch < patches; ++patch) {
        const auto surface =
            synthesis::random_surface(knee, {nx, ny, length, ny * step}, {.key = {5, patch}, .threads = {2}});
        const topography::Dilator touched(surface, topography::SphereTip{radius}, {.threads = {2}});
        const Array1D x = Array1D::LinSpaced(nx / stride_x, 0.0, length - stride_x * step);
        for (Index line = 0; line < ny; line += stride_y) {
            const Array1D heights = touched.readings(x, Array1D::Constant(x.size(), static_cast<double>(line) * step));
            for (Index k = first; k <= last; ++k) {
                const auto turn = std::polar(1.0, -2.0 * pi * static_cast<double>(k) / static_cast<double>(x.size()));
                std::complex<double> mode = 0.0, phase = 1.0;
                for (Index i = 0; i < x.size(); ++i, phase *= turn) mode += heights[i] * phase;
                read[k] += std::norm(mode * (stride_x * step)) / length / (patches * ny / stride_y);
            }
        }
    }
    double expected = 0.0, found = 0.0;
    for (const auto& [k, density] : read) {
        const double q = 2.0 * pi * static_cast<double>(k) / length;
        expected +=
            line_density(response, knee, q, false) * std::exp(between(response.wavevector, response.log_transfer, q));
        found += density;
    }
    EXPECT_NEAR(expected / found, 1.0, 0.012);
}

// Smoothing is linear, so differences of ln T between two radii, or two amplitudes, are exactly the derivatives.
TEST(TipResponse, DerivativesEqualDifferences) {
    const auto C_iso = gentle(0.1);
    const auto response = tip_response(C_iso, simulation(1e-6)), blunter = tip_response(C_iso, simulation(1.1e-6)),
               higher = tip_response([&](double q) { return 1.2 * C_iso(q); }, simulation(1e-6));
    EXPECT_NEAR(
        ((blunter.log_transfer - response.log_transfer) / std::log(1.1) - response.size_response).abs().maxCoeff(), 0.0,
        1e-9);
    EXPECT_NEAR(
        ((higher.log_followed - response.log_followed) / std::log(1.2) - response.followed_response).abs().maxCoeff(),
        0.0, 1e-9);
    EXPECT_NEAR(((higher.log_added - response.log_added) / std::log(1.2) - response.added_response).abs().maxCoeff(),
                0.0, 1e-9);
    EXPECT_LT(at(response.wavevector, response.size_response, 2.0 * pi / 300e-9), -0.05);
}

// A sphere touches peaks and cannot enter valleys: it loses less of peaks, and reads heights more skewed than they are.
TEST(TipResponse, KeepsMoreOfPeaksThanOfValleys) {
    auto peaks = simulation(1e-6), valleys = peaks, gaussian = peaks;
    peaks.skewness = 0.8;
    valleys.skewness = -0.8;
    gaussian.skewness_response = true;
    const auto C_iso = gentle(0.1);
    const double q = 2.0 * pi / 600e-9;
    const auto of_gaussian = tip_response(C_iso, gaussian);
    const auto loss = [&](const TipResponse& r) { return at(r.wavevector, r.log_transfer, q); };
    EXPECT_GT(loss(tip_response(C_iso, peaks)), loss(of_gaussian) + 0.02);
    EXPECT_LT(loss(tip_response(C_iso, valleys)), loss(of_gaussian) - 0.02);
    EXPECT_GT(at(of_gaussian.wavevector, of_gaussian.skewness_response, q), 0.02);
    EXPECT_GT(added_skewness(C_iso, gaussian), 0.02);
}

TEST(TipResponse, UpdateKeepsTheDerivatives) {
    const auto first = tip_response(gentle(0.02), simulation(1e-6));
    const auto again = tip_response(gentle(0.021), simulation(1e-6), first);
    EXPECT_TRUE((again.followed_response == first.followed_response).all());
    EXPECT_TRUE((again.added_response == first.added_response).all());
    EXPECT_TRUE((again.size_response == first.size_response).all());
    // they agree with the expectation from the derivatives
    const double q = 2.0 * pi / 400e-9, change = std::log(1.05 * 1.05);
    const auto expected = [&](const Array1D& values, const Array1D& slope) {
        return at(first.wavevector, values, q) + change * at(first.wavevector, slope, q);
    };
    EXPECT_NEAR(at(again.wavevector, again.log_followed, q), expected(first.log_followed, first.followed_response),
                2e-3);
    EXPECT_NEAR(at(again.wavevector, again.log_added, q), expected(first.log_added, first.added_response), 0.02);
}

TEST(TipResponse, IsTheSameForAnyNumberOfThreads) {
    auto two = simulation(1e-6);
    two.threads = {2};
    two.repetitions = 2;
    auto one = two;
    one.threads = {1};
    const auto a = tip_response(gentle(0.05), one), b = tip_response(gentle(0.05), two);
    EXPECT_TRUE((a.log_transfer == b.log_transfer).all());
    EXPECT_TRUE((a.simulation_errors == b.simulation_errors).all());
}

// Two repetitions a and b: the mean is uncertain by ± (a − b)/2, each mode with its own sign.
TEST(TipResponse, StatesTheNoiseOfItsSimulation) {
    auto options = simulation(1e-6);
    EXPECT_EQ(tip_response(gentle(0.1), options).simulation_errors.rows(), 0);
    options.repetitions = 2;
    const auto errors = tip_response(gentle(0.1), options).simulation_errors;
    ASSERT_EQ(errors.rows(), 2);
    EXPECT_GT(errors.row(0).abs().maxCoeff(), 1e-4);
    EXPECT_LT((errors.row(0) + errors.row(1)).abs().maxCoeff(), 1e-12);
}

TEST(TipResponse, RefusesImpossibleTips) {
    EXPECT_THROW((void)tip_response(gentle(0.1), simulation(0.0)), InvalidArgument);
    auto without_step = simulation(1e-6);
    without_step.step = 0.0;
    EXPECT_THROW((void)tip_response(gentle(0.1), without_step), InvalidArgument);
}

// A line read every pixel: aliases are weighted with their C1D. Two waves, one of them an alias of the other.
TEST(SampledResponse, WeightsAliasesByTheirPower) {
    TipResponse response;
    response.wavevector = Array1D::LinSpaced(2, 1e6, 9e6);
    response.log_transfer = Array1D(2);
    response.log_transfer << 0.0, std::log(0.5);
    response.log_followed = response.log_added = response.log_transfer;
    response.added_response = response.followed_response = response.size_response = response.skewness_response =
        Array1D::Zero(2);
    const double pixel = 2.0 * pi / 10e6;  // 1e6 and 9e6 are aliases
    const auto C1D = [](double q) { return std::abs(q - 1e6) < 1.0 ? 3.0 : std::abs(q - 9e6) < 1.0 ? 1.0 : 0.0; };
    const auto found = sampled(response, C1D, pixel, Array1D::Constant(1, 1e6));
    EXPECT_NEAR(std::exp(found.log_transfer[0]), (3.0 + 0.5) / 4.0, 1e-12);
}

TEST(SimulationStep, IsTheSmallerOfWaveAndTipAboveTheRequestedMinimum) {
    EXPECT_DOUBLE_EQ(simulation_step(sphere({.value = 10e-9}), 1e-6, 2e-10, 1024), 0.5e-9);
    EXPECT_DOUBLE_EQ(simulation_step(sphere({.value = 5e-6}), 1e-6, 2e-10, 1024), 20e-9);
    EXPECT_DOUBLE_EQ(simulation_step(sphere({.value = 1e-9}), 1e-6, 2e-10, 1024), 2e-10);
}

}  // namespace
}  // namespace setae::spectral_fit::tip_response_test
