// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/imaging/picture_content.hpp"

#include <gtest/gtest.h>

#include "recordings.hpp"
#include "setae/core/errors.hpp"

namespace setae::imaging::tests::picture_content_test {
namespace {

std::vector<FramePixels> frames_of(std::size_t n) {
    FramePixels ramp(23, 37);
    for (long i = 0; i < ramp.size(); ++i) ramp.data()[i] = static_cast<float>(i % 200);
    return std::vector<FramePixels>(n, ramp);
}

TEST(PictureContent, ReportsSizeScaleAndFrames) {
    const Folder folder;
    write_bytes(folder / "fine.tif", PlainTiff{.resolution = 5000, .resolution_unit = 3}.bytes(frames_of(1)));
    const auto picture = picture_content(folder / "fine.tif").value();
    EXPECT_EQ(picture.format, "tiff");
    EXPECT_EQ(picture.width, 37);
    EXPECT_EQ(picture.height, 23);
    EXPECT_EQ(picture.frames, 1u);
    EXPECT_NEAR(picture.pixel_size.value().x, 2e-6, 1e-15);
    write_bytes(folder / "stack.tif", PlainTiff{}.bytes(frames_of(4)));
    const auto stack = picture_content(folder / "stack.tif").value();
    EXPECT_EQ(stack.frames, 4u);
    EXPECT_FALSE(stack.pixel_size.has_value());
}

TEST(PictureContent, ReportsAVideo) {
    const Folder folder;
    std::vector<std::string> chunks;
    for (const auto& frame : frames_of(3)) chunks.push_back(bitmap_rows(frame, 3));
    write_bytes(folder / "film.avi", avi(chunks, 37, 23, 24, std::string(4, '\0'), 20));
    const auto video = picture_content(folder / "film.avi").value();
    EXPECT_EQ(video.format, "avi");
    EXPECT_EQ(video.frames, 3u);
    EXPECT_DOUBLE_EQ(video.frame_rate.value(), 20.0);
}

TEST(PictureContent, IsEmptyForOtherFilesAndRefusesDamagedPictures) {
    const Folder folder;
    write_bytes(folder / "text.txt", "x [um],h [nm]\n0,1\n");
    EXPECT_FALSE(picture_content(folder / "text.txt").has_value());
    write_bytes(folder / "cut.png", std::string("\x89PNG\r\n\x1a\n\0\0", 10));
    EXPECT_THROW((void)picture_content(folder / "cut.png"), FormatError);
}

}  // namespace
}  // namespace setae::imaging::tests::picture_content_test
