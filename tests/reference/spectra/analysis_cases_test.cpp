// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analysis_cases.hpp"
#include "setae/spectra/isotropic.hpp"
#include "setae/spectra/polyline.hpp"
#include "setae/spectra/power_spectrum.hpp"
#include "setae/spectra/reliability.hpp"

namespace analysis_cases_test {

using namespace setae;
using namespace setae::spectra;
using nlohmann::json;
using tests::AnalysisCases;
using tests::matrix;
using tests::series;
using topography::HeightMap;
using topography::LineScan;
using topography::Profile;
using topography::Trend;

/// Modes 1 … n/2 − 1, which both have; 1e-10 of the values, or of the rounding floor of the largest.
void expect_modes(const MeasuredSpectrum& spectrum, const json& expected) {
    const Array1D q = series(expected[0]), C = series(expected[1]);
    ASSERT_LE(q.size() - 1, spectrum.density.size());
    for (Index k = 1; k < q.size(); ++k) {
        EXPECT_NEAR(spectrum.wavevector[k - 1] / q[k], 1.0, 1e-12);
        EXPECT_NEAR(spectrum.density[k - 1], C[k], 1e-10 * C[k]) << "mode " << k;
    }
}

/// The cases keep whatever mean the heights have.
SpectrumOptions as_is(Window window) { return {.window = window, .trend = Trend::none}; }

TEST_F(AnalysisCases, LineScanSpectraAgree) {
    for (const char* name : {"profile_nonperiodic", "profile_periodic"}) {
        const auto scan = line_scan(name);
        expect_modes(power_spectrum(scan, as_is(Window::none)), cases[name]["psd_raw_window_None"]);
        expect_modes(power_spectrum(scan, as_is(Window::hann)), cases[name]["psd_raw_hann"]);
    }
}

TEST_F(AnalysisCases, MapsAsLineScansAgree) {
    for (const char* name : {"map_nonperiodic", "map_periodic"}) {
        const auto map = height_map(name);
        expect_modes(power_spectrum(map, as_is(Window::none)), cases[name]["psd_profile_raw_None"]);
        expect_modes(power_spectrum(map, as_is(Window::hann)), cases[name]["psd_profile_raw_hann_direction_x"]);
        expect_modes(power_spectrum(map, as_is(Window::automatic)), cases[name]["psd_profile_raw_default_window"]);
    }
}

TEST_F(AnalysisCases, SpectrumMapsAgree) {
    for (const char* name : {"map_nonperiodic", "map_periodic"}) {
        const auto map = height_map(name);
        const Array2D expected = matrix(cases[name]["psd_area_map_None"]);
        const Array2D spectrum = power_spectrum_map(map, as_is(Window::none));
        EXPECT_LT(((spectrum - expected) / expected).abs().maxCoeff(), 1e-10);
    }
}

TEST_F(AnalysisCases, PolylineSpectraAgree) {
    const auto profile = polyline();
    const auto& recorded = cases["nonuniform"]["psd_brute_None"];
    const Array1D q = series(recorded[0]), expected = series(recorded[1]);
    EXPECT_LT((polyline_power_spectrum(profile, q, Window::none) / expected - 1.0).abs().maxCoeff(), 1e-10);
}

TEST_F(AnalysisCases, PolylineSpectraWithWindowedPointsAgree) {
    // the package multiplies the points by the window and joins the products by straight lines
    auto profile = polyline();
    const Array1D phase = (profile.positions - profile.positions[0]) * (2.0 * std::acos(-1.0) / profile.size());
    profile.heights *= std::sqrt(2.0 / 3.0) * (1.0 - phase.cos());
    const Array1D q = series(cases["nonuniform"]["psd_brute_hann"][0]),
                  expected = series(cases["nonuniform"]["psd_brute_hann"][1]);
    EXPECT_LT((polyline_power_spectrum(profile, q, Window::none) / expected - 1.0).abs().maxCoeff(), 1e-10);
}

/// Smallest second difference along x by the definition, one stencil after the other; lines closer to an end in y than
/// margin [m] are left out.
double sharpest(const HeightMap& map, double length, double margin = 0.0) {
    const Index n = map.heights.rows();
    const double reach = 0.5 * length / map.pixel_size()[0], reach_y = margin / map.pixel_size()[1];
    const auto height = [&](double place, Index j) {
        const double floor = std::floor(place), t = place - floor;
        const auto i = static_cast<Index>(floor);
        return (1.0 - t) * map.heights((i + n) % n, j) + t * map.heights((i + 1 + n) % n, j);
    };
    double least = 1e300;
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < map.heights.cols(); ++j) {
            const auto x = static_cast<double>(i);
            const auto y = static_cast<double>(j);
            if (y < reach_y || y + reach_y > static_cast<double>(map.heights.cols() - 1)) continue;
            if (!map.periodic && (x - reach < 0.0 || x + reach > static_cast<double>(n - 1))) continue;
            least = std::min(
                least, (height(x - reach, j) - 2.0 * height(x, j) + height(x + reach, j)) / (0.25 * length * length));
        }
    return least;
}

/// The package finds some root of the criterion, setae the largest; of non-periodic maps the package leaves out lines
/// closer than half a stencil to an end in y, which setae uses: its value is a root without them, setae's with them.
void expect_cutoff(const topography::Measurement& measurement, const HeightMap& map, double radius,
                   double nothing_reliable, const json& expected) {
    const auto cutoff = tip_cutoff(measurement, radius);
    if (expected.is_null()) {
        EXPECT_EQ(cutoff.status, CutoffStatus::all_reliable) << "R = " << radius;
    } else if (expected.get<double>() >= nothing_reliable) {
        EXPECT_EQ(cutoff.status, CutoffStatus::nothing_reliable) << "R = " << radius;
    } else {
        const bool margin = !map.periodic && map.heights.cols() > 1;
        const double length = expected;
        EXPECT_NEAR(-2.0 * radius * sharpest(map, length, margin ? 0.5 * length : 0.0), 1.0, 1e-6) << "R = " << radius;
        EXPECT_NEAR(-2.0 * radius * sharpest(map, cutoff.value), 1.0, 1e-6) << "R = " << radius;
        EXPECT_GT(cutoff.value / expected.get<double>(), 1.0 - 1e-7) << "R = " << radius;
        for (double longer = 1.001 * cutoff.value; longer < 0.5 * map.size[0]; longer *= 1.01)
            EXPECT_LT(-2.0 * radius * sharpest(map, longer), 1.0) << "R = " << radius << ", l = " << longer;
    }
}

TEST_F(AnalysisCases, TipCutoffsAgree) {
    for (const char* name : {"profile_nonperiodic", "profile_periodic"}) {
        const auto scan = line_scan(name);
        for (const std::string radius : {"0.5", "1.0", "2.0", "5.0", "20.0"})
            expect_cutoff(scan, {scan.heights, {scan.size, 1.0}, scan.periodic, {}}, std::stod(radius), scan.size,
                          cases[name]["tip_cutoff_R" + radius]);
    }
    for (const char* name : {"map_nonperiodic", "map_periodic"}) {
        const auto map = height_map(name);
        for (const std::string radius : {"1.0", "5.0", "20.0"})
            expect_cutoff(map, map, std::stod(radius), 0.5 * (map.size[0] + map.size[1]),
                          cases[name]["tip_cutoff_R" + radius]);
    }
}

}  // namespace analysis_cases_test
