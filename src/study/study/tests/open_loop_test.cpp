// SPDX-License-Identifier: GPL-3.0-or-later
// Loops as laboratories keep them: columns of other names, and radii on a camera's clock.
#include "setae/study/open_loop.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "sample_files.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::study::open_loop_test {
namespace {

using setae::tests::TemporaryFolder;

const contact::jkr::Contact approach{.radius = 1.25e-3, .contact_modulus = 0.92e6, .work_of_adhesion = 0.04};
const contact::jkr::Contact retraction{.radius = 1.25e-3, .contact_modulus = 0.92e6, .work_of_adhesion = 0.12};
constexpr Index samples = 1500;

struct Record {
    Array1D time, force, displacement, radius;
};

/// Free flight, a press to 20 µm, the release and free flight again; a sample every 10 ms.
Record loop() {
    namespace jkr = contact::jkr;
    Record r{Array1D::LinSpaced(4 * samples, 0.0, 0.04 * samples), Array1D::Zero(4 * samples),
             Array1D::Zero(4 * samples), Array1D::Zero(4 * samples)};
    const double deepest = 2e-5, end = jkr::pull_off_at_fixed_grips(retraction).displacement;
    for (Index i = 0; i < samples; ++i) {
        const double way = static_cast<double>(i) / samples;
        r.displacement[i] = (way - 1.0) * deepest;
        r.displacement[3 * samples + i] = end - way * deepest;
    }
    for (Index i = 0; i < 2 * samples; ++i) {
        const bool in = i < samples;
        const double way = static_cast<double>(in ? i : i - samples) / samples;
        const auto& lens = in ? approach : retraction;
        const double d = in ? way * deepest : deepest + way * (end - deepest);
        const double a = jkr::contact_radius_at_displacement(d, lens, jkr::Branch::outer);
        r.displacement[samples + i] = d;
        r.radius[samples + i] = a;
        r.force[samples + i] = jkr::force(a, lens);
    }
    return r;
}

bool has(const OpenedLoop& opened, const std::string& code, const std::string& words = "") {
    return std::any_of(opened.alerts.begin(), opened.alerts.end(), [&](const Alert& alert) {
        return alert.code == code && alert.message.find(words) != std::string::npos;
    });
}

std::string force_file(const TemporaryFolder& folder) {
    const auto record = loop();
    const auto path = folder.path("force.csv");
    tables::write_csv(
        path,
        {{{"time", "s", record.time}, {"force", "N", record.force}, {"displacement", "m", record.displacement}}, {}});
    return path;
}

/// Every 40th sample; the camera's clock began `behind` after the force's.
std::string camera_file(const TemporaryFolder& folder, double behind, double noise = 0.0) {
    const auto record = loop();
    std::mt19937_64 generator(3);
    std::normal_distribution<double> normal(0.0, noise);
    const Index frames = record.time.size() / 40;
    Array1D time(frames), radius(frames);
    for (Index k = 0; k < frames; ++k) {
        time[k] = record.time[40 * k] - behind;
        radius[k] = noise > 0.0 ? 1e-4 + normal(generator) : record.radius[40 * k];
    }
    const auto path = folder.path("camera.csv");
    tables::write_csv(path, {{{"time", "s", time}, {"contact_radius", "m", radius}}, {}});
    return path;
}

TEST(OpenLoop, ReportsUsedAndIgnoredColumns) {
    const TemporaryFolder folder;
    const auto file = folder.write("loop.csv",
                                   "time [s],force [mN],displacement [um],contact radius [um],humidity [%]\n"
                                   "0,0,-1,0,40\n1,0.1,0,20,40\n2,0.2,1,30,41\n");
    const auto opened = open_loop({.file = file});
    EXPECT_DOUBLE_EQ(opened.table.at("contact_radius")[2], 3e-5);
    EXPECT_TRUE(has(opened, "COLUMN_GUESSED", "contact radius"));
    EXPECT_TRUE(has(opened, "COLUMN_UNUSED", "humidity"));
    const auto plain = open_loop({.file = folder.write("plain.csv",
                                                       "time [s],force [N],displacement [m],contact_radius [m]\n"
                                                       "0,0,-1e-6,0\n1,1e-4,0,2e-5\n2,2e-4,1e-6,3e-5\n")});
    EXPECT_TRUE(plain.alerts.empty());
}

TEST(OpenLoop, AlignsRadiiWithTheClockOfTheForce) {
    const TemporaryFolder folder;
    const auto opened =
        open_loop({.file = force_file(folder), .camera = CameraInput{.file = camera_file(folder, 3.0)}});
    ASSERT_TRUE(opened.clock);
    EXPECT_NEAR(opened.clock->offset.value, 3.0, 0.2);  // half a frame
    EXPECT_EQ(opened.clock->doubt, "");
    EXPECT_FALSE(has(opened, "CLOCK_DOUBTFUL"));
}

TEST(OpenLoop, WarnsOfRadiiUnrelatedToTheForce) {
    const TemporaryFolder folder;
    const auto opened =
        open_loop({.file = force_file(folder), .camera = CameraInput{.file = camera_file(folder, 0.0, 3e-5)}});
    EXPECT_TRUE(has(opened, "CLOCK_DOUBTFUL"));
}

TEST(OpenLoop, CountsFramesOutsideTheForceRecord) {
    const TemporaryFolder folder;
    CameraInput camera{.file = camera_file(folder, 0.0), .clock_offset = -1.0};
    EXPECT_TRUE(has(open_loop({.file = force_file(folder), .camera = camera}), "FRAMES_OUTSIDE", "3 frames"));
    camera.clock_offset = 0.0;
    EXPECT_FALSE(has(open_loop({.file = force_file(folder), .camera = camera}), "FRAMES_OUTSIDE"));
}

/// A disc darker than its surroundings, as an uncompressed picture of 24 bits; radius 0: nothing but one grey.
void write_picture(const std::string& path, double radius) {
    constexpr int width = 100, height = 80, offset = 54,
                  bytes = 3 * width * height;  // rows of 300 bytes need no filling
    std::string picture(offset + bytes, '\0');
    const auto put = [&picture](int at, int value, int size) {
        for (int k = 0; k < size; ++k) picture[static_cast<std::size_t>(at + k)] = static_cast<char>(value >> (8 * k));
    };
    picture[0] = 'B', picture[1] = 'M';
    put(2, offset + bytes, 4), put(10, offset, 4), put(14, 40, 4), put(18, width, 4), put(22, height, 4);
    put(26, 1, 2), put(28, 24, 2), put(34, bytes, 4);
    std::mt19937 generator(static_cast<unsigned>(100.0 * radius) + 1);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const double edge = radius - std::hypot(column - 50.3, row - 40.6);
            const double shade = 60.0 * std::clamp(0.5 + 0.6 * edge, 0.0, 1.0);
            const int grey =
                radius > 0.0 ? static_cast<int>(140.0 - shade) + static_cast<int>(generator() % 9) - 4 : 50;
            for (int channel = 0; channel < 3; ++channel)
                picture[static_cast<std::size_t>(offset + 3 * (row * width + column) + channel)] =
                    static_cast<char>(grey);
        }
    std::ofstream(path, std::ios::binary) << picture;
}

