// SPDX-License-Identifier: GPL-3.0-or-later
// Hostile files: archives, compression, XML, and headers.
#include <zlib.h>

#include <gtest/gtest.h>

#include "byte_builder.hpp"
#include "error_message.hpp"
#include "sample_files.hpp"
#include "setae/bytes/archive.hpp"
#include "setae/bytes/cursor.hpp"
#include "setae/bytes/expand.hpp"
#include "setae/bytes/xml_file.hpp"
#include "setae/formats/format.hpp"

using namespace setae::tests;

namespace setae::formats::tests::bounded_input_test {
namespace {

std::string deflated(const std::string& content) {
    uLongf size = compressBound(content.size());
    std::string stream(size, '\0');
    compress2(reinterpret_cast<Bytef*>(stream.data()), &size, reinterpret_cast<const Bytef*>(content.data()),
              content.size(), 9);
    stream.resize(size);
    return stream;
}

TEST(ZipArchive, RefusesPathsOutsideTheArchive) {
    for (const auto* name : {"../evil.txt", "a/../../evil", "/etc/passwd", "C:\\evil", "..\\evil"})
        EXPECT_NE(message_of([&] {
                      bytes::Archive archive(bytes::memory_source("x.zip", zip_archive({{name, "1"}})));
                  }).find("outside the folder"),
                  std::string::npos)
            << name;
    EXPECT_NO_THROW(bytes::Archive(bytes::memory_source("x.zip", zip_archive({{"a..b/..c", "1"}}))));
}

TEST(ZipArchive, RefusesADecompressionBomb) {
    const bytes::Archive archive(
        bytes::memory_source("bomb.zip", zip_archive({{"zeros", std::string(20'000'000, '\0')}, {"small", "12"}})));
    EXPECT_NE(message_of([&] { (void)archive.read("zeros"); }).find("member 'zeros' expands"), std::string::npos);
    EXPECT_EQ(archive.read("small"), "12");
    EXPECT_NE(message_of([&] { (void)archive.member("zeros").all(); }).find("announces 20000000 bytes"),
              std::string::npos);
}

TEST(ZipArchive, MemberRemainsReadableAfterTheArchiveIsGone) {
    std::string content(200'000, 'a');
    for (std::size_t i = 0; i < content.size(); ++i) content[i] = static_cast<char>(i * 7919 % 251);
    const auto member = [&] {
        return bytes::Archive(bytes::memory_source("x.zip", zip_archive({{"data", content}}))).member("data");
    }();
    EXPECT_EQ(member.size, content.size());
    EXPECT_EQ(member.name, "x.zip: data");
    EXPECT_EQ(member.head(10), content.substr(0, 10));
    EXPECT_EQ(member.bytes(150'000, 100), content.substr(150'000, 100));
    EXPECT_EQ(member.all(), content);
    EXPECT_NE(message_of([&] { (void)member.bytes(199'999, 2); }).find("truncated"), std::string::npos);
}

TEST(ZipArchive, TruncatedIsRefusedWithTheOffsetOfItsEnd) {
    const auto whole = zip_archive({{"a", "1"}});
    const auto message =
        message_of([&] { bytes::Archive archive(bytes::memory_source("x.zip", whole.substr(0, whole.size() - 5))); });
    EXPECT_TRUE(message.starts_with("x.zip: at byte " + std::to_string(whole.size() - 5))) << message;
}

TEST(Expansion, RecoversTheCompressedContent) {
    const auto source = bytes::memory_source("x", "");
    EXPECT_EQ(bytes::inflated(deflated("heights"), source, 0, "SUR"), "heights");
    EXPECT_EQ(bytes::inflated(deflated("heights") + "behind", source, 0, "SUR"), "heights");
    EXPECT_EQ(bytes::inflated(deflated(std::string(1'000'000, 'x')), source, 0, "SUR").size(), 1'000'000u);
}

TEST(Expansion, RefusesBombsAndDamage) {
    const auto source = bytes::memory_source("x.sur", "");
    const auto bomb = deflated(std::string(20'000'000, '\0'));
    EXPECT_NE(message_of([&] { (void)bytes::inflated(bomb, source, 512, "SUR"); }).find("x.sur: at byte 512: SUR: "),
              std::string::npos);
    auto stream = deflated("some heights of a surface that was measured");
    EXPECT_NE(message_of([&] {
                  (void)bytes::inflated(stream.substr(0, stream.size() / 2), source, 0, "SUR");
              }).find("end early"),
              std::string::npos);
    stream[stream.size() / 2] = static_cast<char>(stream[stream.size() / 2] ^ 0x55);
    EXPECT_NE(message_of([&] { (void)bytes::inflated(stream, source, 0, "SUR"); }).find("damaged"), std::string::npos);
    EXPECT_NE(message_of([&] {
                  (void)bytes::expanded_zstd("no zstd", source, 0, "ZON");
              }).find("ZON: compressed data are damaged"),
              std::string::npos);
}

TEST(GzipFile, IsReadAsTheFileInside) {
    z_stream stream{};
    ASSERT_EQ(deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY), Z_OK);
    std::string content = "x [um]\th [nm]\n0\t1\n1\t3\n2\t2\n", packed(1000, '\0');
    stream.next_in = reinterpret_cast<Bytef*>(content.data());
    stream.avail_in = static_cast<uInt>(content.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    ASSERT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    const auto channels = open(bytes::memory_source("line.txt.gz", packed), {});
    ASSERT_EQ(channels.size(), 1u);
    EXPECT_EQ(channels[0].info.shape, std::vector<Index>{3});
    EXPECT_NE(message_of([&] {
                  (void)open(bytes::memory_source("cut.gz", packed.substr(0, packed.size() - 12)), {});
              }).find("cut.gz: at byte"),
              std::string::npos);
}

TEST(Xml, EntitiesAreRefused) {
    const auto source = bytes::memory_source("main.xml", "");
    const std::string laughs = "<?xml version=\"1.0\"?><!DOCTYPE a [<!ENTITY b \"bbbb\">]><a>&b;</a>";
    const auto message = message_of([&] { (void)bytes::parsed_xml(laughs, source, "X3P"); });
    EXPECT_NE(message.find("main.xml: at byte 21: X3P: XML with declarations"), std::string::npos) << message;
    EXPECT_NE(message_of([&] { (void)bytes::parsed_xml("<a><b></a>", source, "X3P"); }).find("at byte"),
              std::string::npos);
    EXPECT_STREQ(bytes::parsed_xml("<a>1</a>", source, "X3P").child_value("a"), "1");
}

TEST(Cursor, ReadsNumbersAndTextsInEitherOrder) {
    ByteBuilder file(std::endian::big);
    file.number<std::uint16_t>(0x0102).text("K\xf6nig\0xx", 8).number<float>(1.5f);
    bytes::Cursor cursor(bytes::memory_source("f", file.content()), "X", 0, std::endian::big);
    EXPECT_EQ(cursor.number<std::uint16_t>(), 0x0102);
    EXPECT_EQ(cursor.text(8), "König");
    EXPECT_EQ(cursor.number<float>(), 1.5f);
    EXPECT_TRUE(cursor.at_end());
    EXPECT_EQ(cursor.number_at<std::uint16_t>(0), 0x0102);
    EXPECT_EQ(cursor.position(), file.size());
}

TEST(Cursor, NamesTheEndOfTheFileInTheError) {
    bytes::Cursor cursor(bytes::memory_source("f.dat", "12345"), "MetroPro", 2);
    EXPECT_EQ(
        message_of([&] { (void)cursor.number<double>(); }),
        "f.dat: at byte 5: MetroPro: the file ends here, expected 8 bytes from byte 2; it is truncated or damaged");
    EXPECT_EQ(message_of([&] { (void)cursor.bytes(std::uint64_t{1} << 60); }).substr(0, 14), "f.dat: at byte");
    EXPECT_EQ(message_of([&] { cursor.seek(6); }).substr(0, 16), "f.dat: at byte 5");
    (void)cursor.number<std::uint8_t>();
    EXPECT_EQ(message_of([&] { cursor.fail("no such version"); }), "f.dat: at byte 2: MetroPro: no such version");
}

TEST(Source, PartDoesNotReadBeyondItsEnd) {
    const auto part = bytes::part_of(bytes::memory_source("f", "0123456789"), "part", 2, 5);
    EXPECT_EQ(part.all(), "23456");
    EXPECT_THROW((void)part.bytes(3, 3), FormatError);
    EXPECT_THROW((void)bytes::part_of(bytes::memory_source("f", "0123"), "part", 2, 5), FormatError);
}

}  // namespace
}  // namespace setae::formats::tests::bounded_input_test
