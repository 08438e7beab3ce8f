// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "expected_file.hpp"
#include "flattened_lines.hpp"
#include "reference_data.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/channel.hpp"
#include "setae/formats/format.hpp"
#include "setae/tables/table_file.hpp"
#include "setae/topography/detrend.hpp"

namespace setae::formats::topographies_test {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

template <class Heights>
double standard_deviation(const Heights& heights) {
    return std::sqrt((heights - heights.mean()).square().mean());
}

/// Root mean square of a polyline, its square integrated exactly on each segment.
double polyline_rms(const Profile& profile) {
    double sum = 0.0;
    for (Index i = 1; i < profile.positions.size(); ++i) {
        const double a = profile.heights[i - 1], b = profile.heights[i];
        sum += (profile.positions[i] - profile.positions[i - 1]) * (a * a + a * b + b * b) / 3.0;
    }
    return std::sqrt(sum / profile.size());
}

double polyline_slope(const Profile& profile) {
    double sum = 0.0;
    for (Index i = 1; i < profile.positions.size(); ++i)
        sum += std::pow(profile.heights[i] - profile.heights[i - 1], 2) /
               (profile.positions[i] - profile.positions[i - 1]);
    return std::sqrt(sum / profile.size());
}

template <class Type>
Type leveled(const Channel& channel) {
    return std::get<Type>(topography::detrended(channel.read(), channel.info.recommended_trend.value()));
}

TEST(UncdContainer, HasThreeMeasurementsScaledOnce) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/container-2.zip");
    const auto channels = open(path.string());
    ASSERT_EQ(channels.size(), 3u);
    for (const auto& channel : channels) EXPECT_TRUE(channel.info.alerts.empty()) << channel.info.name;

    const auto tem = leveled<Profile>(channels[0]);
    EXPECT_EQ(tem.positions.size(), 76);
    EXPECT_NEAR(tem.size() / units::nm, 228.907, 1e-3);
    EXPECT_NEAR(polyline_rms(tem) / units::nm, 3.44345, 1e-4 * 3.44345);
    EXPECT_NEAR(polyline_slope(tem), 0.381413, 1e-4 * 0.381413);

    const auto afm = leveled<HeightMap>(channels[1]);
    EXPECT_EQ(afm.shape(), (std::array<Index, 2>{512, 512}));
    EXPECT_DOUBLE_EQ(afm.size[0], 100e-9);
    const double sq = std::sqrt(afm.heights.square().mean());
    EXPECT_NEAR(sq / units::nm, 4.68792, 1e-4 * 4.68792);
    const Array2D profiles = afm.heights.rowwise() - afm.heights.colwise().mean();
    const double rq = std::sqrt(profiles.square().mean());
    EXPECT_NEAR(rq / units::nm, 4.35959, 1e-4 * 4.35959);
    EXPECT_GT(std::abs(rq / units::nm - 0.489), 3.0)
        << "the index repeats the scale of the file: applied twice it gives 0.489";

    const auto stylus = leveled<LineScan>(channels[2]);
    EXPECT_EQ(stylus.heights.size(), 3001);
    EXPECT_NEAR(stylus.size / units::mm, 0.298784, 1e-6);
    EXPECT_NEAR(std::sqrt(stylus.heights.square().mean()) / units::nm, 12.1236, 1e-4 * 12.1236);
}

TEST(IndexJsonContainer, HasTheHeightsOfClosedForms) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/containers/index_json.zip");
    const auto channels = open(path.string());
    ASSERT_EQ(channels.size(), 2u);
    const auto map = std::get<HeightMap>(channels[0].read());
    ASSERT_EQ(map.shape(), (std::array<Index, 2>{64, 48}));
    EXPECT_NEAR(map.size[0], 6.4e-6, 1e-18);  // the attribute alone, in single precision, is off by 1e-13 m
    EXPECT_NEAR(map.size[1], 4.8e-6, 1e-18);
    for (Index i = 0; i < 64; ++i)
        for (Index j = 0; j < 48; ++j) {
            const double x = 2.0 * pi * 3.0 * static_cast<double>(i) / 64.0,
                         y = 2.0 * pi * 5.0 * static_cast<double>(j) / 48.0;
            ASSERT_NEAR(map.heights(i, j) / units::um, 0.01 * std::cos(x) + 0.002 * std::sin(y), 1e-12)
                << i << ' ' << j;
        }
    const auto line = std::get<LineScan>(channels[1].read());
    ASSERT_EQ(line.heights.size(), 200);
    for (Index i = 0; i < 200; ++i)
        ASSERT_NEAR(line.heights[i] / units::um, 0.05 * std::sin(2.0 * pi * 4.0 * static_cast<double>(i) / 200.0),
                    1e-12)
            << i;
    EXPECT_EQ(channels[1].info.recommended_trend, topography::Trend::mean);
}

/// A file of expected/topography_files.json with the factor from its unit to metres; `unit` is given where it states
/// none.
struct Expectation {
    std::string file;
    std::size_t channel;
    double factor;
    std::optional<std::string> unit;
};

void PrintTo(const Expectation& expectation, std::ostream* stream) {
    *stream << expectation.file << " channel " << expectation.channel;
}

class ExpectedFile : public testing::TestWithParam<Expectation> {};

TEST_P(ExpectedFile, HasShapeSizeAndHeightsOfAnotherReader) {
    SETAE_REQUIRE_REFERENCE_DATA(path, GetParam().file);
    const auto entry = expected_entry(GetParam().file, GetParam().channel);
    expect_entry_of(open(path.string(), {{}, GetParam().unit}).at(GetParam().channel), entry, GetParam().factor);
}

