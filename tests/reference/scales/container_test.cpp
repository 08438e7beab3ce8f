// SPDX-License-Identifier: GPL-3.0-or-later
// container-2.zip: a traced polyline, a map and a stylus line of one surface. PARITY §1.18 has the averages of
// SurfaceTopography with the map scaled once, as it should be.
#include <cmath>

#include <gtest/gtest.h>

#include "reference_data.hpp"
#include "sampled_polyline.hpp"
#include "setae/core/constants.hpp"
#include "setae/formats/channel.hpp"
#include "setae/scales/autocorrelation.hpp"
#include "setae/scales/scale_dependent.hpp"
#include "setae/scales/variable_bandwidth.hpp"
#include "setae/topography/detrend.hpp"

namespace container_test {

using namespace setae;
using namespace setae::scales;
using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

struct Expected {
    double distance, variance;
};
constexpr Expected published[] = {{1e-9, 8.422213253679271e-2},  {1e-8, 6.964996964805838e-2},
                                  {1e-7, 2.3027503433275184e-3}, {1e-6, 2.058876281489494e-4},
                                  {1e-5, 2.822253187632473e-6},  {1e-4, 2.650320272151731e-8}};

class Uncd : public testing::Test {
protected:
    void SetUp() override {
        SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/container-2.zip");
        const auto channels = formats::open(path.string());
        ASSERT_EQ(channels.size(), 3u);
        for (const auto& channel : channels)
            members.push_back(topography::detrended(channel.read(), channel.info.recommended_trend.value()));
        tem = std::get<Profile>(members[0]);
        afm = std::get<HeightMap>(members[1]);
        stylus = std::get<LineScan>(members[2]);
    }
    std::vector<topography::Measurement> members;
    Profile tem;
    HeightMap afm;
    LineScan stylus;
};

double variance_at(const topography::Measurement& measurement, double distance) {
    return difference_statistics(measurement, {.distances = Array1D::Constant(1, distance)}).variance[0];
}

/// The map without the lines that have no differences along y.
HeightMap without_last_lines(const HeightMap& map, double distance) {
    const auto lost = static_cast<Index>(std::ceil(distance / map.pixel_size()[1] - 1e-9));
    const Index kept = map.heights.cols() - lost;
    return {map.heights.leftCols(kept), {map.size[0], map.pixel_size()[1] * static_cast<double>(kept)}, false, {}};
}

TEST_F(Uncd, SlopeVarianceMatchesThePublishedOne) {
    // members by distance as there: the map alone at 1 nm, map and polyline at 10 nm, polyline and line at 100 nm, then
    // the line alone; there the polyline is sampled at equal steps and the map loses its last lines
    const auto sampled = [&](double d) { return variance_at(tests::sampled_for_differences(tem, 1, d), d); };
    const auto cropped = [&](double d) { return variance_at(without_last_lines(afm, d), d); };
    EXPECT_NEAR(cropped(1e-9) / published[0].variance, 1.0, 1e-6);
    EXPECT_NEAR(0.5 * (cropped(1e-8) + sampled(1e-8)) / published[1].variance, 1.0, 1e-6);
    EXPECT_NEAR(0.5 * (sampled(1e-7) + variance_at(stylus, 1e-7)) / published[2].variance, 1.0, 1e-6);
    for (const auto& [distance, variance] : {published[3], published[4], published[5]})
        EXPECT_NEAR(variance_at(stylus, distance) / variance, 1.0, 1e-6);
}

TEST_F(Uncd, CombinedSlopeVarianceUsesAllDataAndIsClose) {
    std::vector<FunctionOfScale> functions;
    for (const auto& member : members)
        functions.push_back(function_of(difference_statistics(member), Statistic::variance));
    const auto combined = combine(functions);
    for (const auto& [distance, variance] : published) {
        Index at = 0;
        ASSERT_LT((combined.distance - distance).abs().minCoeff(&at), 1e-6 * distance);
        // exact integral over the polyline, every line of the map
        EXPECT_NEAR(combined.value[at] / variance, 1.0, 0.05) << distance;
    }
    for (Index k = 1; k < combined.value.size(); ++k)
        if (combined.count[k] == combined.count[k - 1]) {
            EXPECT_LT(combined.value[k], 1.1 * combined.value[k - 1]) << combined.distance[k];
        }
}

TEST_F(Uncd, OneMemberCombinedEqualsTheMember) {
    const auto alone = binned(autocorrelation_of_lines(afm));
    const auto combined = combine(std::vector{autocorrelation_of_lines(afm)});
    EXPECT_TRUE((combined.value == alone.value).all());
}

TEST_F(Uncd, VariableBandwidthSpansTheDecadesOfItsMembers) {
    std::vector<FunctionOfScale> functions;
    for (const auto& member : members) functions.push_back(variable_bandwidth_along_lines(member));
    const auto combined = combine(functions, {.grid = {2}});
    // one member a bin at both ends, where bins of either code hold the same magnifications: §1.18 has 4.3418e-5
    // and 1.21207e-2 µm
    EXPECT_NEAR(functions[1].value[0], 4.341781737265035e-11, 1e-6 * 4.341781737265035e-11);
    EXPECT_NEAR(functions[1].distance[0], 7.8125e-10, 1e-16);
    const auto& line = functions[2];
    const Index last = line.value.size() - 1;
    EXPECT_NEAR(0.5 * (line.value[last] + line.value[last - 1]) / 1.2120650781837317e-8, 1.0, 1e-6);
    EXPECT_EQ(combined.count[0], 1.0);
    EXPECT_GT(combined.distance.maxCoeff() / combined.distance.minCoeff(), 1e5);
}

}  // namespace container_test
