// SPDX-License-Identifier: GPL-3.0-or-later
// Every format that writes a measurement reads it back.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "sample_files.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/format.hpp"

using namespace setae::tests;

namespace setae::formats::tests::write_read_property_test {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Measurement;
using topography::Profile;

enum class Kind { map, line, profile };

/// Data that each writing format can store; a missing format fails.
bool holds(const Format& format, Kind kind) {
    static const std::map<std::string, std::vector<Kind>> kinds{{"x3p", {Kind::map, Kind::line, Kind::profile}},
                                                                {"sdf", {Kind::map, Kind::line}},
                                                                {"gwy", {Kind::map}},
                                                                {"gsf", {Kind::map}},
                                                                {"nc", {Kind::map, Kind::line, Kind::profile}},
                                                                {"npy", {Kind::map, Kind::line}},
                                                                {"matrix", {Kind::map}},
                                                                {"xy", {Kind::line, Kind::profile}}};
    const auto found = kinds.find(format.identifier);
    if (found == kinds.end()) throw std::out_of_range("what does " + format.identifier + " hold?");
    return std::find(found->second.begin(), found->second.end(), kind) != found->second.end();
}

bool holds_traces(const Format& format) { return format.identifier == "matrix" || format.identifier == "xy"; }

std::vector<Format> writers_of(Kind kind) {
    std::vector<Format> found;
    for (const auto& format : formats())
        if (format.writes() && holds(format, kind)) found.push_back(format);
    return found;
}

bool same(const double* a, const double* b, Index count) {
    for (Index i = 0; i < count; ++i)
        if (!(a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i])))) return false;
    return true;
}

/// Heights that a format can store: GSF in float32, within its range.
Array2D kept_heights(const Format& format, const Array2D& heights) {
    if (format.identifier != "gsf") return heights;
    return heights.unaryExpr([](double height) {
        const bool fits = std::abs(height) <= static_cast<double>(std::numeric_limits<float>::max());
        return fits ? static_cast<double>(static_cast<float>(height)) : std::nan("");
    });
}

/// Text contains no size of a line: it follows from its positions, each rounded.
bool nearly(double a, double b, const Format& format) {
    return std::abs(a / b - 1.0) <= (format.identifier == "xy" ? 1e-14 : 1e-15);
}

/// Heights of any binary exponent of a length, some undefined, except the first.
Array1D any_heights(Index count) {
    const auto height = rc::gen::oneOf(
        rc::gen::map(rc::gen::arbitrary<double>(), [](double x) { return std::isfinite(x) ? x : 0.0; }),
        rc::gen::map(rc::gen::inRange(-100000, 100000), [](int n) { return n * 1e-10; }), rc::gen::just(std::nan("")));
    const auto values = *rc::gen::container<std::vector<double>>(static_cast<std::size_t>(count), height);
    Array1D heights = Eigen::Map<const Array1D>(values.data(), count);
    heights[0] = 1.5e-9;
    return heights;
}

double any_length() { return *rc::gen::inRange(1, 1'000'000) * 1e-9 / 3.0; }

topography::Metadata any_metadata() {
    // any text of one line without outer blanks
    const auto text = rc::gen::container<std::string>(rc::gen::elementOf(std::string("ab7 <&>\"'_")));
    topography::Metadata metadata;
    metadata.name = "n" + *text + "µ";
    metadata.instrument.name = "Scope_" + std::to_string(*rc::gen::inRange(0, 9999));  // ten letters fit everywhere
    metadata.acquisition_time =
        fmt::format("20{:02}-{:02}-{:02}T{:02}:{:02}:00", *rc::gen::inRange(10, 99), *rc::gen::inRange(1, 13),
                    *rc::gen::inRange(1, 29), *rc::gen::inRange(0, 24), *rc::gen::inRange(0, 60));
    return metadata;
}

/// Heights of any size, including those of markers of missing heights.
Measurement written_and_read(const Format& format, const Measurement& measurement, ReadOptions options) {
    options.keep_values = true;
    const TemporaryFolder folder;
    const auto path = folder.path("a" + format.extensions.substr(0, format.extensions.find(' ')));
    RC_ASSERT(format_to_write(path).identifier == format.identifier);
    format.write(path, measurement);
    const auto channels = open(path, options);
    RC_ASSERT(channels.size() == 1u);
    RC_ASSERT(channels[0].info.format == format.identifier);
    RC_ASSERT(channels[0].info.unit == "m");
    return channels[0].read();
}

/// Metadata that each format can store.
void check_metadata(const Format& format, const topography::Metadata& before, const topography::Metadata& after) {
    const auto& id = format.identifier;
    if (id == "gwy" || id == "matrix") RC_ASSERT(after.name == before.name);
    if (id == "gwy" || id == "x3p" || id == "sdf") RC_ASSERT(after.instrument.name == before.instrument.name);
    if (id == "gwy" || id == "x3p") RC_ASSERT(after.acquisition_time == before.acquisition_time);
    if (id == "sdf")
        RC_ASSERT(after.acquisition_time ==
                  before.acquisition_time.substr(0, 10) + " " + before.acquisition_time.substr(11, 5));  // no seconds
}

