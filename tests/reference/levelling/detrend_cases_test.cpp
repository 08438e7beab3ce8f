// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "analysis_cases.hpp"
#include "setae/core/constants.hpp"
#include "setae/processing/pipeline.hpp"
#include "setae/processing/step_text.hpp"

namespace detrend_cases_test {

using namespace setae;
using namespace setae::processing;
using nlohmann::json;
using tests::AnalysisCases;
using tests::matrix;
using tests::series;
using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

class DetrendCases : public AnalysisCases {};

template <class M>
M after(std::initializer_list<const char*> steps, const M& measurement) {
    Pipeline pipeline;
    for (const char* step : steps) pipeline.entries.push_back({step_from_text(step)});
    return std::get<M>(processing::apply(pipeline, topography::Measurement(measurement)).measurement);
}

/// Equal to 1e-10 of the largest, undefined at the same places.
template <class A>
void expect_same(const A& ours, const A& theirs, const char* what) {
    ASSERT_EQ(ours.rows(), theirs.rows());
    ASSERT_EQ(ours.cols(), theirs.cols());
    EXPECT_TRUE((ours.isNaN() == theirs.isNaN()).all()) << what;
    const A defined = theirs.isNaN().select(0.0, theirs), difference = theirs.isNaN().select(0.0, ours - theirs);
    EXPECT_LT(difference.abs().maxCoeff(), 1e-10 * defined.abs().maxCoeff()) << what;
}

const std::vector<std::pair<const char*, const char*>> detrends{{"detrend_center", "level_mean"},
                                                                {"detrend_height", "level_plane"},
                                                                {"detrend_rms-tilt", "level_plane"},
                                                                {"detrend_curvature", "level_polynomial"},
                                                                {"detrend_rms-curvature", "level_polynomial"}};

TEST_F(DetrendCases, OfALineAgreeWithSurfaceTopography) {
    for (const char* name : {"profile_nonperiodic", "profile_periodic"}) {
        const auto& expected = cases[name];
        const LineScan scan{series(expected["input"]["heights"]),
                            expected["input"]["physical_size"],
                            expected["input"]["periodic"],
                            {}};
        for (const auto& [theirs, ours] : detrends)
            expect_same(after({ours}, scan).heights, series(expected[theirs]), theirs);
    }
}

TEST_F(DetrendCases, OfAPolylineAgreeWithSurfaceTopography) {
    const auto& expected = cases["nonuniform"];
    const Profile profile{series(expected["input"]["x"]), series(expected["input"]["h"]), {}};
    expect_same(after({"level_mean"}, profile).heights, series(expected["detrend_center"]), "detrend_center");
    expect_same(after({"level_plane"}, profile).heights, series(expected["detrend_height"]), "detrend_height");
}

/// ∫ (h − p)² dx of the polyline, Gauss's rule of three points on each segment.
template <class Polynomial>
double mean_square(const Profile& profile, const Polynomial& p) {
    double sum = 0.0;
    for (Index i = 0; i + 1 < profile.positions.size(); ++i)
        for (const auto& [node, weight] : {std::pair{-std::sqrt(0.6), 5.0 / 18.0}, std::pair{0.0, 8.0 / 18.0},
                                           std::pair{std::sqrt(0.6), 5.0 / 18.0}}) {
            const double share = 0.5 * (1.0 + node), length = profile.positions[i + 1] - profile.positions[i];
            const double x = profile.positions[i] + share * length,
                         h = profile.heights[i] + share * (profile.heights[i + 1] - profile.heights[i]);
            sum += weight * length * std::pow(h - p(x), 2);
        }
    return sum;
}

TEST_F(DetrendCases, ParabolaOfAPolylineIsCloserThanInSurfaceTopography) {
    // the peer minimises the rms of the polyline through the residuals at the points, which changes where collinear
    // points are added
    const auto& expected = cases["nonuniform"];
    const Profile profile{series(expected["input"]["x"]), series(expected["input"]["h"]), {}};
    const auto ours = fitted_polynomial(profile, {.total = 2});
    const Array1D theirs = profile.heights - series(expected["detrend_curvature"]);
    const Index n = theirs.size(), middle = n / 2;
    // their parabola through three of its points
    const auto parabola = [&](double x) {
        const std::array<Index, 3> at{0, middle, n - 1};
        double value = 0.0;
        for (const auto a : at) {
            double term = theirs[a];
            for (const auto b : at)
                if (b != a) term *= (x - profile.positions[b]) / (profile.positions[a] - profile.positions[b]);
            value += term;
        }
        return value;
    };
    EXPECT_NEAR(parabola(profile.positions[3]), theirs[3], 1e-12);
    const double our_square = mean_square(profile, [&](double x) { return ours.value(x); }),
                 their_square = mean_square(profile, parabola);
    EXPECT_LT(our_square, their_square);
    EXPECT_NEAR(our_square / their_square, 1.0, 1e-6);
}

TEST_F(DetrendCases, OfAMapAgreeWithSurfaceTopography) {
    const auto input = height_map("map_nonperiodic");
    const auto& expected = cases["map_nonperiodic"];
    for (const auto& [theirs, ours] : detrends)
        if (expected.contains(theirs)) expect_same(after({ours}, input).heights, matrix(expected[theirs]), theirs);
    // theirs: h = c0 + c1 x/sx + c2 y/sy (+ c3 (x/sx)² + c4 (y/sy)² + c5 xy/(sx sy))
    const auto plane = fitted_polynomial(input, {.total = 1});
    const auto tilt = series(expected["detrend_height_coeffs"]);
    EXPECT_NEAR(plane.mean_slope()[0], tilt[1] / input.size[0], 1e-10);
    EXPECT_NEAR(plane.mean_slope()[1], tilt[2] / input.size[1], 1e-10);
    EXPECT_NEAR(plane.value(0.0, 0.0), tilt[0], 1e-10);
    const auto paraboloid = fitted_polynomial(input, {.total = 2});
    const auto c = series(expected["detrend_curvature_coeffs"]);
    EXPECT_NEAR(paraboloid.mean_curvature()[0], 2.0 * c[3] / std::pow(input.size[0], 2), 1e-10);
    EXPECT_NEAR(paraboloid.mean_curvature()[1], 2.0 * c[4] / std::pow(input.size[1], 2), 1e-10);
    EXPECT_NEAR(paraboloid.value(input.size[0], input.size[1]), c.sum(), 1e-10);
}

TEST_F(DetrendCases, OfAMaskedMapAgreeWithSurfaceTopography) {
    expect_same(after({"level_plane"}, masked_map()).heights, matrix(cases["map_masked"]["detrend_height"]), "masked");
}

TEST_F(DetrendCases, AlignmentOfScanLinesAgreesUpToAConstant) {
    const auto input = height_map("map_nonperiodic");
    for (const std::string direction : {"x", "y"}) {
        const auto level = "level_lines direction=" + direction, align = "align_rows direction=" + direction;
        Array2D ours = after({level.c_str(), align.c_str()}, input).heights,
                theirs = matrix(cases["map_nonperiodic"]["scan_line_align_" + direction + "_median_deg1"]);
        ours -= ours.mean();
        theirs -= theirs.mean();
        expect_same(ours, theirs, direction.c_str());
    }
}

}  // namespace detrend_cases_test
