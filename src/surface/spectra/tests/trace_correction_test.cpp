// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Cholesky>

#include "setae/core/constants.hpp"
#include "setae/spectra/polyline.hpp"
#include "setae/spectra/power_spectrum.hpp"
#include "setae/synthesis/random_surface.hpp"
#include "setae/topography/trace_response.hpp"
#include "setae/topography/traced_curve.hpp"

namespace trace_correction_test {

using namespace setae;
using namespace setae::spectra;
using topography::Profile;
using topography::TraceResponse;

/// Mean step 1 m; C1D = 10 N at q = 0.30.
constexpr TraceResponse response{0.8, 1.2, 1.0, 1e-5};
constexpr Index points = 1025;

double truth(double q) { return std::pow(1.0 + std::pow(q / 0.02, 2), -1.7); }

double transfer(double q) { return topography::trace_transfer(response, Array1D::Constant(1, q))[0]; }

topography::LineScan line(const spectra::SpectralDensity& C1D, Index refinement, std::uint64_t seed) {
    synthesis::SurfaceOptions options;
    options.key.seed = seed;
    return synthesis::random_line(C1D, {4096 * refinement, 4096.0}, options);
}

/// A curve of true spectrum as traced: blurred, smoothed, with smoothed point-to-point noise.
Profile traced(std::uint64_t seed, bool irregular, bool noisy = true) {
    const Index refinement = irregular ? 4 : 1;
    const auto curve =
        line([](double q) { return q > pi ? 0.0 : std::pow(transfer(q), 2) * truth(q); }, refinement, 2 * seed);
    const auto noise = line(
        [](double q) {
            return std::pow(topography::smoothing_transfer(response, Array1D::Constant(1, q))[0], 2) *
                   response.noise_density;
        },
        1, 2 * seed + 1);
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<Index> step(3, 5);
    Profile profile{Array1D(points), Array1D(points), {}};
    for (Index i = 0, at = 0; i < points; ++i, at += irregular ? step(random) : refinement) {
        profile.positions[i] = static_cast<double>(at) / static_cast<double>(refinement);
        profile.heights[i] = curve.heights[at] + (noisy ? noise.heights[i] : 0.0);
    }
    profile.response = response;
    if (!noisy) profile.response->noise_density = 0.0;
    return profile;
}

struct HalfDecade {
    double mean = 0.0, error = 0.0;  ///< of C1D over the true value
};

/// Over curves, between neighbouring edges.
std::vector<HalfDecade> ratios_to_truth(const std::vector<double>& edges, bool irregular,
                                        const SpectrumOptions& options, int curves, bool noisy = true) {
    std::vector<double> sums(edges.size() - 1, 0.0), squares = sums;
    for (int seed = 0; seed < curves; ++seed) {
        const auto spectrum = power_spectrum(traced(static_cast<std::uint64_t>(seed), irregular, noisy), options);
        for (std::size_t i = 0; i < sums.size(); ++i) {
            double ratio = 0.0, modes = 0.0;
            for (Index k = 0; k < spectrum.wavevector.size(); ++k) {
                const double q = spectrum.wavevector[k];
                if (q < edges[i] || q >= edges[i + 1]) continue;
                ratio += spectrum.density[k] / truth(q);
                modes += 1.0;
            }
            sums[i] += ratio / modes;
            squares[i] += std::pow(ratio / modes, 2);
        }
    }
    std::vector<HalfDecade> found;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const double mean = sums[i] / curves;
        found.push_back({mean, std::sqrt((squares[i] / curves - mean * mean) / (curves - 1))});
    }
    return found;
}

void expect_truth(bool irregular) {
    const double end = 0.3, half = std::sqrt(10.0);
    for (const auto& found : ratios_to_truth({end / (half * half), end / half, end}, irregular, {}, 100)) {
        EXPECT_NEAR(found.mean, 1.0, 0.10);
        EXPECT_NEAR(found.mean, 1.0, 2.0 * found.error);
    }
}