std::string in_folder(const char* name) { return std::string("topography/surfacetopography/") + name; }

INSTANTIATE_TEST_SUITE_P(Files, ExpectedFile,
                         testing::Values(Expectation{in_folder("di-1.di"), 0, units::nm, {}},
                                         Expectation{in_folder("di-1.di"), 1, units::nm, {}},
                                         Expectation{in_folder("x3p-2.x3p"), 0, units::m, {}}),
                         [](const auto& instance) {
                             std::string name = std::filesystem::path(instance.param.file).filename().string() + "_" +
                                                std::to_string(instance.param.channel);
                             for (auto& c : name)
                                 if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                             return name;
                         });

TEST(Nanoscope, TruncatedFileIsRefusedAtOpen) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/di_corrupted.di");
    try {
        (void)open(path.string());
        FAIL() << "opened";
    } catch (const FormatError& error) {
        EXPECT_NE(std::string(error.what()).find("at byte 489346"), std::string::npos) << error.what();
    }
}

TEST(Nanoscope, PhaseAndAmplitudeAreListedOnly) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/surfacetopography/di-1.di");
    const auto channels = open(path.string());
    ASSERT_EQ(channels.size(), 4u);
    EXPECT_TRUE(channels[1].info.is_height);
    EXPECT_FALSE(channels[2].info.is_height);
    EXPECT_FALSE(channels[3].info.is_height);
    EXPECT_EQ(channels[0].info.metadata.instrument.name, "Dimension V");
}

/// Largest difference in units of what the export can resolve: half a raw step and half its third digit.
double worst_difference(const HeightMap& flattened, const tables::RawTable& exported, double step) {
    double worst = 0.0;
    const auto ny = flattened.heights.cols();
    for (Index i = 0; i < flattened.heights.rows(); ++i)
        for (Index row = 0; row < ny; ++row) {
            const double value = exported.columns[static_cast<std::size_t>(i)].values[row];
            const double digit = value == 0.0 ? 0.0 : std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2.0);
            const double difference = std::abs(flattened.heights(i, ny - 1 - row) / units::nm - value);
            worst = std::max(worst, difference / (0.5 * step + 0.5 * digit));
        }
    return worst;
}

TEST(Nanoscope, FlatteningOfFirstOrderReproducesTheExport) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/nanoscope/full_multiple_images.txt");
    SETAE_REQUIRE_REFERENCE_DATA(export_path, "topography/nanoscope/reference_converted.csv");
    const auto map = std::get<HeightMap>(read(path.string()));
    const auto exported = tables::read_raw_table(bytes::file_source(export_path.string()));
    const double step = 438.6572 * 12.95302 / 65536.0;  // nm, from the file's header
    EXPECT_LE(worst_difference(tests::flattened_lines(map, 1), exported, step), 1.0);
    for (const int other : {0, 2, 3})
        EXPECT_GT(worst_difference(tests::flattened_lines(map, other), exported, step), 50.0) << other;
    const Array2D heights = tests::flattened_lines(map, 1).heights / units::nm;
    EXPECT_NEAR(std::sqrt(heights.square().mean()), 4.325, 5e-4);
    EXPECT_NEAR(heights.abs().mean(), 3.433, 5e-4);
}

TEST(X3p, BinaryAndListedVersionsAgree) {
    for (const auto* name : {"topography/x3p/ISO5436-sample4", "topography/x3p/ISO5436-sample1"}) {
        SETAE_REQUIRE_REFERENCE_DATA(binary_path, std::string(name) + "_bin.x3p");
        const auto binary = std::get<HeightMap>(read(binary_path.string()));
        for (const auto* twin : {".xml", ".x3p"}) {
            const auto listed =
                std::get<HeightMap>(read((tests::reference_data_folder() / (std::string(name) + twin)).string()));
            EXPECT_EQ(binary.size, listed.size);
            EXPECT_TRUE((binary.heights.isNaN() == listed.heights.isNaN()).all());
            EXPECT_TRUE((binary.heights.isNaN() || (binary.heights - listed.heights).abs() < 1e-12).all());
        }
    }
}

TEST(X3p, SignedHeightsUseTheOffsetOfTheAxis) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/x3p/ISO5436-sample4_bin.x3p");
    const auto map = std::get<HeightMap>(read(path.string()));
    EXPECT_NEAR(map.heights.isNaN().select(-1.0, map.heights).maxCoeff(), 1.048, 1e-12);
    EXPECT_EQ(map.heights.isNaN().count(), 1);
    EXPECT_TRUE(std::isnan(map.heights(3, 1)));
}

TEST(X3p, PyramidHasTheExpectedMean) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/x3p/pyramid.x3p");
    const auto map = std::get<HeightMap>(read(path.string()));
    EXPECT_NEAR(map.heights.mean(), 3.6, 1e-12);
    EXPECT_NEAR(standard_deviation(map.heights), 2.2627417, 1e-7);
}

TEST(X3p, PointCloudsAreRefused) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "topography/x3p/ISO5436-sample2.x3p");
    EXPECT_THROW((void)open(path.string()), FormatError);
}

TEST(OtherFormats, AreRefusedWithAOneLineMessage) {
    for (const auto* name : {"nonsense_txt_file.txt", "wrongnpyfile.npy"}) {
        SETAE_REQUIRE_REFERENCE_DATA(path, in_folder(name));
        try {
            (void)open(path.string(), {{}, "nm"});
            ADD_FAILURE() << name << " opened";
        } catch (const FormatError& error) {
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        }
    }
}

}  // namespace
}  // namespace setae::formats::topographies_test