RC_GTEST_PROP(WriteRead, IsTheIdentityOfMaps, ()) {
    const auto nx = *rc::gen::inRange<Index>(2, 12), ny = *rc::gen::inRange<Index>(2, 12);
    HeightMap map;
    const auto heights = any_heights(nx * ny);
    map.heights = Eigen::Map<const Array2D>(heights.data(), nx, ny);
    map.size = {any_length(), any_length()};
    map.metadata = any_metadata();
    for (const auto& format : writers_of(Kind::map)) {
        const ReadOptions options =
            format.carries_scale ? ReadOptions{} : ReadOptions{.size = {{map.size[0], map.size[1]}}, .unit = "m"};
        const auto back = std::get<HeightMap>(written_and_read(format, map, options));
        RC_ASSERT(back.shape() == map.shape());
        const auto kept = kept_heights(format, map.heights);
        RC_ASSERT(same(back.heights.data(), kept.data(), nx * ny));
        RC_ASSERT(nearly(back.size[0], map.size[0], format));
        RC_ASSERT(nearly(back.size[1], map.size[1], format));
        check_metadata(format, map.metadata, back.metadata);
    }
}

TEST(WriteRead, CsvRowsAreLinesAlongX) {
    HeightMap map;
    map.heights = Array2D::Random(7, 5);
    map.heights(5, 1) = std::nan("");
    map.size = {7e-6, 5e-6};
    const TemporaryFolder folder;
    format_to_write("a.csv").write(folder.path("a.csv"), map);
    const auto back = std::get<HeightMap>(read(folder.path("a.csv"), 0, {.size = {{7e-6, 5e-6}}, .unit = "m"}));
    ASSERT_EQ(back.shape(), map.shape());
    EXPECT_TRUE(same(back.heights.data(), map.heights.data(), 35));
}

RC_GTEST_PROP(WriteRead, IsTheIdentityOfLinesInFormatsThatHoldThem, ()) {
    const auto count = *rc::gen::inRange<Index>(2, 40);
    const LineScan scan{any_heights(count), any_length(), false, any_metadata()};
    for (const auto& format : writers_of(Kind::line)) {
        const ReadOptions options =
            format.carries_scale ? ReadOptions{} : ReadOptions{.size = {{scan.size}}, .unit = "m"};
        const auto back = std::get<LineScan>(written_and_read(format, scan, options));
        RC_ASSERT(back.heights.size() == count);
        RC_ASSERT(same(back.heights.data(), scan.heights.data(), count));
        RC_ASSERT(nearly(back.size, scan.size, format));
        check_metadata(format, scan.metadata, back.metadata);
    }
}

RC_GTEST_PROP(WriteRead, IsTheIdentityOfProfilesInFormatsThatHoldThem, ()) {
    const auto count = *rc::gen::inRange<Index>(3, 40);
    Profile profile{Array1D(count), any_heights(count), any_metadata()};
    profile.positions[0] = 0.0;
    for (Index i = 1; i < count; ++i) profile.positions[i] = profile.positions[i - 1] + any_length();
    // the last step is longer than three others together, and no multiple of them if they are equal
    const double steps = static_cast<double>(count - 1);
    profile.positions[count - 1] += (3.0 + 0.5 / steps) * (profile.positions[count - 1] - profile.positions[0]);
    for (const auto& format : writers_of(Kind::profile)) {
        const auto back = std::get<Profile>(written_and_read(format, profile, {}));
        RC_ASSERT(back.heights.size() == count);
        RC_ASSERT(same(back.heights.data(), profile.heights.data(), count));
        RC_ASSERT(same(back.positions.data(), profile.positions.data(), count));
    }
}

TEST(WriteRead, RefusesUnsupportedDataAndNamesSuitableFormats) {
    const LineScan scan{(Array1D(3) << 0.0, 1e-9, 0.0).finished(), 1e-6, false, {}};
    const Profile uneven{(Array1D(3) << 0.0, 1e-6, 3e-6).finished(), scan.heights, {}};
    Profile traced = uneven;
    traced.standard_error = Array1D::Constant(3, 1e-10);
    const auto refuses = [](const Format& format, const Measurement& measurement, const char* ending) {
        const TemporaryFolder folder;
        const auto path = folder.path("a");
        try {
            format.write(path, measurement);
            ADD_FAILURE() << format.identifier << " wrote it";
        } catch (const InvalidArgument& error) {
            EXPECT_NE(std::string(error.what()).find(ending), std::string::npos) << error.what();
        }
        EXPECT_TRUE(std::filesystem::is_empty(folder.path(""))) << format.identifier;
    };
    for (const auto& format : formats()) {
        if (!format.writes() || holds_traces(format)) continue;
        if (!holds(format, Kind::line)) refuses(format, scan, ".x3p, .sdf");
        if (!holds(format, Kind::profile)) refuses(format, uneven, ".x3p, .nc");
        refuses(format, traced, "write it as .csv");
    }
}

TEST(WriteRead, KeepsTheOldFileWhenWritingFails) {
    const HeightMap map{Array2D::Zero(2, 2), {1e-6, 1e-6}, false, {}};
    for (const auto& format : writers_of(Kind::map)) {
        const TemporaryFolder folder;
        const auto path = folder.path("no/such/folder/a");
        EXPECT_THROW(format.write(path, map), FileError) << format.identifier;
        EXPECT_TRUE(std::filesystem::is_empty(folder.path(""))) << format.identifier;
    }
}

}  // namespace
}  // namespace setae::formats::tests::write_read_property_test
