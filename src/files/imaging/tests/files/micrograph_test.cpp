// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/imaging/micrograph.hpp"

#include "micrograph_checks.hpp"
#include "micrograph_samples.hpp"
#include "recordings.hpp"

namespace setae::imaging::tests::micrograph_test {
namespace {

TEST(Micrograph, DetectsFormatsByContent) {
    const Folder folder;
    for (const auto& [format, bytes] : micrograph_samples()) {
        SCOPED_TRACE(format);
        write_bytes(folder / "picture.dat", bytes);
        const auto micrograph = read_micrograph(folder / "picture.dat");
        EXPECT_EQ(micrograph.format, format.substr(0, format.find(' ')));
        EXPECT_EQ(micrograph.name, "picture.dat");
        EXPECT_TRUE((micrograph.pixels == read_bytes(bytes).pixels).all());
    }
}

TEST(Micrograph, ListsEveryFormatItReads) {
    std::vector<std::string> listed;
    for (const auto& format : micrograph_formats()) listed.push_back(format.identifier);
    for (const auto& [format, bytes] : micrograph_samples())
        EXPECT_TRUE(std::find(listed.begin(), listed.end(), read_bytes(bytes).format) != listed.end()) << format;
}

TEST(Micrograph, RefusesEveryTruncation) {
    for (const auto& [format, bytes] : micrograph_samples())
        for (std::size_t cut = 0; cut < 64; ++cut) {
            const auto length = bytes.size() * cut / 64;
            expect_refusal(bytes.substr(0, length), "sample");
            if (HasFailure()) FAIL() << format << " cut at byte " << length << " of " << bytes.size();
        }
}

TEST(Micrograph, RefusesPicturesTooLargeBeforeTheirPixelsAreRead) {
    for (const auto& [format, bytes] : micrographs_of(30000)) {
        SCOPED_TRACE(format);
        expect_refusal(bytes, "30000 × 30000 pixels");
        expect_refusal(bytes, "crop");
    }
}

TEST(Micrograph, NamesFilesThatAreMissingOrNotPictures) {
    const Folder folder;
    EXPECT_THROW((void)read_micrograph(folder / "missing.tif"), FileError);
    EXPECT_THROW((void)read_micrograph(folder.path()), FileError);
    expect_refusal("x [nm]\th [nm]\n", "expected DM3");
    expect_refusal("", "expected DM3");
}

TEST(Micrograph, RefusesPixelsThatAreNotFinite) {
    DmFile file;
    for (int i = 0; i < columns * rows; ++i) file.pixels += file.order().real32(i == 4 ? NAN : 1.0f);
    EXPECT_NE(refusal(file.bytes()).find("pixels that are not numbers: 1"), std::string::npos);
}

TEST(MicrographsIn, ListsPicturesOfAFolderInNaturalOrder) {
    const Folder folder;
    EXPECT_THROW((void)micrographs_in(folder.path()), FormatError);
    write_bytes(folder / "a10.dm3", dm_file().bytes());
    write_bytes(folder / "a2.tif", TiffFile{}.bytes());
    write_bytes(folder / "notes.txt", "no picture");
    EXPECT_EQ(micrographs_in(folder.path()), (std::vector<std::string>{folder / "a2.tif", folder / "a10.dm3"}));
    EXPECT_THROW((void)micrographs_in(folder / "missing"), FileError);
}

TEST(PlainPicture, UsesPngResolutionsFinerThanPrint) {
    expect_pixel_size(read_bytes(with_pixels_per_metre(png_picture(), 2'000'000'000, 4'000'000'000)), 0.5e-9, 0.25e-9);
    EXPECT_FALSE(read_bytes(with_pixels_per_metre(png_picture(), 11811, 11811)).pixel_size);  // 300 dpi
    EXPECT_FALSE(read_bytes(png_picture()).pixel_size);
}

TEST(PlainPicture, RefusesPngWithAWrongChecksum) {
    EXPECT_EQ(png_checksum("IEND"), 0xAE426082U);  // as every PNG ends
    auto png = png_picture();
    png[png.find("IDAT") + 6] ^= 1;
    expect_refusal(png, "damaged");
}

TEST(PlainPicture, ReadsLuminanceOfColours) {
    cv::Mat colours(2, 3, CV_8UC3, cv::Scalar(10, 100, 200));  // blue, green, red
    EXPECT_NEAR(read_bytes(png_bytes(colours)).pixels(1, 2), 0.299 * 200 + 0.587 * 100 + 0.114 * 10, 1e-4);
}

}  // namespace
}  // namespace setae::imaging::tests::micrograph_test