TEST(TraceCorrection, RemovesNoiseBlurAndSmoothingForEqualSteps) { expect_truth(false); }

TEST(TraceCorrection, RemovesNoiseBlurAndSmoothingForIrregularSteps) { expect_truth(true); }

TEST(TraceCorrection, RemovesNoiseAlongNormalsAndSmoothingAlongTheCurve) {
    // points at equal lengths of curves of rms slope 0.4, displaced along their normals, both coordinates smoothed
    // along the curve
    constexpr Index n = 400, refinement = 8;
    const double sigma = 0.1, smoothing = 0.8;
    const auto C1D = [](double q) { return q > 2.0 ? 0.0 : 3000.0 * std::pow(1.0 + std::pow(q / 0.05, 2), -1.7); };
    Eigen::MatrixXd differences = Eigen::MatrixXd::Zero(n - 2, n);
    for (Index i = 0; i + 2 < n; ++i) differences.row(i).segment(i, 3) << 1.0, -2.0, 1.0;
    const Eigen::LLT<Eigen::MatrixXd> smoother(Eigen::MatrixXd::Identity(n, n) +
                                               std::pow(smoothing, 4) * differences.transpose() * differences);
    const std::vector<double> edges{0.08, 0.08 * std::sqrt(10.0), 0.8};
    double sums[2] = {0.0, 0.0}, counts[2] = {0.0, 0.0};
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        synthesis::SurfaceOptions options;
        options.key.seed = seed;
        const auto fine = synthesis::random_line(C1D, {1024 * refinement, 1024.0}, options);
        std::mt19937_64 random(seed);
        std::normal_distribution<double> normal;
        Eigen::MatrixXd curve(n, 2);
        double along = 0.0;
        for (Index i = 1, k = 0; k < n; ++i) {
            const double dx = 1.0 / refinement, dy = fine.heights[i] - fine.heights[i - 1], length = std::hypot(dx, dy);
            for (; k < n && along + length >= static_cast<double>(k); ++k) {
                const double t = (static_cast<double>(k) - along) / length, shift = sigma * normal(random);
                curve(k, 0) = (static_cast<double>(i - 1) + t) * dx - shift * dy / length;
                curve(k, 1) = fine.heights[i - 1] + t * dy + shift * dx / length;
            }
            along += length;
        }
        const Eigen::MatrixXd smooth = smoother.solve(curve);
        topography::TracedCurve trace;
        trace.x = smooth.col(0).array();
        trace.y = smooth.col(1).array();
        trace.standard_error = Array1D::Constant(n, sigma);
        trace.response = TraceResponse{0.0, smoothing, 1.0, sigma * sigma};
        const auto spectrum = power_spectrum(topography::levelled(trace, topography::Reentrance::envelope).profile);
        for (Index k = 0; k < spectrum.wavevector.size(); ++k)
            for (std::size_t i = 0; i < 2; ++i)
                if (spectrum.wavevector[k] >= edges[i] && spectrum.wavevector[k] < edges[i + 1]) {
                    sums[i] += spectrum.density[k] / C1D(spectrum.wavevector[k]);
                    counts[i] += 1.0;
                }
    }
    // periodograms with a Hann window: two modes are equivalent to about one
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_NEAR(sums[i] / counts[i], 1.0, std::max(0.1, 2.0 * std::sqrt(2.0 / counts[i]))) << i;
}

TEST(TraceCorrection, IsNecessaryAndCanBeDisabled) {
    SpectrumOptions as_traced;
    as_traced.trace_response = false;
    // blur and smoothing lower the spectrum, noise raises it; a remaining deviation would be accidental
    const auto smooth = ratios_to_truth({0.3, 0.45}, false, as_traced, 40, false),
               both = ratios_to_truth({0.3, 0.45}, false, as_traced, 40);
    EXPECT_LT(smooth[0].mean, 0.9);
    EXPECT_GT(both[0].mean, smooth[0].mean + 0.1);
    const auto profile = traced(1, false);
    auto unknown = profile;
    unknown.response.reset();
    const auto left_out = power_spectrum(profile, as_traced), plain = power_spectrum(unknown);
    EXPECT_TRUE((left_out.density == plain.density).all());
    EXPECT_EQ(left_out.band.upper, plain.band.upper);
    EXPECT_EQ(left_out.alerts.size(), plain.alerts.size());
}

