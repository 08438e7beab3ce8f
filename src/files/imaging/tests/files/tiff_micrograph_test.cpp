// SPDX-License-Identifier: GPL-3.0-or-later
#include "micrograph_checks.hpp"

namespace setae::imaging::tests::tiff_micrograph_test {
namespace {

/// A page's reading with fields of an instrument.
Micrograph read_with(const std::vector<TiffField>& fields) { return read_bytes(TiffFile{}.bytes({fields})); }

/// The data block of Olympus software at a place of the file: pixels of 24 and 12 pm, magnification 600 000.
std::string olympus_block(std::uint64_t at) {
    const Bytes little;
    const std::string head = "SIS0" + std::string(54, '\0') + little.whole(1, 2);
    const std::string list = little.whole(1, 2) + little.whole(1, 2) + little.whole(at + head.size() + 8, 4);
    const std::string general = std::string(10, '\0') + little.whole(static_cast<std::uint64_t>(-12), 2) +
                                little.real64(24) + little.real64(12) + std::string(8, '\0') + little.real64(6e5) +
                                std::string(68, '\0');
    return head + list + general;
}

TEST(TiffMicrograph, ReadsEveryNumberTypeByteOrderAndBigTiff) {
    struct Type {
        std::uint64_t bits, format;
    };
    for (const bool big_endian : {false, true})
        for (const bool big_tiff : {false, true})
            for (const auto& [bits, format] :
                 {Type{8, 1}, {8, 2}, {16, 1}, {16, 2}, {32, 1}, {32, 2}, {32, 3}, {64, 1}, {64, 2}, {64, 3}}) {
                SCOPED_TRACE(testing::Message() << bits << " bit, format " << format << " big endian " << big_endian
                                                << " BigTIFF " << big_tiff);
                const TiffFile file{big_endian, big_tiff};
                std::string pixels;
                for (int i = 1; i <= columns * rows; ++i)
                    pixels += format != 3
                                  ? file.order().whole(static_cast<std::uint64_t>(i), static_cast<int>(bits / 8))
                              : bits == 32 ? file.order().real32(static_cast<float>(i))
                                           : file.order().real64(i);
                auto bytes =
                    file.bytes({{file.shorts(258, bits), file.shorts(339, format), file.longs(279, pixels.size())}});
                bytes.resize(bytes.size() - 2 * columns * rows);
                expect_common_picture(read_bytes(bytes + pixels));
            }
}

TEST(TiffMicrograph, ReadsThePixelSizeOfFeiFromTheScanSectionFirst) {
    const std::string text =
        "[User]\r\nDate=06/13/2016\r\nTime=05:06\r\n[System]\r\nSystemType=Helios\r\n[EScan]\r\nPixelWidth=9e-9\r\nPixelHeight=9e-9\r\n[Scan]\r\nPixelWidth=3e-9\r\nPixelHeight=2e-9\r\n[Beam]\r\nHV=oops\r\n";
    for (const int tag : {34680, 34682}) {
        const auto micrograph = read_with({TiffFile{}.text(tag, text)});
        expect_common_picture(micrograph);
        expect_pixel_size(micrograph, 3e-9, 2e-9);
        EXPECT_EQ(micrograph.pixel_size_source, "FEI metadata [Scan]");
        EXPECT_EQ(micrograph.instrument, "Helios");
        EXPECT_EQ(micrograph.acquisition_time, "06/13/2016 05:06");
        EXPECT_TRUE(has_alert(micrograph, "BAD_NUMBER"));
        EXPECT_TRUE(has_alert(micrograph, "PIXELS_NOT_SQUARE"));
    }
    expect_pixel_size(read_with({TiffFile{}.text(34682, "[EScan]\nPixelWidth=9e-9\nPixelHeight=8e-9\n")}), 9e-9, 8e-9);
    expect_pixel_size(
        read_with({TiffFile{}.text(34682, "[Beam]\nHFW=6e-6\nVFW=2e-6\n[Image]\nResolutionX=3\nResolutionY=2\n")}),
        2e-6, 1e-6);
    EXPECT_FALSE(read_with({TiffFile{}.text(34682, "[Scan]\nPixelWidth=notafloat\nPixelHeight=1e-9\n")}).pixel_size);
}

TEST(TiffMicrograph, ReadsThePixelSizeOfOlympus) {
    const TiffFile tiff;
    const auto plain = tiff.bytes({{tiff.longs(33560, 0)}});
    const auto micrograph = read_bytes(tiff.bytes({{tiff.longs(33560, plain.size())}}) + olympus_block(plain.size()));
    expect_common_picture(micrograph);
    expect_pixel_size(micrograph, 24e-12, 12e-12);
    EXPECT_EQ(micrograph.attributes.at("magnification"), "600000");
    EXPECT_TRUE(has_alert(read_bytes(tiff.bytes({{tiff.longs(33560, 9)}})), "BAD_CALIBRATION"));
}

TEST(TiffMicrograph, IgnoresThumbnails) {
    const TiffFile tiff;
    const auto first_wide = tiff.bytes({{tiff.longs(254, 1)}, {}});
    EXPECT_FALSE(has_alert(read_bytes(first_wide), "SEVERAL_IMAGES"));
    const auto beside_olympus =
        tiff.bytes({{tiff.longs(256, 9)}, {tiff.longs(33560, 0)}});  // the first page would be truncated
    expect_common_picture(read_bytes(beside_olympus));
    const auto small = tiff.bytes({{tiff.longs(256, 1)}, {}});
    expect_common_picture(read_bytes(small));
    const auto stack = tiff.bytes({{}, {tiff.shorts(262, 0)}});
    EXPECT_TRUE(has_alert(read_bytes(stack), "SEVERAL_IMAGES"));
    EXPECT_FLOAT_EQ(read_bytes(stack, {.image = "1"}).pixels(0, 0), 5.0f);  // white is 0
    EXPECT_THROW((void)read_bytes(stack, {.image = "2"}), InvalidArgument);
}

TEST(TiffMicrograph, ReadsThePixelSizeOfDigitalMicrograph) {
    const TiffFile tiff;
    const auto micrograph =
        read_with({tiff.text(65003, "\xB5m"), tiff.text(65004, "nm"), tiff.real(65009, 0.5), tiff.real(65010, 250)});
    expect_pixel_size(micrograph, 5e-7, 2.5e-7);
    EXPECT_EQ(micrograph.unit, "\xC2\xB5m, nm");
    EXPECT_FALSE(
        read_with({tiff.text(65003, ""), tiff.text(65004, ""), tiff.real(65009, 1), tiff.real(65010, 1)}).pixel_size);
}

TEST(TiffMicrograph, ReadsThePixelSizeOfImageJPerAxis) {
    const TiffFile tiff;
    for (const std::string unit : {"micron", "\\u00B5m", "um"})
        expect_pixel_size(read_with({tiff.text(270, "ImageJ=1.53\nunit=" + unit + "\n"), tiff.ratio(282, 4, 1),
                                     tiff.ratio(283, 8, 1), tiff.shorts(296, 1)}),
                          0.25e-6, 0.125e-6);
    expect_pixel_size(read_with({tiff.text(270, "ImageJ=1.53\nunit=inch\n"), tiff.ratio(282, 100000, 1)}), 2.54e-7,
                      2.54e-7);
    EXPECT_FALSE(read_with({tiff.text(270, "ImageJ=1.53\nunit=pixel\n"), tiff.ratio(282, 4, 1)}).pixel_size);
}

TEST(TiffMicrograph, UsesResolutionsFinerThanPrint) {
    const TiffFile tiff;
    EXPECT_FALSE(read_with({tiff.ratio(282, 300, 1), tiff.ratio(283, 300, 1), tiff.shorts(296, 2)}).pixel_size);
    expect_pixel_size(read_with({tiff.ratio(282, 10000000, 1), tiff.ratio(283, 20000000, 1), tiff.shorts(296, 3)}),
                      1e-9, 5e-10);
}

TEST(TiffMicrograph, ReadsThePixelSizeOfOmeXml) {
    const TiffFile tiff;
    expect_pixel_size(
        read_with({tiff.text(
            270,
            R"(<?xml version="1.0"?><OME><Image><Pixels PhysicalSizeX="0.5" PhysicalSizeY="2.5" PhysicalSizeXUnit="nm" PhysicalSizeYUnit="Å"/></Image></OME>)")}),
        5e-10, 2.5e-10);
    expect_pixel_size(
        read_with({tiff.text(270, R"(<OME><Image><Pixels PhysicalSizeX="0.5" PhysicalSizeY="0.5"/></Image></OME>)")}),
        5e-7, 5e-7);
    EXPECT_FALSE(read_with({tiff.text(270, "<OME><Image>")}).pixel_size);
}

TEST(TiffMicrograph, MarksInstrumentsUntestedOnRealFiles) {
    const TiffFile tiff;
    const auto zeiss = read_with(
        {tiff.text(34118, "\r\n0\r\nAP_WD\r\nWD = 4.0 mm\r\nAP_IMAGE_PIXEL_SIZE\r\nImage Pixel Size = 1.25 nm\r\n")});
    expect_pixel_size(zeiss, 1.25e-9, 1.25e-9);
    EXPECT_TRUE(has_alert(zeiss, "UNTESTED_FORMAT"));
    const auto sem = read_with({tiff.text(270, "$CM_FORMAT 1\r\n$$SM_MICRON_BAR 80\r\n$$SM_MICRON_MARKER 100nm\r\n")});
    expect_pixel_size(sem, 1.25e-9, 1.25e-9);
    EXPECT_TRUE(has_alert(sem, "UNTESTED_FORMAT"));
    const std::string xml =
        "<TemReporter><ImageFormingSystem><ModeString>MAG</ModeString><SelectorValue>50000</SelectorValue></ImageFormingSystem></TemReporter>";
    const auto sightx =
        read_with({tiff.text(270, xml), tiff.ratio(282, 254, 1), tiff.ratio(283, 508, 1), tiff.shorts(296, 2)});
    expect_pixel_size(sightx, 1e-4 / 50000, 0.5e-4 / 50000);
    EXPECT_TRUE(has_alert(sightx, "UNTESTED_FORMAT"));
}

/// Found by fuzzing: memory for a strip was allocated before its size was compared with the file.
TEST(TiffMicrograph, AllocatesNoMemoryForAnImpossibleStrip) {
    const TiffFile tiff{.big_tiff = true};
    expect_refusal(tiff.bytes({{TiffField{279, 16, 1, Bytes{}.whole(std::uint64_t{1} << 60, 8)}, tiff.shorts(259, 5)}}),
                   "truncated");
}

TEST(TiffMicrograph, RefusesTilesLargerThanAnyPicture) {
    const TiffFile tiff;
    expect_refusal(
        tiff.bytes({{tiff.longs(322, 1 << 14), tiff.longs(323, 1 << 14), tiff.longs(324, 8), tiff.longs(325, 12)}}),
        "tiles of 16384 × 16384");
}

TEST(TiffMicrograph, RefusesDirectoriesThatOverlapOrEnd) {
    const TiffFile tiff;
    auto ring = tiff.bytes();
    expect_refusal(ring.substr(0, 40), "truncated");
    expect_refusal(tiff.bytes({{TiffField{270, 2, 1000000000, std::string(8, '\x7F')}}}), "tag 270");
    expect_refusal(tiff.bytes({{tiff.longs(257, 1000)}}), "truncated");
    expect_refusal(tiff.bytes({{TiffField{279, 4, 2, Bytes{}.whole(100000, 4) + Bytes{}.whole(100000, 4)},
                                TiffField{273, 4, 2, Bytes{}.whole(8, 4)}}}),
                   "damaged");
}

}  // namespace
}  // namespace setae::imaging::tests::tiff_micrograph_test