TEST(OpenLoop, CountsFramesOfARecordingWithoutARadius) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path("frames"));
    for (int k = 0; k < 6; ++k)
        write_picture(folder.path(fmt::format("frames/{}.bmp", k)), k == 4 ? 0.0 : 12.0 + 3.0 * k);
    const CameraInput camera{
        .file = folder.path("frames"), .clock_offset = 16.0, .pixel_size = 2e-6, .frame_rate = 0.5};
    const auto opened = open_loop({.file = force_file(folder), .camera = camera});
    EXPECT_TRUE(has(opened, "FRAMES_BAD", "1 of 6 frames"));
    const auto& radius = opened.table.at("contact_radius");
    EXPECT_NEAR(radius[1600], 2e-6 * 12.0, 0.5e-6);  // the first frame, at 16 s
}

TEST(OpenLoop, UsesChosenColumnsOfTablesMappingsAndLoopFiles) {
    const TemporaryFolder folder;
    const auto table = folder.write("t.csv", "Kraft,gap [um]\n1,60\n2,50\n");
    const auto opened = open_loop({.file = table, .columns = {{"force", "-1 uN * kraft"}}});
    EXPECT_DOUBLE_EQ(opened.table.at("force")[1], -2e-6);
    EXPECT_DOUBLE_EQ(opened.table.at("displacement")[1], -50e-6);
    EXPECT_EQ(opened.channels.at("force").expression, "-1 uN * kraft");
    EXPECT_EQ(opened.channels.at("displacement").expression, "-1 * gap");
    const auto mapping = folder.write(
        "m.toml",
        "[columns.k]\nheader = \"Kraft\"\nunit = \"mN\"\n[columns.g]\nheader = \"gap\"\n[table]\nforce = \"k\"\n"
        "displacement = \"g\"\n");
    const auto mapped = open_loop({.file = table, .mapping = mapping, .columns = {{"displacement", "-1 * g"}}});
    EXPECT_DOUBLE_EQ(mapped.table.at("force")[1], 2e-3);
    EXPECT_DOUBLE_EQ(mapped.table.at("displacement")[1], -50e-6);
    const auto own =
        folder.write("l.csv", "# format: setae loop\n# version: 1\nforce [N],displacement [m]\n1,2\n3,4\n");
    EXPECT_EQ(open_loop({.file = own, .columns = {{"force", "-1 * force"}}}).table.at("force")[1], -3.0);
}

}  // namespace
}  // namespace setae::study::open_loop_test