TEST(TraceCorrection, EndsTheBandWhereNoiseDominates) {
    // C1D = 2 N exp((q blur)²) is true at q = 0.46
    std::vector<double> ends;
    for (std::uint64_t seed = 0; seed < 30; ++seed) ends.push_back(power_spectrum(traced(seed, false)).band.upper);
    std::sort(ends.begin(), ends.end());
    const double crossing = 0.46;
    EXPECT_NEAR(truth(crossing) / response.noise_density / std::exp(std::pow(crossing * response.blur, 2)), 2.0, 0.2);
    EXPECT_NEAR(ends[15], crossing, 0.1 * crossing);
    EXPECT_GT(ends.front(), 0.7 * crossing);
    EXPECT_LT(ends.back(), 1.3 * crossing);
}

TEST(TraceCorrection, EndsTheBandWhereBlurLeavesATenth) {
    const auto spectrum = power_spectrum(traced(3, false, false));
    const double end = topography::trace_band_end(response);
    EXPECT_LE(spectrum.band.upper, end);
    EXPECT_GT(spectrum.band.upper, end - 2.0 * spectrum.wavevector[0]);
    EXPECT_NEAR(std::pow(transfer(end), 2), 0.1, 1e-9);
}

TEST(TraceCorrection, ReportsTheCorrection) {
    const auto spectrum = power_spectrum(traced(4, false));
    const auto alert = std::find_if(spectrum.alerts.begin(), spectrum.alerts.end(),
                                    [](const auto& a) { return a.code == "TRACE_NOISE"; });
    ASSERT_NE(alert, spectrum.alerts.end());
    EXPECT_NE(alert->message.find("1.00×10⁻⁵ m³"), std::string::npos) << alert->message;
    // at the end of the band a third of the remaining traced power is noise
    EXPECT_NE(alert->message.find("noise was 3"), std::string::npos) << alert->message;
}

TEST(TraceCorrection, FindsTheBandForChosenWavevectors) {
    const auto profile = traced(5, false);
    SpectrumOptions chosen;
    chosen.wavevectors = Array1D{{0.7, 0.1, 0.3}};
    const auto some = power_spectrum(profile, chosen), all = power_spectrum(profile);
    EXPECT_EQ(some.band.upper, all.band.upper);
    ASSERT_FALSE(some.alerts.empty());
    EXPECT_EQ(some.alerts[0].message, all.alerts[0].message);
}

TEST(TraceCorrection, OfSegmentsSubtractsTheirShareOfTheNoise) {
    // only noise between equal steps, treated as segments: zero on average
    SpectrumOptions segments;
    segments.contour = ContourTreatment::segments;
    double sum = 0.0;
    constexpr int curves = 60;
    for (std::uint64_t seed = 0; seed < curves; ++seed) {
        Profile noise{Array1D::LinSpaced(points, 0.0, points - 1.0), Array1D(points), {}};
        noise.response = response;
        noise.heights =
            line(
                [](double q) {
                    return std::pow(topography::smoothing_transfer(response, Array1D::Constant(1, q))[0], 2) * 1e-5;
                },
                1, seed)
                .heights.head(points);
        const auto spectrum = power_spectrum(noise, segments);
        sum += spectrum.density.segment(100, 200).mean() / curves;
        if (spectrum.band.upper == 0.0) {
            EXPECT_NE(spectrum.alerts[0].message.find("exceeds all waves"), std::string::npos);
        }
    }
    // 200 modes of 60 curves, each scattering by about N
    EXPECT_NEAR(sum / response.noise_density, 0.0, 3.0 * 1.6 / std::sqrt(200.0 * curves));
}

}  // namespace trace_correction_test
