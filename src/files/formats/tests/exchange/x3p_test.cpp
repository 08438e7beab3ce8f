// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "error_message.hpp"
#include "format_samples.hpp"
#include "patched_sample.hpp"
#include "sample_files.hpp"
#include "setae/bytes/archive.hpp"
#include "setae/bytes/digest.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/formats/format.hpp"

using namespace setae::tests;

namespace setae::formats::tests::x3p_test {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

constexpr const char* incremental = "<AxisType>I</AxisType><DataType>D</DataType><Increment>1e-6</Increment>";
constexpr const char* doubles = "<AxisType>A</AxisType><DataType>D</DataType>";
constexpr const char* two_by_three =
    "<MatrixDimension><SizeX>2</SizeX><SizeY>3</SizeY><SizeZ>1</SizeZ></MatrixDimension>";
constexpr const char* linked = "<DataLink><PointDataLink>d.bin</PointDataLink></DataLink>";

const auto data = bytes_of<double>({1, 2, 3, 4, 5, 6});

std::vector<Channel> opened(const Members& members, const ReadOptions& options = {}) {
    return open(bytes::memory_source("a.x3p", zip_archive(members)), options);
}
std::string refusal(const Members& members) {
    return message_of([&] {
        for (const auto& channel : opened(members)) (void)channel.read();
    });
}
TEST(X3p, RevisionsOtherThanTheFirstAreRead) {
    for (const auto* revision : {"ISO5436 – 2000", "ISO25178-72:2017/DAM1", ""}) {
        const auto xml =
            replaced(x3p_document("SUR", incremental, doubles, two_by_three, linked), "ISO5436 - 2000", revision);
        EXPECT_EQ(std::get<HeightMap>(opened({{"main.xml", xml}, {"d.bin", data}}).at(0).read()).heights(1, 2), 6.0)
            << revision;
    }
}

TEST(X3p, HeightsAreReadOnDemand) {
    const auto xml = x3p_document(
        "SUR", incremental, doubles, two_by_three,
        "<DataLink><PointDataLink>d.bin</PointDataLink><MD5ChecksumPointData>00000000000000000000000000000000</MD5ChecksumPointData></DataLink>");
    const auto channels = opened({{"main.xml", xml}, {"d.bin", data}});
    EXPECT_EQ(channels.at(0).info.shape, (std::vector<Index>{2, 3}));
    EXPECT_EQ(message_of([&] { (void)channels[0].read(); }),
              "a.x3p: d.bin: at byte 0: X3P: the MD5 checksum is " + bytes::md5(data) +
                  ", but main.xml states 00000000000000000000000000000000; it is damaged");
}

TEST(X3p, ChecksumsThatAreMissingShortOrInCapitalsAreTolerated) {
    std::string capitals = bytes::md5(data);
    for (auto& c : capitals) c = static_cast<char>(std::toupper(c));
    for (const auto& sum : {std::string(), std::string("33ee4e"), capitals}) {
        const auto xml = x3p_document(
            "SUR", incremental, doubles, two_by_three,
            fmt::format(
                "<DataLink><PointDataLink>d.bin</PointDataLink><MD5ChecksumPointData>{}</MD5ChecksumPointData></DataLink>",
                sum));
        EXPECT_EQ(std::get<HeightMap>(opened({{"main.xml", xml}, {"d.bin", data}}).at(0).read()).heights(0, 0), 1.0)
            << sum;
    }
}

TEST(X3p, ChecksumOfValidPointsIsVerified) {
    const auto with_sum = [](const std::string& sum) {
        return x3p_document(
            "SUR", incremental, doubles, two_by_three,
            fmt::format(
                "<DataLink><PointDataLink>d.bin</PointDataLink><ValidPointsLink>v</ValidPointsLink><MD5ChecksumValidPoints>{}</MD5ChecksumValidPoints></DataLink>",
                sum));
    };
    EXPECT_TRUE(std::isnan(
        std::get<HeightMap>(
            opened({{"main.xml", with_sum(bytes::md5("\x3e"))}, {"d.bin", data}, {"v", "\x3e"}}).at(0).read())
            .heights(0, 0)));
    EXPECT_NE(refusal({{"main.xml", with_sum(bytes::md5("\x3f"))}, {"d.bin", data}, {"v", "\x3e"}})
                  .find("a.x3p: v: at byte 0: X3P: the MD5 checksum"),
              std::string::npos);
    EXPECT_NE(refusal({{"main.xml", with_sum("")}, {"d.bin", data}, {"v", ""}}).find("0 bytes for 6 points"),
              std::string::npos);
}

TEST(X3p, PointsAllInvalidAreRefused) {
    const auto xml =
        x3p_document("SUR", incremental, doubles, two_by_three,
                     "<DataLink><PointDataLink>d.bin</PointDataLink><ValidPointsLink>v</ValidPointsLink></DataLink>");
    EXPECT_EQ(refusal({{"main.xml", xml}, {"d.bin", data}, {"v", std::string(1, '\0')}}),
              "a.x3p: all 6 heights are undefined");
}

TEST(X3p, ChangedDocumentGivesAWarning) {
    const auto xml = x3p_document("SUR", incremental, doubles, two_by_three, linked + std::string());
    const auto with_sum = replaced(xml, "</p:ISO5436_2>",
                                   "<Record4><ChecksumFile>md5checksum.hex</ChecksumFile></Record4></p:ISO5436_2>");
    const auto alerts = [&](const std::string& sum) {
        return opened({{"main.xml", with_sum}, {"d.bin", data}, {"md5checksum.hex", sum}}).at(0).info.alerts;
    };
    EXPECT_TRUE(alerts(bytes::md5(with_sum) + " *main.xml\n").empty());
    EXPECT_TRUE(alerts("short").empty());
    ASSERT_EQ(alerts(bytes::md5(xml)).size(), 1u);
    EXPECT_EQ(alerts(bytes::md5(xml))[0].code, "CHECKSUM");
}

TEST(X3p, MissingIncrementIsReported) {
    const auto xml = x3p_document("SUR", "<AxisType>I</AxisType><DataType>D</DataType>", doubles, two_by_three, linked);
    const Members members{{"main.xml", xml}, {"d.bin", data}};
    EXPECT_EQ(missing(opened(members).at(0).info).front(), "size");
    EXPECT_NE(refusal(members).find("`size`"), std::string::npos);
    EXPECT_EQ(std::get<HeightMap>(opened(members, {.size = {{1e-6, 2e-6}}}).at(0).read()).size[1], 2e-6);
}

TEST(X3p, NegativeIncrementIsReadAsALength) {
    const auto xml = x3p_document("SUR", "<AxisType>I</AxisType><DataType>D</DataType><Increment>-3e-6</Increment>",
                                  doubles, two_by_three, linked);
    EXPECT_DOUBLE_EQ(opened({{"main.xml", xml}, {"d.bin", data}}).at(0).info.size[0], 6e-6);
}

TEST(X3p, OneBadNestedArchiveDoesNotAffectOthers) {
    const auto good =
        zip_archive({{"main.xml", x3p_document("SUR", incremental, doubles, two_by_three, linked)}, {"d.bin", data}});
    const auto channels = opened({{"bad.x3p", good.substr(0, 100)}, {"good.x3p", good}});
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_EQ(channels[0].info.alerts.at(0).code, "UNREADABLE_MEMBER");
    EXPECT_NE(message_of([&] { (void)channels[0].read(); }).find("bad.x3p: at byte 100"), std::string::npos);
    EXPECT_EQ(channels[1].info.name, "good.x3p: height");
    EXPECT_EQ(std::get<HeightMap>(channels[1].read()).heights(1, 2), 6.0);
}

TEST(X3p, DoublyNestedArchivesAreNotOpened) {
    const auto good =
        zip_archive({{"main.xml", x3p_document("SUR", incremental, doubles, two_by_three, linked)}, {"d.bin", data}});
    EXPECT_NE(refusal({{"outer.x3p", zip_archive({{"inner.x3p", good}})}}).find("no main.xml"), std::string::npos);
}

TEST(X3p, LayersOfListedPointsAreRefused) {
    const auto xml = x3p_document("SUR", incremental, doubles,
                                  "<MatrixDimension><SizeX>1</SizeX><SizeY>2</SizeY><SizeZ>3</SizeZ></MatrixDimension>",
                                  "<DataList><Datum>1</Datum></DataList>");
    EXPECT_NE(refusal({{"main.xml", xml}}).find("3 layers"), std::string::npos);
    const auto many =
        replaced(x3p_document("SUR", incremental, doubles, two_by_three, linked), "<SizeZ>1", "<SizeZ>100000");
    EXPECT_NE(refusal({{"main.xml", many}, {"d.bin", data}}).find("100000 layers, expected at most 256"),
              std::string::npos);
}

TEST(X3p, LayersOfAProfileAreLineScans) {
    const auto xml =
        x3p_document("PRF", incremental, doubles,
                     "<MatrixDimension><SizeX>3</SizeX><SizeY>1</SizeY><SizeZ>2</SizeZ></MatrixDimension>", linked);
    const auto channels = opened({{"main.xml", xml}, {"d.bin", data}});
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_EQ(channels[1].info.name, "height, layer 2");
    EXPECT_EQ(std::get<LineScan>(channels[1].read()).heights[0], 4.0);
}

TEST(X3p, ListThatExceedsMemoryIsRefused) {
    std::string list = "<DataList>";
    for (int k = 0; k < 1'100'000; ++k) list += "<Datum/>";
    EXPECT_NE(refusal({{"main.xml", x3p_document("SUR", incremental, doubles, two_by_three, list + "</DataList>")}})
                  .find("main.xml has 11000"),
              std::string::npos);
}

TEST(X3p, IgnoresUnknownEntriesAndTheDateOf1970) {
    auto xml =
        replaced(x3p_document("SUR", incremental, doubles, two_by_three, linked), "2020-01-02", "1970-01-01T01:00:00");
    xml = replaced(xml, "<Manufacturer>M", "<Manufacturer>not available");
    const auto info = opened({{"main.xml", xml}, {"d.bin", data}}).at(0).info;
    EXPECT_EQ(info.metadata.acquisition_time, "");
    EXPECT_FALSE(info.metadata.attributes.contains("manufacturer"));
    EXPECT_EQ(info.metadata.instrument.name, "Scope");
}

// ---- written
// ----------------------------------------------------------------------------------------------------------

HeightMap small_map() {
    HeightMap map{lopsided_heights(3, 2, 1e-9), {3e-6, 5e-6}, false, {}};
    map.heights(2, 1) = NAN;
    map.metadata.instrument = {
        .name = "Scope <7>", .type = "confocal", .tip_radius = {}, .tip_radius_standard_error = {}, .resolution = {}};
    map.metadata.acquisition_time = "2021-03-04T05:06:07";
    return map;
}

std::string written_document(const topography::Measurement& measurement) {
    const TemporaryFolder folder;
    format_to_write("a.x3p").write(folder.path("a.x3p"), measurement);
    return bytes::Archive(bytes::file_source(folder.path("a.x3p"))).read("main.xml");
}

TEST(X3pWriter, ElementsAreInTheOrderOfTheSchema) {
    const auto xml = written_document(small_map());
    std::size_t at = 0;
    for (const auto* element : {"<p:ISO5436_2",
                                "<Record1>",
                                "<Revision>ISO5436 - 2000<",
                                "<FeatureType>SUR<",
                                "<Axes>",
                                "<CX>",
                                "<AxisType>I<",
                                "<DataType>D<",
                                "<Increment>1e-06<",
                                "<Offset>0<",
                                "<CY>",
                                "<Increment>2.5e-06<",
                                "<CZ>",
                                "<AxisType>A<",
                                "<Record2>",
                                "<Date>2021-03-04T05:06:07<",
                                "<Instrument>",
                                "<Manufacturer>not available<",
                                "<Model>Scope &lt;7&gt;<",
                                "<Serial>",
                                "<Version>",
                                "<CalibrationDate>",
                                "<ProbingSystem>",
                                "<Type>NonContacting<",
                                "<Identification>",
                                "<Record3>",
                                "<MatrixDimension>",
                                "<SizeX>3<",
                                "<SizeY>2<",
                                "<SizeZ>1<",
                                "<DataLink>",
                                "<PointDataLink>bindata/data.bin<",
                                "<MD5ChecksumPointData>",
                                "<Record4>",
                                "<ChecksumFile>md5checksum.hex<"}) {
        const auto found = xml.find(element, at);
        ASSERT_NE(found, std::string::npos) << element << " behind byte " << at << " of\n" << xml;
        at = found + 1;
    }
}

TEST(X3pWriter, ChecksumsMatchTheMembers) {
    const TemporaryFolder folder;
    format_to_write("a.x3p").write(folder.path("a.x3p"), small_map());
    const bytes::Archive archive(bytes::file_source(folder.path("a.x3p")));
    const auto xml = archive.read("main.xml");
    EXPECT_EQ(archive.read("md5checksum.hex"), bytes::md5(xml) + " *main.xml\n");
    EXPECT_NE(xml.find("<MD5ChecksumPointData>" + bytes::md5(archive.read("bindata/data.bin")) + "<"),
              std::string::npos);
    EXPECT_EQ(archive.size("bindata/data.bin"), 48u);
}

TEST(X3pWriter, SameHeightsGiveTheSameBytes) {
    const TemporaryFolder folder;
    format_to_write("a.x3p").write(folder.path("a.x3p"), small_map());
    format_to_write("a.x3p").write(folder.path("b.x3p"), small_map());
    EXPECT_EQ(bytes::read_file(folder.path("a.x3p")), bytes::read_file(folder.path("b.x3p")));
}

TEST(X3pWriter, TimeInAnotherFormatIsWrittenAsAComment) {
    auto map = small_map();
    map.metadata.acquisition_time = "09:57:48 AM Tue Jan 12 2016";
    const auto xml = written_document(map);
    EXPECT_NE(xml.find("<Date>1970-01-01T00:00:00</Date>"), std::string::npos);
    EXPECT_NE(xml.find("<Comment>measured 09:57:48 AM Tue Jan 12 2016</Comment>"), std::string::npos);
}

TEST(X3pWriter, WritesDatesInXmlFormat) {
    auto map = small_map();
    for (const auto& [time, date] : {std::pair{"2016-01-12 09:57", "2016-01-12T09:57:00"},
                                     {"2016-01-12", "2016-01-12T00:00:00"},
                                     {"2016-01-12T09:57:48.25+02:00", "2016-01-12T09:57:48.25+02:00"},
                                     {"2016-01-12 09:57:48 Z", "2016-01-12T09:57:48Z"},
                                     {"2016-13-12", "1970-01-01T00:00:00"},
                                     {"", "1970-01-01T00:00:00"}}) {
        map.metadata.acquisition_time = time;
        EXPECT_NE(written_document(map).find(fmt::format("<Date>{}</Date>", date)), std::string::npos) << time;
    }
}

TEST(X3pWriter, ProfilesKeepTheirPositions) {
    const TemporaryFolder folder;
    const Profile uneven{
        (Array1D(4) << 1e-6, 2e-6, 5e-6, 5.5e-6).finished(), (Array1D(4) << 1e-9, NAN, -3e-9, 2e-9).finished(), {}};
    format_to_write("a.x3p").write(folder.path("a.x3p"), uneven);
    const auto back = std::get<Profile>(read(folder.path("a.x3p")));
    EXPECT_TRUE((back.positions == uneven.positions).all());
    EXPECT_EQ(back.heights[2], -3e-9);
    EXPECT_TRUE(std::isnan(back.heights[1]));
    EXPECT_NE(written_document(uneven).find("<FeatureType>PRF<"), std::string::npos);
}

TEST(X3pWriter, RefusesUnsupportedDataAndMissingFolders) {
    Profile traced{(Array1D(2) << 0.0, 1e-6).finished(), (Array1D(2) << 0.0, 1e-9).finished(), {}};
    traced.standard_error = Array1D::Constant(2, 1e-10);
    EXPECT_NE(message_of([&] { format_to_write("a.x3p").write("a.x3p", traced); }).find("write it as .csv"),
              std::string::npos);
    EXPECT_NE(message_of([&] {
                  format_to_write("a.x3p").write("/no/such/folder/a.x3p", small_map());
              }).find("/no/such/folder/a.x3p: cannot be created"),
              std::string::npos);
}

}  // namespace
}  // namespace setae::formats::tests::x3p_test
