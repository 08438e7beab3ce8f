// SPDX-License-Identifier: GPL-3.0-or-later
// NetCDF, NPY, NPZ and MAT: additions to the tests of all formats.
#include <cmath>

#include <gtest/gtest.h>

#include "byte_builder.hpp"
#include "counted_source.hpp"
#include "error_message.hpp"
#include "format_samples.hpp"
#include "hdf5_builder.hpp"
#include "sample_files.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/channel.hpp"
#include "setae/formats/format.hpp"
#include "setae/formats/netcdf.hpp"

using namespace setae::tests;

namespace setae::formats::arrays_test {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Profile;
using namespace tests;

FormatSample named(const std::vector<FormatSample>& samples, const std::string& name) {
    for (const auto& sample : samples)
        if (sample.name == name) return sample;
    throw InvalidArgument("no sample " + name);
}

std::vector<Channel> channels_of(const FormatSample& sample, const ReadOptions& options = {}) {
    return open(bytes::memory_source("sample", sample.content), options);
}

constexpr std::uint64_t gigabyte = std::uint64_t{1} << 30, megabyte = 1 << 20;

// ---- NetCDF ---------------------------------------------------------------------------------------------------------

TEST(NetCdf, ReadsInstrumentAndTimeFromTheJsonAttribute) {
    const auto channels = channels_of(named(netcdf_samples(), "map, version 1"));
    const auto& metadata = channels.at(0).info.metadata;
    EXPECT_EQ(metadata.instrument.name, "NewView");
    EXPECT_DOUBLE_EQ(metadata.instrument.tip_radius.value(), 10e-9);
    EXPECT_EQ(metadata.acquisition_time, "2020-01-02 03:04:05");
    EXPECT_EQ(metadata.attributes.at("operator"), "A. B.");
    EXPECT_TRUE(std::get<HeightMap>(channels[0].read()).periodic);
}

TEST(NetCdf, UnequalStepsGiveAProfile) {
    const auto profile = std::get<Profile>(channels_of(named(netcdf_samples(), "unequal steps")).at(0).read());
    EXPECT_DOUBLE_EQ(profile.positions[2], 1.5e-6);
    EXPECT_DOUBLE_EQ(profile.heights[3], 5e-9);
}

TEST(NetCdf,
     AxesHaveSeparateUnits) {  // SurfaceTopography refuses a file whose heights are in another unit than its axes
    const auto channel = channels_of(named(netcdf_samples(), "records")).at(0);
    EXPECT_DOUBLE_EQ(channel.info.size[0], 5e-6);
    EXPECT_EQ(channel.info.unit, "nm");
}

TEST(NetCdf, Version4IsRead) {  // SurfaceTopography reads only the classic format
    const auto map = std::get<HeightMap>(channels_of(named(netcdf_samples(), "version 4, packed")).at(0).read());
    EXPECT_TRUE(map.periodic);
    EXPECT_DOUBLE_EQ(map.size[1], 1e-6);
}

TEST(NetCdf, DimensionWithoutValuesIsNotAnAxis) {
    Hdf5Builder file;
    file.dataset("/heights", H5T_IEEE_F64LE, {3}, {1.0, 2.0, 4.0}).attribute("/heights", "unit", std::string("nm"));
    file.attribute("/", "_NCProperties", std::string("version=2"));
    file.dataset("/x", H5T_IEEE_F32BE, {3}, {})
        .attribute("/x", "NAME", std::string("This is a netCDF dimension but not a netCDF variable.         3"));
    const auto channel = open(bytes::memory_source("sample", file.bytes()), {.size = {{6e-6}}, .unit = {}}).at(0);
    EXPECT_EQ(channel.info.format, "nc");
    EXPECT_DOUBLE_EQ(std::get<LineScan>(channel.read()).size, 6e-6);
}

TEST(NetCdf, FillValuesOfTheLibraryAreUndefined) {
    Hdf5Builder file;
    file.dataset("/heights", H5T_IEEE_F64LE, {2, 2}, {1.0, 2.0, 9.9692099683868690e+36, 4.0})
        .attribute("/heights", "unit", std::string("nm"));
    file.attribute("/", "_NCProperties", std::string("version=2"));
    const auto map = std::get<HeightMap>(
        open(bytes::memory_source("sample", file.bytes()), {.size = {{1e-6, 1e-6}}, .unit = {}}).at(0).read());
    EXPECT_TRUE(std::isnan(map.heights(1, 0)));
    EXPECT_EQ(map.heights.isNaN().count(), 1);
}

TEST(NetCdf, HeightsWithoutUnitUseTheUnitOfPositions) {  // as SurfaceTopography writes unequal steps
    Hdf5Builder file;
    file.dataset("/heights", H5T_IEEE_F64LE, {3}, {1.0, 2.0, 4.0})
        .dataset("/x", H5T_IEEE_F64LE, {3}, {0.0, 1.0, 3.0})
        .attribute("/x", "unit", std::string("um"));
    const auto profile = std::get<Profile>(open(bytes::memory_source("sample", file.bytes()), {}).at(0).read());
    EXPECT_DOUBLE_EQ(profile.heights[2], 4e-6);
    EXPECT_DOUBLE_EQ(profile.positions[2], 3e-6);
}

TEST(NetCdf, UnitsInTheFileOverrideGivenUnits) {
    const TemporaryFolder folder;
    Table table;
    table.columns = {{"x", "m", Array1D{{0.0, 1.0, 3.0}}}, {"heights", "m", Array1D{{0.5, 0.25, 0.125}}}};
    write_netcdf(folder.path("t.nc"), table);
    EXPECT_DOUBLE_EQ(std::get<Profile>(read(folder.path("t.nc"), 0, {{}, "um"})).positions[2], 3.0);
}

TEST(NetCdf, WithoutUnitIsListedAndTheUnitReportedMissing) {
    const TemporaryFolder folder;
    Table table;
    table.columns = {{"x", "", Array1D{{0.0, 1.0, 3.0}}}, {"heights", "", Array1D{{0.5, 0.25, 0.125}}}};
    write_netcdf(folder.path("t.nc"), table);
    const auto channel = open(folder.path("t.nc")).at(0);
    EXPECT_EQ(missing(channel.info)[1], "unit");
    EXPECT_NE(message_of([&] { (void)channel.read(); }).find("states no unit"), std::string::npos);
}

TEST(NetCdf, RefusesRecordsWithoutACount) {
    auto sample = named(netcdf_samples(), "records");
    sample.content.replace(4, 4, "\xff\xff\xff\xff");
    EXPECT_NE(message_of([&] { (void)channels_of(sample); }).find("number of records was never written"),
              std::string::npos);
}

TEST(NetCdf, OpeningReadsTheHeaderOnly) {
    constexpr Index n = 11'000;
    ByteBuilder header(std::endian::big);
    header.text("CDF")
        .number(std::uint8_t{2})
        .number(std::uint32_t{0})
        .number(std::uint32_t{10})
        .number(std::uint32_t{2});
    for (const char* name : {"x", "y"})
        header.number(std::uint32_t{1}).text(name, 4).number(static_cast<std::uint32_t>(n));
    header.number(std::uint64_t{0})
        .number(std::uint32_t{11})
        .number(std::uint32_t{1})
        .number(std::uint32_t{7})
        .text("heights", 8);
    header.number(std::uint32_t{2})
        .number(std::uint32_t{0})
        .number(std::uint32_t{1})
        .number(std::uint64_t{0})
        .number(std::uint32_t{6})
        .number(std::uint32_t{0})
        .number(std::uint64_t{256});
    const CountedSource large(header.content(), gigabyte);
    EXPECT_EQ(open(large.source(), {}).at(0).info.shape, (std::vector<Index>{n, n}));
    EXPECT_LT(large.bytes(), megabyte);
}

// ---- NPY and NPZ ----------------------------------------------------------------------------------------------------

std::string npy_of(const std::string& type, const std::string& shape, const std::string& values) {
    ByteBuilder file;
    const auto dictionary = "{'descr': " + type + ", 'fortran_order': False, 'shape': " + shape + ", }\n";
    file.text("\x93NUMPY")
        .number(std::uint8_t{1})
        .number(std::uint8_t{0})
        .number(static_cast<std::uint16_t>(dictionary.size()))
        .text(dictionary)
        .text(values);
    return file.content();
}

TEST(Npy, RecordsAndOtherNumberTypesAreRefused) {
    const auto message = [](const std::string& content) {
        return message_of([&] { (void)open(bytes::memory_source("a.npy", content), {}); });
    };
    EXPECT_NE(message(npy_of("[('x', '<f8')]", "(2,)", std::string(16, '\0'))).find("records"), std::string::npos);
    for (const char* type : {"'<f2'", "'<c16'", "'|O'", "'<U3'", "'|b1'", "'<f16'"})
        EXPECT_NE(message(npy_of(type, "(2, 2)", std::string(64, '\0'))).find("expected floats"), std::string::npos)
            << type;
    EXPECT_NE(message(npy_of("'<f8'", "(2, 2, 2)", std::string(64, '\0'))).find("3 dimensions"), std::string::npos);
    EXPECT_NE(message(npy_of("'<f8'", "()", std::string(8, '\0'))).find("0 dimensions"), std::string::npos);
}

TEST(Npy, ArraysOfOneDimensionAreLines) {  // SurfaceTopography reads only two dimensions
    const auto line = std::get<LineScan>(
        channels_of(named(npy_samples(), "line of uint64"), {.size = {{2e-6}}, .unit = "nm"}).at(0).read());
    EXPECT_DOUBLE_EQ(line.heights[4], 7e-9);
}

TEST(Npy, WithoutSizeAndUnitItIsListed) {
    const auto channel = channels_of(named(npy_samples(), "float64")).at(0);
    EXPECT_EQ(channel.info.shape, (std::vector<Index>{6, 4}));
    EXPECT_THROW((void)channel.read(), InvalidArgument);
}

TEST(Npy, OpeningReadsTheHeaderOnly) {
    const CountedSource large(npy_of("'<f4'", "(16384, 16000)", ""), gigabyte);
    EXPECT_EQ(open(large.source(), {}).at(0).info.shape, (std::vector<Index>{16384, 16000}));
    EXPECT_LT(large.bytes(), megabyte);
}

TEST(Npz, ListsArraysAndIgnoresSingleNumbers) {
    const auto channels = channels_of(named(npz_samples(), "four arrays"));
    ASSERT_EQ(channels.size(), 3u);
    EXPECT_EQ(channels[0].info.name, "names");
    EXPECT_FALSE(channels[0].info.is_height);
    EXPECT_NE(channels[0].info.not_heights.find("expected floats"), std::string::npos);
    EXPECT_EQ(channels[1].info.name, "other");
    EXPECT_EQ(channels[2].info.name, "height");
    EXPECT_EQ(missing(channels[1].info)[0], "size");
    EXPECT_EQ(preferred_channel(channels), 2u) << "a name of heights goes before others";
}

TEST(Npz, ArchivesWithOtherMembersAreNotNpz) {
    const auto archive =
        zip_archive({{"a.npy", npy_of("'<f8'", "(2, 2)", std::string(32, '\0'))}, {"readme.txt", "words"}});
    EXPECT_THROW((void)open(bytes::memory_source("a.zip", archive), {}), FormatError);
}

// ---- MATLAB ---------------------------------------------------------------------------------------------------------

TEST(Mat, RowsAreLinesAlongX) {  // SurfaceTopography takes the row as x
    const auto sample = named(mat_samples(), "level 4, float64");
    const auto map = std::get<HeightMap>(channels_of(sample, sample.options).at(0).read());
    EXPECT_EQ(map.shape(), (std::array<Index, 2>{6, 4}));  // 4 rows of 6 columns
    EXPECT_DOUBLE_EQ(map.heights(5, 0), sample.heights(5, 0));
}

TEST(Mat, Version73IsRead) {  // SurfaceTopography 1.22 reads up to version 7.2
    const auto sample = named(mat_samples(), "version 7.3");
    const auto channels = channels_of(sample, sample.options);
    ASSERT_EQ(channels.size(), 1u);  // neither the text nor the content of the struct
    EXPECT_EQ(channels[0].info.name, "height");
    EXPECT_EQ(channels[0].info.orientation, "rows of the matrix from the top, as stored");
}

TEST(Mat, SizeAndUnitAreReportedMissing) {  // SurfaceTopography has none and does not require any
    for (const auto& sample : mat_samples()) {
        const auto channel = channels_of(sample).at(sample.channel);
        EXPECT_EQ(missing(channel.info)[0], "size");
        EXPECT_EQ(missing(channel.info)[1], "unit");
        EXPECT_THROW((void)channel.read(), InvalidArgument);
    }
}

TEST(Mat, TextsAreNotHeights) { EXPECT_EQ(channels_of(named(mat_samples(), "level 4, float64")).size(), 1u); }

TEST(Mat, ComplexMatricesAreListedOnly) {
    auto sample = named(mat_samples(), "level 5, float64");
    sample.content[128 + 8 + 8 + 1] = 0x08;  // the flag of complex numbers of the first matrix
    const auto channels = channels_of(sample, sample.options);
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_FALSE(channels[0].info.is_height);
    EXPECT_EQ(channels[0].info.shape, (std::vector<Index>{3, 5}));
    EXPECT_TRUE(channels[1].info.is_height);
}

TEST(Mat, LogicalMatricesAreIgnored) {
    auto sample = named(mat_samples(), "level 5, float64");
    sample.content[128 + 8 + 8 + 1] = 0x02;
    EXPECT_EQ(channels_of(sample).size(), 1u);
}

TEST(Mat, FilesWithStructsOnlyAreRefused) {
    auto sample = named(mat_samples(), "level 5, whole doubles kept as int16");
    sample.content[128 + 8 + 8] = 2;  // the class of structs
    EXPECT_NE(message_of([&] { (void)channels_of(sample); }).find("structs, cells and objects"), std::string::npos);
}

TEST(Mat, CompressedMatrixWithTooLargeASizeIsRefused) {
    constexpr std::uint32_t side = 20000, values = 8 * side * side;
    ByteBuilder header;  // of a matrix of 3 GB
    header.number(std::uint32_t{14})
        .number(values + 48u)
        .number(std::uint32_t{6})
        .number(std::uint32_t{8})
        .number(std::uint32_t{6})
        .number(std::uint32_t{0});
    header.number(std::uint32_t{5})
        .number(std::uint32_t{8})
        .number(side)
        .number(side)
        .number(std::uint32_t{1 << 16 | 1})
        .text("h", 4)
        .number(std::uint32_t{9})
        .number(values);
    const auto length = static_cast<std::uint16_t>(header.size());
    ByteBuilder packed;  // a zlib stream with one block that is stored, not deflated
    packed.number(std::uint8_t{0x78})
        .number(std::uint8_t{0x01})
        .number(std::uint8_t{1})
        .number(length)
        .number(static_cast<std::uint16_t>(~length))
        .text(header.content())
        .number(std::uint32_t{0});
    ByteBuilder file;
    file.text("MATLAB 5.0 MAT-file", 116, ' ').text("", 8).number(std::uint16_t{0x0100}).text("IM");
    file.number(std::uint32_t{15}).number(static_cast<std::uint32_t>(packed.size())).text(packed.content());
    const auto channel =
        open(bytes::memory_source("a.mat", file.content()), {.size = {{1e-6, 1e-6}}, .unit = "nm"}).at(0);
    EXPECT_EQ(channel.info.alerts.at(0).code, "UNREADABLE_ARRAY");
    EXPECT_NE(message_of([&] { (void)channel.read(); }).find("would become"), std::string::npos);
}

TEST(Mat, OpeningReadsHeadersOnly) {
    ByteBuilder header;
    header.text("MATLAB 5.0 MAT-file", 116, ' ').text("", 8).number(std::uint16_t{0x0100}).text("IM");
    constexpr std::uint32_t rows = 16000, columns = 16384, bytes = 4 * rows * columns;
    header.number(std::uint32_t{14})
        .number(bytes + 48u)
        .number(std::uint32_t{6})
        .number(std::uint32_t{8})
        .number(std::uint32_t{7})
        .number(std::uint32_t{0});
    header.number(std::uint32_t{5})
        .number(std::uint32_t{8})
        .number(rows)
        .number(columns)
        .number(std::uint32_t{1 << 16 | 1})
        .text("h", 4)
        .number(std::uint32_t{7})
        .number(bytes);
    const CountedSource large(header.content(), header.size() + bytes);
    EXPECT_EQ(open(large.source(), {}).at(0).info.shape, (std::vector<Index>{columns, rows}));
    EXPECT_LT(large.bytes(), megabyte);
}

}  // namespace
}  // namespace setae::formats::arrays_test
