// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/simulation/recording.hpp"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "sample_files.hpp"
#include "setae/bytes/source.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/imaging/contact_outline.hpp"

namespace setae::simulation::recording_test {
namespace {

constexpr double pixel = 0.5e-6;

/// 60 px wide on average, an edge with two waves that recedes by 4 px/s.
contact_line::ContactLine edge() {
    contact_line::ContactLine line{.time = Array1D::LinSpaced(11, 0.0, 2.0), .radius = Array2D(11, 256)};
    for (Index i = 0; i < 11; ++i)
        for (Index j = 0; j < 256; ++j) {
            const double angle = 2.0 * pi * static_cast<double>(j) / 256.0;
            line.radius(i, j) =
                pixel * (60.0 - 4.0 * line.time[i] + 1.5 * std::cos(5.0 * angle + 0.3) + std::sin(9.0 * angle));
        }
    return line;
}

// What is found in the recording is the edge that was rendered, to the noise of a place that is stated and a tenth of a
// pixel
TEST(Recording, MeasurementRecoversTheRenderedEdge) {
    const setae::tests::TemporaryFolder folder;
    const auto path = folder.path("recording.tif");
    const auto shape = write_recording(path, edge(), {.pixel_size = pixel, .frame_rate = 5.0});
    EXPECT_EQ(shape.frames, 11);
    EXPECT_EQ(shape.width, shape.height);
    const imaging::FrameSource source({path}, {});
    const auto radii = imaging::measure_contact_radii(source, {});
    const auto found = imaging::measure_contact_line(source, radii, {.angles = 256});
    EXPECT_NEAR(found.pixel_size / pixel, 1.0, 1e-6);  // as the file states it
    ASSERT_EQ(found.time.size(), 11);
    EXPECT_NEAR(found.time[10] - found.time[0], 2.0, 1e-9);
    // places are relative to the mean centre of the ellipses of all frames
    const double dx = found.centre_x - 0.5 * static_cast<double>(shape.width - 1),
                 dy = found.centre_y - 0.5 * static_cast<double>(shape.height - 1);
    EXPECT_LT(std::hypot(dx, dy), 0.4);
    Array2D expected = edge().radius;
    for (Index j = 0; j < 256; ++j) {
        const double angle = 2.0 * pi * static_cast<double>(j) / 256.0;
        expected.col(j) -= pixel * (dx * std::cos(angle) + dy * std::sin(angle));
    }
    const double difference = std::sqrt((found.radius - expected).square().mean()) / pixel;
    const double stated = found.place_error / pixel;
    EXPECT_LT(stated, 0.3);
    EXPECT_LT(difference, 1.2 * std::hypot(stated, 0.1));
    EXPECT_LT(std::abs((found.radius - expected).mean()) / pixel, 0.03);
}

TEST(Recording, HasTheSameBytesForAnyNumberOfThreads) {
    const setae::tests::TemporaryFolder folder;
    for (const int threads : {1, 3})
        (void)write_recording(folder.path(std::to_string(threads) + ".tif"), edge(),
                              {.pixel_size = pixel, .frame_rate = 5.0, .threads = {threads}});
    EXPECT_EQ(bytes::read_file(folder.path("1.tif")), bytes::read_file(folder.path("3.tif")));
}

TEST(Recording, RefusesInvalidOptions) {
    const setae::tests::TemporaryFolder folder;
    const auto path = folder.path("recording.tif");
    const auto refused = [&](const RecordingOptions& options) {
        EXPECT_THROW((void)write_recording(path, edge(), options), InvalidArgument);
    };
    refused({.pixel_size = 0.0});
    refused({.pixel_size = 1e-9});                      // 60 000 px across
    refused({.pixel_size = 40e-6});                     // the contact in one pixel
    refused({.pixel_size = pixel, .frame_rate = 1e6});  // 2 million frames
    refused({.pixel_size = pixel, .contrast = 200.0});  // above 255
    refused({.pixel_size = pixel, .blur = 0.0});
    EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace setae::simulation::recording_test
