// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/clocks.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "import_samples.hpp"

using namespace setae::tests;

namespace setae::tables::tests::clocks_test {
namespace {

const double undefined_cell = std::nan("");

/// Samples every 0.1 s from 0 to 0.9 s.
Table force_record() {
    Table table;
    table.columns = {{"time", "s", Array1D::LinSpaced(10, 0.0, 0.9)}, {"force", "N", Array1D::LinSpaced(10, 0.0, 9.0)}};
    return table;
}

Table camera_record(const Array1D& time, const Array1D& radius) {
    Table table;
    table.columns = {{"time", "s", time}, {"contact_radius", "m", radius}};
    return table;
}

TEST(MergedByTime, AssignsFramesToTheNearestSampleOnly) {
    const auto table = merged_by_time(
        force_record(), camera_record(Array1D{{10.02, 10.38, 10.71}}, Array1D{{1e-5, 2e-5, 3e-5}}), -10.0);
    const auto& radius = table.at("contact_radius");
    for (Index i = 0; i < 10; ++i) {
        if (i == 0) EXPECT_EQ(radius[i], 1e-5);
        else if (i == 4) EXPECT_EQ(radius[i], 2e-5);
        else if (i == 7) EXPECT_EQ(radius[i], 3e-5);
        else EXPECT_TRUE(std::isnan(radius[i])) << i;
    }
    EXPECT_EQ(table.metadata.at("frames_used"), "3");
    EXPECT_EQ(table.metadata.at("camera_clock_offset"), "-10 s");
    EXPECT_NEAR(std::stod(table.metadata.at("largest_frame_shift")), 0.02, 1e-12);
    EXPECT_TRUE((table.at("force") == force_record().at("force")).all());
}

TEST(MergedByTime, KeepsTheNearestFramePerSampleAndCountsFramesOutside) {
    const auto table = merged_by_time(
        force_record(),
        camera_record(Array1D{{-0.2, -0.04, 0.18, 0.21, 0.24, 0.94, 0.97}}, Array1D{{9., 1., 2., 3., 4., 5., 9.}}),
        0.0);
    EXPECT_EQ(table.at("contact_radius")[0], 1.0);
    EXPECT_EQ(table.at("contact_radius")[2], 3.0);
    EXPECT_EQ(table.at("contact_radius")[9], 5.0);
    EXPECT_EQ(table.metadata.at("frames_used"), "3");
    EXPECT_EQ(table.metadata.at("frames_crowded"), "2");
    EXPECT_EQ(table.metadata.at("frames_outside"), "2");
}

TEST(MergedByTime, InvalidClocksAreNamed) {
    const auto camera = camera_record(Array1D{{0.1, 0.2}}, Array1D{{1.0, 2.0}});
    const auto message = [](const Table& force, const Table& frames, double offset = 0.0) {
        return message_of([&] { (void)merged_by_time(force, frames, offset); });
    };
    auto backwards = force_record();
    backwards.columns[0].values[4] = 0.25;
    EXPECT_TRUE(holds(message(backwards, camera), "force record: time runs backwards from row 4 to 5"));
    backwards.columns[0].values[4] = backwards.columns[0].values[3];
    EXPECT_TRUE(holds(message(backwards, camera), "force record: time does not change from row 4 to 5"));
    EXPECT_TRUE(holds(message(force_record(), camera_record(Array1D{{0.1, undefined_cell}}, Array1D{{1.0, 2.0}})),
                      "camera record: time is undefined in row 2"));
    EXPECT_TRUE(holds(message(force_record(), camera, 100.0), "the clocks do not overlap"));
    EXPECT_TRUE(holds(message(force_record(), force_record()), "camera record: no column 'contact_radius'"));
    auto milliseconds = camera;
    milliseconds.columns[0].unit = "";
    EXPECT_TRUE(holds(message(force_record(), milliseconds), "column 'time' has the unit ''"));
    EXPECT_TRUE(holds(message(force_record(), camera, undefined_cell), "expected a finite one"));
    auto merged = merged_by_time(force_record(), camera, 0.0);
    EXPECT_TRUE(holds(message(merged, camera), "it already has a contact radius"));
}

TEST(OneClock, ChannelsOfDifferentLengthAreNamed) {
    auto table = force_record();
    EXPECT_NO_THROW(require_one_clock(table, "t"));
    table.columns[1].values.tail(4) = undefined_cell;
    EXPECT_TRUE(holds(message_of([&] { require_one_clock(table, "t"); }),
                      "channels of different length: column 'force' ends in row 6 of 10"));
    table.columns[1].values = undefined_cell;
    EXPECT_TRUE(holds(message_of([&] { require_one_clock(table, "t"); }), "column 'force' has no numbers"));
    table.columns[1].values = Array1D::Zero(3);
    EXPECT_TRUE(holds(message_of([&] { require_one_clock(table, "t"); }), "column 'force' has 3 rows, 'time' has 10"));
}

}  // namespace
}  // namespace setae::tables::tests::clocks_test
