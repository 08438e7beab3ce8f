// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analysis_cases.hpp"
#include "sampled_polyline.hpp"
#include "setae/core/constants.hpp"
#include "setae/scales/autocorrelation.hpp"
#include "setae/scales/scale_dependent.hpp"
#include "setae/scales/variable_bandwidth.hpp"

namespace analysis_cases_test {

using namespace setae;
using namespace setae::scales;
using nlohmann::json;
using tests::AnalysisCases;
using tests::matrix;
using tests::series;
using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

/// Values at the same distances, 1e-10.
void expect_function(const FunctionOfScale& found, const json& expected) {
    const Array1D distances = series(expected[0]), values = series(expected[1]);
    ASSERT_GT(distances.size(), 1);
    for (Index k = 0; k < distances.size(); ++k) {
        if (distances[k] == 0.0 || std::isnan(values[k])) continue;
        Index at = 0;
        ASSERT_LT((found.distance - distances[k]).abs().minCoeff(&at), 1e-9 * distances[k]);
        EXPECT_NEAR(found.value[at] / values[k], 1.0, 1e-10) << "distance " << distances[k];
    }
}

TEST_F(AnalysisCases, AutocorrelationsOfLineScansAgree) {
    for (const char* name : {"profile_nonperiodic", "profile_periodic"})
        expect_function(autocorrelation(line_scan(name)), cases[name]["acf_raw"]);
}

TEST_F(AnalysisCases, AutocorrelationsOfLinesOfMapsAgree) {
    for (const char* name : {"map_nonperiodic", "map_periodic"})
        expect_function(autocorrelation_of_lines(height_map(name)), cases[name]["acf_profile_raw"]);
    expect_function(autocorrelation_of_lines(masked_map()), cases["map_masked"]["acf_profile_raw"]);
}

TEST_F(AnalysisCases, AutocorrelationsOfPolylinesAgree) {
    const auto& expected = cases["nonuniform"]["acf_brute"];
    expect_function(autocorrelation(polyline(), series(expected[0])), expected);
}

TEST_F(AnalysisCases, VariableBandwidthsAgree) {
    for (const char* name : {"profile_nonperiodic", "profile_periodic"})
        expect_function(variable_bandwidth(line_scan(name)), cases[name]["vbw"]);
    for (const char* name : {"map_nonperiodic", "map_periodic"}) {
        expect_function(variable_bandwidth_along_lines(height_map(name)), cases[name]["vbw_profile"]);
        expect_function(variable_bandwidth_of_area(height_map(name)), cases[name]["vbw_area"]);
    }
    expect_function(variable_bandwidth_of_area(masked_map()), cases["map_masked"]["vbw_area"]);
}

TEST_F(AnalysisCases, VariableBandwidthOfPolylinesIsTheTotalRmsNotTheMeanOfRms) {
    const auto found = variable_bandwidth(polyline());
    const Array1D sizes = series(cases["nonuniform"]["vbw"][0]), means = series(cases["nonuniform"]["vbw"][1]);
    ASSERT_EQ(found.value.size(), sizes.size());
    for (Index k = 0; k < sizes.size(); ++k) {
        const Index at = sizes.size() - 1 - k;
        EXPECT_NEAR(found.distance[at] / sizes[k], 1.0, 1e-12);
        if (k == 0) {
            EXPECT_NEAR(found.value[at] / means[k], 1.0, 1e-10);  // one cell: the same
        } else {
            EXPECT_GT(found.value[at], means[k]);  // a root mean square is never below a mean
        }
    }
}

TEST_F(AnalysisCases, DifferencesOfLineScansAgree) {
    for (const char* name : {"profile_nonperiodic", "profile_periodic"}) {
        const auto scan = line_scan(name);
        const auto& first = cases[name]["sdrp_var_dx_n1"];
        const auto& second = cases[name]["sdrp_rms_n2"];
        expect_function(function_of(difference_statistics(scan, {.distances = series(first[0])}), Statistic::variance),
                        first);
        expect_function(
            function_of(difference_statistics(scan, {.order = 2, .distances = series(second[0])}), Statistic::rms),
            second);
    }
}

TEST_F(AnalysisCases, DerivativesOfLineScansAgreePointByPoint) {
    for (const char* name : {"profile_nonperiodic", "profile_periodic"}) {
        const auto scan = line_scan(name);
        for (const int order : {1, 2})
            for (const char* factor : {"1", "2", "3", "2.5"}) {
                const Array1D expected = series(cases[name]["derivative" + std::to_string(order) + "_scale" + factor]);
                Array1D found;
                for_each_row_of_differences(scan, std::stod(factor) * order * scan.pixel_size(), {.order = order},
                                            [&](Index, Index, const ArrayView1D& values) { found = values; });
                ASSERT_EQ(found.size(), expected.size()) << name << ' ' << order << ' ' << factor;
                EXPECT_LT((found - expected).abs().maxCoeff(), 1e-10 * expected.abs().maxCoeff())
                    << name << ' ' << order << ' ' << factor;
            }
    }
}

TEST_F(AnalysisCases, GradientsOfMapsAgree) {
    for (const char* name : {"map_nonperiodic", "map_periodic"}) {
        const auto& expected = cases[name]["sdrp_rms_gradient"];
        const auto found =
            difference_statistics(height_map(name), {.along = Along::both, .distances = series(expected[0])});
        expect_function(function_of(found, Statistic::rms), expected);
    }
}

TEST_F(AnalysisCases, SlopesAlongXAgreeOnThePointsOfThePackage) {
    const auto& periodic = cases["map_periodic"]["sdrp_var_hx"];
    expect_function(function_of(difference_statistics(height_map("map_periodic"), {.distances = series(periodic[0])}),
                                Statistic::variance),
                    periodic);
    // of non-periodic maps it leaves out the last lines too, where only differences along y are missing
    const auto& expected = cases["map_nonperiodic"]["sdrp_var_hx"];
    const auto map = height_map("map_nonperiodic");
    const Array1D distances = series(expected[0]), values = series(expected[1]);
    for (Index k = 0; k < distances.size(); ++k) {
        const auto lost = static_cast<Index>(std::ceil(distances[k] / map.pixel_size()[1] - 1e-9));
        const Index kept = map.heights.cols() - lost;
        const HeightMap part{map.heights.leftCols(kept), {map.size[0], static_cast<double>(kept)}, false, {}};
        EXPECT_NEAR(
            difference_statistics(part, {.distances = Array1D(distances.segment(k, 1))}).variance[0] / values[k], 1.0,
            1e-10);
    }
}

TEST_F(AnalysisCases, DifferencesOfMaskedMapsUseEveryDefinedPair) {
    const auto map = masked_map();
    const auto [dx, dy] = map.pixel_size();
    const auto x = difference_statistics(map, {.distances = Array1D::Constant(1, dx)});
    const auto y = difference_statistics(map, {.along = Along::y, .distances = Array1D::Constant(1, dy)});
    const auto pairs = [&](Index k, Index l) {
        double count = 0.0;
        for (Index i = 0; i + k < map.heights.rows(); ++i)
            for (Index j = 0; j + l < map.heights.cols(); ++j)
                count += std::isnan(map.heights(i + k, j + l) - map.heights(i, j)) ? 0.0 : 1.0;
        return count;
    };
    EXPECT_EQ(x.count[0], pairs(1, 0));
    EXPECT_EQ(y.count[0], pairs(0, 1));
    // the package has 319 along x in the 23 x 15 places it keeps, where there are 330, and 0.2906 for the rms gradient
    // in place of 0.2874
    const HeightMap part{map.heights.leftCols(15), {map.size[0], 3.0}, false, {}};
    EXPECT_EQ(difference_statistics(part, {.distances = Array1D::Constant(1, dx)}).count[0], 330.0);
    EXPECT_NEAR(cases["map_masked"]["rms_gradient"].get<double>(), 0.2906, 1e-4);
    Array2D squares = Array2D::Zero(23, 15);
    const auto add = [&](Index row, Index, const ArrayView1D& values) {
        if (row < 23) squares.row(row) += values.head(15).square().transpose();
    };
    for_each_row_of_differences(map, dx, {}, add);
    for_each_row_of_differences(map, dy, {.along = Along::y}, add);
    double sum = 0.0, count = 0.0;
    for (const double square : squares.reshaped())
        if (!std::isnan(square)) {
            sum += square;
            count += 1.0;
        }
    EXPECT_NEAR(std::sqrt(sum / count), 0.2874, 5e-5);
}

TEST_F(AnalysisCases, DifferencesOfPolylinesAgreeAtTheSamplesOfThePackage) {
    const auto& expected = cases["nonuniform"]["sdrp_var"];
    const Array1D distances = series(expected[0]), values = series(expected[1]);
    const auto profile = polyline();
    const auto exact = difference_statistics(profile, {.distances = distances});
    for (Index k = 0; k < distances.size(); ++k) {
        const auto sampled = tests::sampled_for_differences(profile, 1, distances[k]);
        const auto found = difference_statistics(sampled, {.distances = Array1D(distances.segment(k, 1))});
        EXPECT_NEAR(found.variance[0] / values[k], 1.0, 1e-10);
        EXPECT_NEAR(exact.variance[k] / values[k], 1.0, 0.12);  // the exact integral against some forty samples
    }
}

}  // namespace analysis_cases_test
