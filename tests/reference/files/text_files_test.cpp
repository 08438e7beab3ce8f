// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "expected_file.hpp"
#include "reference_data.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/channel.hpp"
#include "setae/formats/format.hpp"
#include "setae/topography/detrend.hpp"

namespace setae::formats::text_files_test {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

std::string in_folder(const char* name) { return std::string("topography/surfacetopography/") + name; }

/// A file of expected/topography_files.json; its numbers are in `unit`, which is given where the file states none, as
/// is the size.
struct TextFile {
    const char* name;
    double unit;
    ReadOptions options = {};
};

void PrintTo(const TextFile& file, std::ostream* stream) { *stream << file.name; }

class TextFiles : public testing::TestWithParam<TextFile> {};

TEST_P(TextFiles, HaveTheHeightsOfAnotherReader) {
    const auto& file = GetParam();
    SETAE_REQUIRE_REFERENCE_DATA(path, in_folder(file.name));
    const auto entry = expected_entry(in_folder(file.name));
    ASSERT_FALSE(entry.is_null());
    const auto channel = open(path.string(), file.options).at(0);
    expect_heights_of(channel, entry, file.unit);
    const bool same_kind = entry.at("is_uniform").get<bool>() != std::holds_alternative<Profile>(channel.read());
    if (same_kind) expect_size_of(channel, entry, file.unit);
}

const ReadOptions microns{{}, "um"};

INSTANTIATE_TEST_SUITE_P(
    All, TextFiles,
    testing::Values(TextFile{"csv-1.csv", units::um}, TextFile{"csv-2.csv", units::um},
                    TextFile{"csv-3.csv", units::um}, TextFile{"dektak-1.csv", units::um},
                    TextFile{"hfm-1.hfm", units::mm}, TextFile{"gwyddion-export-english.txt", units::m},
                    TextFile{"gwyddion-export-german.txt", units::m}, TextFile{"matrix-4.txt", units::m},
                    TextFile{"matrix-4.txt.gz", units::m},
                    TextFile{"matrix-5.txt", units::nm, {{{10e-9, 10e-9}}, "nm"}}, TextFile{"matrix-6.txt", units::m},
                    TextFile{"txt_example.txt", units::m}, TextFile{"single_column.txt", units::um, {{{9e-6}}, "um"}},
                    TextFile{"not-yet-working-1.txt", units::um, {{{9e-6}}, "um"}},
                    TextFile{"nonuniform.asc", units::nm, {{}, "nm"}}, TextFile{"opdx-3.txt", units::m, {{}, "m"}},
                    TextFile{"xy-1.txt", units::um, microns}, TextFile{"xy-2.txt", units::um},
                    TextFile{"xy-3.txt", units::um, microns}, TextFile{"xy-4.txt", units::um, microns},
                    TextFile{"xy-5.txt", units::um, microns}, TextFile{"xyz-1.txt", units::um, microns},
                    TextFile{"xyz-1-different-order.txt", units::um, microns},
                    TextFile{"xyz-2.txt", units::um, microns}, TextFile{"mitutoyo_mock.xlsx", units::um},
                    TextFile{"mitutoyo_2_mock.xlsx", units::um}, TextFile{"mitutoyo_nonuniform_mock.xlsx", units::um}),
    [](const auto& instance) {
        std::string name = instance.param.name;
        for (auto& c : name)
            if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
        return name;
    });

TEST(TextFile, ProfileWithAnUndefinedPointHasTheExpectedHeights) {
    SETAE_REQUIRE_REFERENCE_DATA(path, in_folder("xy-6.txt"));
    const auto profile = std::get<Profile>(read(path.string(), 0, microns));
    EXPECT_EQ(profile.positions.size(), 4);
    EXPECT_EQ(profile.heights.isNaN().count(), 1);  // the other reader has nan for all statistics
    for (const double height : profile.heights) EXPECT_TRUE(std::isnan(height) || height == 1.0 * units::um) << height;
}

TEST(TextFile, CompressedCopyIsEqualToTheBit) {
    SETAE_REQUIRE_REFERENCE_DATA(path, in_folder("matrix-4.txt"));
    const auto plain = std::get<HeightMap>(read(path.string())),
               packed = std::get<HeightMap>(read(path.string() + ".gz"));
    EXPECT_TRUE((plain.heights == packed.heights).all());
    EXPECT_EQ(plain.size, packed.size);
}

TEST(TextFile, ColumnsWithoutUnitReportTheMissingUnit) {
    SETAE_REQUIRE_REFERENCE_DATA(path, in_folder("xy-1.txt"));
    const auto channel = open(path.string()).at(0);
    EXPECT_EQ(channel.info.shape, std::vector<Index>{132});
    EXPECT_TRUE(channel.info.unit.empty());
    EXPECT_THROW((void)channel.read(), InvalidArgument);
}

TEST(TextFile, ThreeColumnsWithoutHeaderReportTheirInterpretation) {
    for (const auto* name : {"xyz-1.txt", "xyz-1-different-order.txt", "xyz-2.txt"}) {
        SETAE_REQUIRE_REFERENCE_DATA(path, in_folder(name));
        const auto points = open(path.string(), microns).at(0);
        ASSERT_EQ(points.info.alerts.size(), 1u) << name;
        EXPECT_EQ(points.info.alerts[0].code, "AMBIGUOUS_COLUMNS");
        auto as_matrix = microns;
        as_matrix.layout = TextLayout::matrix;
        EXPECT_EQ(open(path.string(), as_matrix).at(0).info.shape, (std::vector<Index>{3, 16}));
    }
}

TEST(Dektak, KeepsResultsOfTheInstrument) {
    SETAE_REQUIRE_REFERENCE_DATA(path, in_folder("dektak-1.csv"));
    const auto metadata = topography::metadata(read(path.string()));
    EXPECT_DOUBLE_EQ(metadata.instrument.tip_radius.value(), 2.5e-6);
    EXPECT_EQ(metadata.format, "dektak-csv");
    EXPECT_EQ(metadata.attributes.at("Rq"), "0.01143 um");
    EXPECT_EQ(metadata.attributes.at("Force"), "3.00 mg");
}

TEST(Mitutoyo, KeepsParametersOfTheInstrument) {
    SETAE_REQUIRE_REFERENCE_DATA(path, in_folder("mitutoyo_2_mock.xlsx"));
    const auto metadata = topography::metadata(read(path.string()));
    for (const auto& [name, value] :
         {std::pair{"Ra", "3.308 µm"}, {"Rq", "3.959 µm"},  {"Rz", "18.485 µm"}, {"Rp", "8.244 µm"},
          {"Rv", "10.240 µm"},         {"Rsk", "-0.144"},   {"Rku", "2.463"},    {"Rc", "13.306 µm"},
          {"RSm", "419.9 µm"},         {"RDq", "0.157"},    {"Rmr", "0.030 %"},  {"Rmr(c)1", "2.911 %"},
          {"Rmr(c)2", "5.822 %"},      {"Rdc", "1.828 µm"}, {"Rt", "22.233 µm"}, {"Rz1max", "22.062 µm"},
          {"Rk", "11.440 µm"},         {"Rpk", "2.912 µm"}, {"Rvk", "3.980 µm"}, {"Mr1", "5.822 %"},
          {"Mr2", "92.617 %"},         {"A1", "8.48"},      {"A2", "14.69"}})
        EXPECT_TRUE(metadata.attributes.contains(name) && metadata.attributes.at(name).starts_with(value))
            << name << ": " << (metadata.attributes.contains(name) ? metadata.attributes.at(name) : "");
    EXPECT_EQ(metadata.attributes.at("Cut-Off"), "2.5mm");
    EXPECT_EQ(metadata.acquisition_time, "20- Jun -2023");
    EXPECT_EQ(metadata.instrument.name, "Mitutoyo SurfTest");
}

/// Published rms height in metres, of the profile without its parabola, n − 1 degrees of freedom.
struct Mirror {
    const char* file;
    double rms;
    double tolerance;  ///< relative: the digits given
};

double rms_without_parabola(const topography::Measurement& measurement) {
    const Array1D heights = topography::all_heights(topography::detrended(measurement, topography::Trend::parabola));
    return std::sqrt(heights.square().sum() / static_cast<double>(heights.size() - 1));
}

TEST(Dabam, GivesThePublishedRmsHeights) {
    for (const auto& mirror : {Mirror{"dabam-010", 3.048414e-9, 2e-6}, Mirror{"dabam-011", 3.23343e-9, 2e-6},
                               Mirror{"dabam-014", 15.372782e-9, 1e-2}, Mirror{"dabam-041", 10.854e-9, 1e-3},
                               Mirror{"dabam-045", 62e-9, 1e-2}}) {
        SETAE_REQUIRE_REFERENCE_DATA(path, std::string("topography/profiles/") + mirror.file + ".dat");
        const auto channel = open(path.string()).at(0);
        EXPECT_EQ(channel.info.format, "dabam");
        EXPECT_NEAR(rms_without_parabola(channel.read()), mirror.rms, mirror.tolerance * mirror.rms) << mirror.file;
        const bool of_slopes = mirror.file == std::string("dabam-041") || mirror.file == std::string("dabam-045");
        EXPECT_EQ(channel.info.alerts.size(), of_slopes ? 1u : 0u) << mirror.file;
    }
}

TEST(Dabam, NumbersWithoutDescriptionOpenByTheirHeader) {
    for (const auto* name : {"dabam-010", "dabam-014", "dabam-041"}) {
        SETAE_REQUIRE_REFERENCE_DATA(path, std::string("topography/profiles/") + name + ".dat");
        const auto beside = open(path.string());
        const auto alone = open(bytes::memory_source("alone.dat", bytes::read_file(path.string())), {});
        double described = 0.0, by_header = INFINITY;
        for (const auto& channel : beside)
            if (channel.info.is_height && channel.info.alerts.empty()) described = rms_without_parabola(channel.read());
        for (const auto& channel : alone)
            if (channel.info.is_height) by_header = rms_without_parabola(channel.read());
        EXPECT_NEAR(described, by_header, 1e-9 * described) << name;
    }
}

TEST(Dabam, NumbersWithoutDescriptionOrNamesRequireAUnit) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/profiles/dabam-045.dat");
    const auto channel = open(bytes::memory_source("alone.dat", bytes::read_file(path.string())), {}).at(0);
    EXPECT_EQ(channel.info.format, "xy");
    EXPECT_EQ(channel.info.shape, std::vector<Index>{1301});
    EXPECT_TRUE(channel.info.unit.empty());
}

TEST(TextFile, OtherTextIsRefused) {
    SETAE_REQUIRE_REFERENCE_DATA(path, in_folder("nonsense_txt_file.txt"));
    EXPECT_THROW((void)open(path.string()), FormatError);
}

}  // namespace
}  // namespace setae::formats::text_files_test
