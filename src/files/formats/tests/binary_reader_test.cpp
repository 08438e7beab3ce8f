// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "sample_files.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/channel.hpp"
#include "setae/formats/netcdf.hpp"
#include "setae/formats/npy.hpp"

using namespace setae::tests;

namespace setae::formats::tests::binary_reader_test {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

std::string message_of(const std::string& content, const ReadOptions& options = {}) {
    const TemporaryFolder folder;
    try {
        for (const auto& channel : open(folder.write("file", content), options)) (void)channel.read();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

class NanoscopeOfWidth : public testing::TestWithParam<int> {};

TEST_P(NanoscopeOfWidth, ScalesHeightsOnceAndReversesRows) {
    const TemporaryFolder folder;
    const auto channels = open(folder.write("a.di", nanoscope_file(5, 3, GetParam())));
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_EQ(channels[0].info.shape, (std::vector<Index>{5, 3}));
    const auto map = std::get<HeightMap>(channels[0].read());
    const double unit = 2.0 * 20e-9 / std::pow(256.0, GetParam());
    EXPECT_DOUBLE_EQ(map.heights(4, 0), unit * (40 + 2));
    EXPECT_DOUBLE_EQ(map.heights(0, 2), 0.0);
    EXPECT_DOUBLE_EQ(map.heights(1, 1), unit * (10 + 1));
    EXPECT_DOUBLE_EQ(map.size[0], 500e-9);
    EXPECT_DOUBLE_EQ(map.size[1], 250e-9);
    EXPECT_EQ(map.metadata.instrument.name, "Dimension V");
    EXPECT_EQ(map.metadata.unit, "nm");
}

INSTANTIATE_TEST_SUITE_P(Nanoscope, NanoscopeOfWidth, testing::Values(2, 4));

TEST(Nanoscope, PhaseIsListedButNotAHeight) {
    const TemporaryFolder folder;
    const auto channels = open(folder.write("a.di", nanoscope_file(4, 4, 2)));
    EXPECT_EQ(channels.at(1).info.name, "Phase");
    EXPECT_FALSE(channels[1].info.is_height);
    EXPECT_THROW((void)channels[1].read(), InvalidArgument);
}

TEST(Nanoscope, BlockOfFourBytesOverridesBytesPerPixel) {
    auto file = nanoscope_file(4, 3, 4);
    for (auto at = file.find("Bytes/pixel: 4"); at != std::string::npos; at = file.find("Bytes/pixel: 4"))
        file[at + 13] = '2';
    const TemporaryFolder folder;
    const auto map = std::get<HeightMap>(read(folder.write("a.di", file)));
    EXPECT_DOUBLE_EQ(map.heights(3, 0), 2.0 * 20e-9 / std::pow(2.0, 32) * 32);
}

TEST(Nanoscope, TruncatedFileIsRefusedAtOpenWithItsOffset) {
    const auto file = nanoscope_file(8, 8, 2);
    EXPECT_NE(message_of(file.substr(0, file.size() - 1)).find(fmt::format("at byte {}", file.size() - 1)),
              std::string::npos);
    EXPECT_NE(message_of(file.substr(0, 300)).find("truncated"), std::string::npos);
}

TEST(Nanoscope, RefusesAHeaderThatAnnouncesGigabytes) {
    auto file = nanoscope_file(8, 8, 2);
    file.replace(file.find("Samps/line: 8"), 13, "Samps/line: 99999999");
    EXPECT_NE(message_of(file).find("99999999"), std::string::npos);
}

constexpr const char* incremental = "<AxisType>I</AxisType><DataType>D</DataType><Increment>1e-6</Increment>";
constexpr const char* signed_short =
    "<AxisType>A</AxisType><DataType>I</DataType><Increment>0.001</Increment><Offset>-0.5</Offset>";
constexpr const char* two_by_three =
    "<MatrixDimension><SizeX>2</SizeX><SizeY>3</SizeY><SizeZ>1</SizeZ></MatrixDimension>";

TEST(X3p, SignedIntegersUseIncrementOffsetAndMask) {
    const auto xml = x3p_document("SUR", incremental, signed_short, two_by_three,
                                  "<DataLink><PointDataLink>bindata/data.bin</PointDataLink><MD5ChecksumPointData/>"
                                  "<ValidPointsLink>bindata/valid.bin</ValidPointsLink></DataLink>");
    const auto data = bytes_of<std::int16_t>({-100, 0, 100, 1548, 7, 300});
    const TemporaryFolder folder;
    const auto path = folder.write(
        "a.x3p", zip_archive({{"main.xml", xml}, {"bindata/data.bin", data}, {"bindata/valid.bin", "\x2f"}}));
    const auto map = std::get<HeightMap>(read(path));
    EXPECT_DOUBLE_EQ(map.heights(0, 0), -0.6);
    EXPECT_DOUBLE_EQ(map.heights(1, 1), 1.048);
    EXPECT_TRUE(std::isnan(map.heights(0, 2)));
    EXPECT_DOUBLE_EQ(map.heights(1, 2), -0.2);
    EXPECT_DOUBLE_EQ(map.size[0], 2e-6);
    EXPECT_DOUBLE_EQ(map.size[1], 6e-6);
    EXPECT_EQ(map.metadata.instrument.name, "Scope");
}

TEST(X3p, EachTypeIsRead) {
    const std::pair<const char*, std::string> types[] = {{"I", bytes_of<std::int16_t>({-1, 2, 3, 4, 5, 6})},
                                                         {"L", bytes_of<std::int32_t>({-1, 2, 3, 4, 5, 6})},
                                                         {"F", bytes_of<float>({-1, 2, 3, 4, 5, 6})},
                                                         {"D", bytes_of<double>({-1, 2, 3, 4, 5, 6})}};
    const TemporaryFolder folder;
    for (const auto& [type, data] : types) {
        const auto axis = fmt::format("<AxisType>A</AxisType><DataType>{}</DataType>", type);
        const auto xml = x3p_document("SUR", incremental, axis, two_by_three,
                                      "<DataLink><PointDataLink>d.bin</PointDataLink></DataLink>");
        const auto map =
            std::get<HeightMap>(read(folder.write("a.x3p", zip_archive({{"main.xml", xml}, {"d.bin", data}}))));
        EXPECT_EQ(map.heights(0, 0), -1.0) << type;
        EXPECT_EQ(map.heights(1, 2), 6.0) << type;
    }
}

TEST(X3p, ListedPointsOfABareDocumentAreRead) {
    const auto xml = x3p_document(
        "SUR", incremental, signed_short, two_by_three,
        "<DataList><Datum>500</Datum><Datum>501</Datum><Datum/><Datum>503</Datum><Datum>504</Datum><Datum>505</Datum></DataList>");
    const TemporaryFolder folder;
    const auto map = std::get<HeightMap>(read(folder.write("a.xml", xml)));
    EXPECT_NEAR(map.heights(1, 0), 0.001, 1e-15);
    EXPECT_TRUE(std::isnan(map.heights(0, 1)));
}

TEST(X3p, ProfilesAreLinesOrPolylines) {
    const TemporaryFolder folder;
    const auto z = "<AxisType>A</AxisType><DataType>D</DataType>";
    const auto absolute = "<AxisType>A</AxisType><DataType>D</DataType>";
    const auto list = "<ListDimension>3</ListDimension>";
    const auto line = x3p_document("PRF", incremental, z, list,
                                   "<DataList><Datum>1</Datum><Datum>2</Datum><Datum>3</Datum></DataList>");
    EXPECT_DOUBLE_EQ(std::get<LineScan>(read(folder.write("a.x3p", zip_archive({{"main.xml", line}})))).size, 3e-6);
    const auto uneven = x3p_document("PRF", absolute, z, list,
                                     "<DataList><Datum>0;1</Datum><Datum>2;2</Datum><Datum>3;4</Datum></DataList>");
    EXPECT_DOUBLE_EQ(std::get<Profile>(read(folder.write("b.xml", uneven))).positions[1], 2.0);
}

TEST(X3p, DamageIsRefused) {
    const auto link = [](const char* checksum) {
        return x3p_document(
            "SUR", incremental, signed_short, two_by_three,
            fmt::format(
                "<DataLink><PointDataLink>d.bin</PointDataLink><MD5ChecksumPointData>{}</MD5ChecksumPointData></DataLink>",
                checksum));
    };
    const auto data = bytes_of<std::int16_t>({1, 2, 3, 4, 5, 6});
    EXPECT_NE(
        message_of(zip_archive({{"main.xml", link("00000000000000000000000000000000")}, {"d.bin", data}})).find("MD5"),
        std::string::npos);
    EXPECT_NE(message_of(zip_archive({{"main.xml", link("")}, {"d.bin", data.substr(2)}})).find("10 bytes"),
              std::string::npos);
    EXPECT_NE(message_of(zip_archive({{"main.xml", link("")}})).find("no member 'd.bin'"), std::string::npos);
    EXPECT_NE(message_of(zip_archive({{"main.xml", "<a>"}})).find("main.xml"), std::string::npos);
    auto huge = link("");
    huge.replace(huge.find("<SizeX>2"), 8, "<SizeX>2000000000");
    EXPECT_NE(message_of(zip_archive({{"main.xml", huge}, {"d.bin", data}})).find("2000000000"), std::string::npos);
}

std::string npy(const std::string& header, const std::string& data, char version = 1) {
    std::string file = std::string("\x93NUMPY") + version + '\0' + static_cast<char>(header.size()) + '\0';
    if (version > 1) file += std::string(2, '\0');
    return file + header + data;
}

TEST(Npy, EachTypeAndOrderIsRead) {
    const auto big = [](std::string bytes, std::size_t width) {
        for (std::size_t i = 0; i < bytes.size(); i += width)
            std::reverse(bytes.begin() + static_cast<long>(i), bytes.begin() + static_cast<long>(i + width));
        return bytes;
    };
    const auto doubles = bytes_of<double>({1, 2, 3, 4, 5, 6});
    const std::tuple<const char*, const char*, std::string> files[] = {
        {"<f8", "False", doubles},
        {">f8", "False", big(doubles, 8)},
        {"<f4", "False", bytes_of<float>({1, 2, 3, 4, 5, 6})},
        {"<i2", "False", bytes_of<std::int16_t>({1, 2, 3, 4, 5, 6})},
        {">i4", "False", big(bytes_of<std::int32_t>({1, 2, 3, 4, 5, 6}), 4)},
        {"|u1", "False", bytes_of<std::uint8_t>({1, 2, 3, 4, 5, 6})},
        {"<i8", "False", bytes_of<std::int64_t>({1, 2, 3, 4, 5, 6})},
        {"<f8", "True", bytes_of<double>({1, 4, 2, 5, 3, 6})}};
    const TemporaryFolder folder;
    for (const auto& [type, fortran, data] : files)
        for (const char version : {'\1', '\2', '\3'}) {
            const auto header =
                fmt::format("{{'descr': '{}', 'fortran_order': {}, 'shape': (2, 3), }}\n", type, fortran);
            const auto map =
                std::get<HeightMap>(read(folder.write("a.npy", npy(header, data, version)), 0, {{{2e-6, 3e-6}}, "nm"}));
            EXPECT_DOUBLE_EQ(map.heights(0, 2), 3e-9) << type << fortran;
            EXPECT_DOUBLE_EQ(map.heights(1, 0), 4e-9) << type << fortran;
        }
}

TEST(Npy, RequiresSizeAndUnit) {
    const auto file = npy("{'descr': '<f8', 'fortran_order': False, 'shape': (2,), }\n", bytes_of<double>({1, 2}));
    EXPECT_NE(message_of(file, {{{1e-6}}, {}}).find("`unit`"), std::string::npos);
    EXPECT_NE(message_of(file, {{}, "nm"}).find("`size`"), std::string::npos);
    EXPECT_NE(message_of(file, {{{1e-6, 1e-6}}, "nm"}).find("2 sizes"), std::string::npos);
    EXPECT_EQ(message_of(file, {{{1e-6}}, "nm"}), "no error");
}

TEST(Npy, RefusesAHeaderThatAnnouncesMoreThanTheFile) {
    const ReadOptions options{{{1e-6, 1e-6}}, "nm"};
    for (const auto* shape : {"(40000, 40000)", "(9223372036854775807, 9223372036854775807)", "(2, 2)"})
        EXPECT_NE(
            message_of(npy(fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': {}, }}", shape), "12345678"),
                       options)
                .find("NPY"),
            std::string::npos);
    EXPECT_NE(
        message_of(npy("{'descr': '<c8', 'fortran_order': False, 'shape': (2, 2), }", "12345678"), options).find("<c8"),
        std::string::npos);
}

TEST(Npy, WrittenArraysAreReadBack) {
    const TemporaryFolder folder;
    Array2D map(3, 2);
    map << 1, 2, 3, 0.1, 5, 6;
    write_npy(folder.path("m.npy"), map);
    const auto back = std::get<HeightMap>(read(folder.path("m.npy"), 0, {{{3.0, 2.0}}, "m"}));
    EXPECT_TRUE((back.heights == map).all());
    const Array1D line = Array1D::LinSpaced(5, 0.0, 1.0);
    write_npy(folder.path("l.npy"), line);
    EXPECT_TRUE((std::get<LineScan>(read(folder.path("l.npy"), 0, {{{5.0}}, "m"})).heights == line).all());
    EXPECT_EQ(bytes::read_file(folder.path("l.npy")).size() % 8, 0u);
}

TEST(Container, ReadsEachMeasurementWithTheMetadataOfTheIndex) {
    const TemporaryFolder folder;
    const auto channels = open(folder.write("c.zip", container_file()));
    ASSERT_EQ(channels.size(), 3u);
    const auto line = std::get<LineScan>(channels[0].read());
    EXPECT_EQ(channels[0].info.name, "line");
    EXPECT_EQ(channels[0].info.recommended_trend, topography::Trend::parabola);
    EXPECT_DOUBLE_EQ(line.heights[1], 6e-6);
    EXPECT_TRUE(line.periodic);
    EXPECT_DOUBLE_EQ(line.metadata.instrument.tip_radius.value(), 5e-6);
    EXPECT_EQ(line.metadata.attributes.at("surface"), "wafer");
}

TEST(Container, ScaleOfTheIndexIsIgnoredForFilesWithTheirOwnScale) {
    const TemporaryFolder folder;
    const auto inside = std::get<HeightMap>(read(folder.write("c.zip", container_file()), 2));
    const auto alone = std::get<HeightMap>(read(folder.write("a.di", nanoscope_file(4, 3, 2))));
    EXPECT_TRUE((inside.heights == alone.heights).all());
    EXPECT_EQ(inside.metadata.name, "image");
}

TEST(Container, OneBadMemberDoesNotAffectOthers) {
    const TemporaryFolder folder;
    const auto channels = open(folder.write("c.zip", container_file()));
    EXPECT_EQ(channels.at(1).info.alerts.at(0).code, "UNREADABLE_MEMBER");
    EXPECT_FALSE(channels[1].info.is_height);
    EXPECT_THROW((void)channels[1].read(), FormatError);
}

TEST(Container, YamlTagsAreIgnored) {
    const TemporaryFolder folder;
    const std::string yaml =
        "surfaces:\n- name: a\n  topographies:\n  - name: '1'\n    datafile: {original: l.txt}\n    size: !!python/tuple\n    - 3.0\n"
        "    unit: nm\n    height_scale: 1.0\n    measurement_date: 2016-02-15\n    detrend_mode: height\n"
        "    tags: !!python/object/apply:os.system ['touch /tmp/no']\n";
    const auto path = folder.write("c.zip", zip_archive({{"meta.yml", yaml}, {"l.txt", "0 1\n1 2\n2 4\n"}}));
    const auto channels = open(path);
    EXPECT_EQ(channels.at(0).info.name, "1");
    EXPECT_DOUBLE_EQ(channels[0].info.size.at(0), 3e-9);
    EXPECT_TRUE(channels[0].info.alerts.empty());
    EXPECT_EQ(channels[0].info.recommended_trend, topography::Trend::tilt);
}

TEST(Container, SizeThatDiffersFromTheFileGivesAWarning) {
    const TemporaryFolder folder;
    const std::string index =
        R"({"surfaces": [{"topographies": [{"name": "l", "datafile": {"original": "l.txt"}, "size": [7], "unit": "nm"}]}]})";
    const auto channels =
        open(folder.write("c.zip", zip_archive({{"index.json", index}, {"l.txt", "0 1\n1 2\n2 4\n"}})));
    EXPECT_EQ(channels.at(0).info.alerts.at(0).code, "SIZE_MISMATCH");
    EXPECT_DOUBLE_EQ(channels[0].info.size.at(0), 3e-9);
}

TEST(Container, DamagedIndexIsRefused) {
    EXPECT_NE(message_of(zip_archive({{"index.json", "{\"surfaces\": ["}})).find("index.json"), std::string::npos);
    EXPECT_NE(message_of(zip_archive({{"index.json", "{}"}})).find("no list of surfaces"), std::string::npos);
    EXPECT_NE(message_of(zip_archive({{"meta.yml", "surfaces: ]"}})).find("meta.yml:1"), std::string::npos);
    EXPECT_NE(message_of(zip_archive({{"other", ""}})).find("not one of the supported formats"), std::string::npos);
    const auto whole = container_file();
    EXPECT_NE(message_of(whole.substr(0, whole.size() / 2)).find("truncated"), std::string::npos);
}

TEST(NetCdf, WritesTablesAsClassicFilesWithoutTopography) {
    const TemporaryFolder folder;
    Table table;
    table.columns = {{"wavevector", "1/m", Array1D::LinSpaced(3, 1.0, 3.0)},
                     {"C1D", "m3", Array1D::LinSpaced(3, 0.0, 1.0)}};
    table.metadata["source"] = "test";
    write_netcdf(folder.path("t.nc"), table);
    const auto bytes = bytes::read_file(folder.path("t.nc"));
    EXPECT_TRUE(bytes.starts_with(std::string("CDF\x02", 4)));
    EXPECT_NE(bytes.find("wavevector"), std::string::npos);
    EXPECT_NE(message_of(bytes).find("no variable 'heights'"), std::string::npos);
}

TEST(NetCdf, WrittenHeightsAreReadBack) {
    const TemporaryFolder folder;
    Table table;
    table.columns = {{"x", "", Array1D{{0.0, 1.0, 3.0}}}, {"heights", "", Array1D{{0.5, 0.25, 0.125}}}};
    write_netcdf(folder.path("t.nc"), table);
    const auto profile = std::get<Profile>(read(folder.path("t.nc"), 0, {{}, "um"}));
    EXPECT_DOUBLE_EQ(profile.positions[2], 3e-6);
    EXPECT_DOUBLE_EQ(profile.heights[2], 0.125e-6);
}

TEST(NetCdf, WrittenTopographiesKeepSizeAndPeriodicity) {
    const TemporaryFolder folder;
    topography::HeightMap map{Array2D::Random(5, 3) * 1e-9, {2e-6, 1.1e-6}, true, {}};
    map.heights(1, 2) = undefined;
    write_netcdf(folder.path("a.nc"), map);
    const auto map_back = std::get<topography::HeightMap>(read(folder.path("a.nc")));
    EXPECT_TRUE(std::isnan(map_back.heights(1, 2)));
    map.heights(1, 2) = 0.0;
    auto heights_back = map_back.heights;
    heights_back(1, 2) = 0.0;
    EXPECT_TRUE((heights_back == map.heights).all());
    EXPECT_NEAR(map_back.size[0], 2e-6, 1e-20);
    EXPECT_NEAR(map_back.size[1], 1.1e-6, 1e-20);
    EXPECT_TRUE(map_back.periodic);

    write_netcdf(folder.path("a.nc"), topography::LineScan{Array1D{{1e-9, 2e-9, 4e-9, 8e-9}}, 4e-6, false, {}});
    const auto scan = std::get<topography::LineScan>(read(folder.path("a.nc")));
    EXPECT_NEAR(scan.size, 4e-6, 1e-20);
    EXPECT_EQ(scan.heights[3], 8e-9);
    EXPECT_FALSE(scan.periodic);

    write_netcdf(folder.path("a.nc"), Profile{Array1D{{0.0, 1e-9, 5e-9}}, Array1D{{1e-9, 3e-9, 2e-9}}, {}});
    const auto profile = std::get<Profile>(read(folder.path("a.nc")));
    EXPECT_EQ(profile.positions[1], 1e-9);
    EXPECT_EQ(profile.heights[2], 2e-9);
}

TEST(NetCdf, MapsOfOneGridHaveCoordinates) {
    const TemporaryFolder folder;
    const Array2D gaps = Array2D::Random(5, 3) * 1e-9;
    const std::array maps{GridMap{"heights", "m", gaps}, GridMap{"pressure", "Pa", Array2D::Zero(5, 3)}};
    write_netcdf(folder.path("m.nc"), maps, {2e-6, 1.1e-6}, true);
    const auto map = std::get<HeightMap>(read(folder.path("m.nc")));
    EXPECT_TRUE((map.heights == gaps).all());
    EXPECT_NEAR(map.size[0], 2e-6, 1e-20);
    EXPECT_NEAR(map.size[1], 1.1e-6, 1e-20);
    EXPECT_TRUE(map.periodic);
    EXPECT_NE(bytes::read_file(folder.path("m.nc")).find("pressure"), std::string::npos);
    const std::array uneven{GridMap{"gap", "m", gaps}, GridMap{"pressure", "Pa", Array2D::Zero(3, 5)}};
    EXPECT_THROW(write_netcdf(folder.path("m.nc"), uneven, {2e-6, 1e-6}, true), InvalidArgument);
}

TEST(NetCdf, RefusesTablesThatDoNotFitTheFormat) {
    const TemporaryFolder folder;
    Table uneven;
    uneven.columns = {{"a", "1", Array1D::Zero(2)}, {"b", "1", Array1D::Zero(3)}};
    EXPECT_THROW(write_netcdf(folder.path("t.nc"), uneven), InvalidArgument);
    Table twice;
    twice.columns = {{"a", "1", Array1D::Zero(2)}, {"a", "1", Array1D::Zero(2)}};
    EXPECT_THROW(write_netcdf(folder.path("t.nc"), twice), InvalidArgument);
    Table fine;
    fine.columns = {{"a", "1", Array1D::Zero(2)}};
    EXPECT_THROW(write_netcdf(folder.path("missing/t.nc"), fine), FileError);
}

}  // namespace
}  // namespace setae::formats::tests::binary_reader_test
