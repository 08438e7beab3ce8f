// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/imaging/frames.hpp"

#include <random>

#include "recordings.hpp"
#include "setae/core/errors.hpp"

namespace setae::imaging::tests::frames_test {
namespace {

/// Frames without two pixels equal in any simple order.
FramePixels pattern(int seed, long width = 37, long height = 23) {
    FramePixels pixels(height, width);
    for (long i = 0; i < height; ++i)
        for (long j = 0; j < width; ++j) pixels(i, j) = static_cast<float>((i * 31 + j * 7 + seed * 53 + i * j) % 251);
    return pixels;
}

std::vector<FramePixels> patterns(int n) {
    std::vector<FramePixels> frames;
    for (int k = 0; k < n; ++k) frames.push_back(pattern(k));
    return frames;
}

FrameOptions at_20_per_second() { return {.pixel_size = 1e-6, .frame_rate = 20}; }

void expect_frames(const FrameSource& source, const std::vector<FramePixels>& frames, float tolerance = 0) {
    ASSERT_EQ(source.size(), frames.size());
    for (std::size_t k = 0; k < frames.size(); ++k) {
        const auto read = source.read(k);
        ASSERT_EQ(read.fault, "") << k;
        EXPECT_LE((read.pixels - frames[k]).abs().maxCoeff(), tolerance) << k;
        EXPECT_DOUBLE_EQ(source.time(k), static_cast<double>(k) / 20) << k;
    }
}

template <class Call>
std::string message_of(Call call) {
    try {
        call();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

void expect_holds(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(FrameSource, ReadsAnUncompressedTiffStack) {
    const Folder folder;
    write_bytes(folder / "stack.tif", PlainTiff{}.bytes(patterns(4)));
    expect_frames(FrameSource(folder / "stack.tif", at_20_per_second()), patterns(4));
}

TEST(FrameSource, ReadsCompressedSixteenBitAndFloatPages) {
    const Folder folder;
    for (const int type : {CV_8U, CV_16U, CV_32F}) {
        std::vector<cv::Mat> pages;
        auto frames = patterns(3);
        for (auto& frame : frames) {
            if (type != CV_8U) frame *= 3.0f;
            cv::Mat(static_cast<int>(frame.rows()), static_cast<int>(frame.cols()), CV_32F, frame.data())
                .convertTo(pages.emplace_back(), type);
        }
        write_tiff(folder / "stack.tif", pages);  // LZW
        expect_frames(FrameSource(folder / "stack.tif", at_20_per_second()), frames);
    }
}

TEST(FrameSource, ReadsPixelSizeAndFrameRateOfImageJ) {
    const Folder folder;
    const PlainTiff tiff{.description = "ImageJ=1.53\nimages=3\nunit=micron\nfinterval=0.05\n",
                         .resolution = 1000000,
                         .resolution_below = 1820000};
    write_bytes(folder / "stack.tif", tiff.bytes(patterns(3)));
    const FrameSource source(folder / "stack.tif");
    EXPECT_NEAR(*source.pixel_size(), 1.82e-6, 1e-15);
    expect_frames(source, patterns(3));
    expect_holds(message_of([&] { FrameSource(folder / "stack.tif", {.pixel_size = 2e-6}); }),
                 "the file states 1.820 µm per pixel, but 2.000 µm was given");
    EXPECT_DOUBLE_EQ(
        *FrameSource(folder / "stack.tif", {.pixel_size = 2e-6, .ignore_stated_pixel_size = true}).pixel_size(), 2e-6);
}

TEST(FrameSource, FindsPagesOfImageJAfterItsSingleDirectory) {
    const Folder folder;
    write_bytes(folder / "large.tif",
                PlainTiff{.description = "ImageJ=1.53\nimages=5\n", .first_directory_only = true}.bytes(patterns(5)));
    expect_frames(FrameSource(folder / "large.tif", at_20_per_second()), patterns(5));
}

TEST(FrameSource, IgnoresPrintResolutions) {
    const Folder folder;
    write_bytes(folder / "print.tif", PlainTiff{.resolution = 300, .resolution_unit = 2}.bytes(patterns(1)));
    EXPECT_FALSE(FrameSource(folder / "print.tif", {.frame_rate = 20}).pixel_size());
    write_bytes(folder / "fine.tif", PlainTiff{.resolution = 5000, .resolution_unit = 3}.bytes(patterns(1)));
    EXPECT_NEAR(*FrameSource(folder / "fine.tif", {.frame_rate = 20}).pixel_size(), 2e-6, 1e-15);
}

TEST(FrameSource, ReadsUncompressedAvi) {
    const Folder folder;
    const auto frames = patterns(3);
    for (const int bytes : {1, 3, 4}) {
        std::vector<std::string> chunks;
        for (const auto& frame : frames) chunks.push_back(bitmap_rows(frame, bytes));
        write_bytes(folder / "film.avi",
                    avi(chunks, 37, 23, 8 * bytes, std::string(4, '\0'), 20, bytes == 1 ? grey_palette() : ""));
        expect_frames(FrameSource(folder / "film.avi"), frames, 1e-3f);  // luminance of equal parts, in float
    }
}

TEST(FrameSource, ReadsMotionJpeg) {
    const Folder folder;
    FramePixels smooth(48, 64);
    for (long i = 0; i < 48; ++i)
        for (long j = 0; j < 64; ++j) smooth(i, j) = static_cast<float>(60 + i + j);
    write_bytes(folder / "film.avi", avi({encoded(smooth, ".jpg"), encoded(smooth, ".jpg")}, 64, 48, 24, "MJPG", 20));
    expect_frames(FrameSource(folder / "film.avi"), {smooth, smooth}, 3.0f);  // JPEG at quality 95
}

TEST(FrameSource, ExplainsHowToConvertOtherCodecs) {
    const Folder folder;
    write_bytes(folder / "film.avi", avi({"xxxx"}, 64, 48, 24, "H264", 20));
    const auto message = message_of([&] { FrameSource(folder / "film.avi"); });
    expect_holds(message, "'H264'");
    expect_holds(message, "ffmpeg");
}

TEST(FrameSource, TakesPicturesInNaturalOrderAndReportsMissingNumbers) {
    const Folder folder;
    for (const int number : {2, 10, 1, 4})
        write_bytes(folder / ("frame_" + std::to_string(number) + ".png"), encoded(pattern(number), ".png"));
    write_bytes(folder / "notes.txt", "not a picture");
    const FrameSource source(folder.path(), at_20_per_second());
    ASSERT_EQ(source.size(), 4U);
    EXPECT_EQ(source.number(3), 10);
    EXPECT_DOUBLE_EQ(source.time(3), 9.0 / 20);
    EXPECT_EQ(source.missing(), (std::vector<long>{3, 5, 6, 7, 8, 9}));
    EXPECT_LE((source.read(1).pixels - pattern(2)).abs().maxCoeff(), 0.0f);
}

TEST(FrameSource, NumbersPicturesWithUnrelatedNames) {
    const Folder folder;
    write_bytes(folder / "a1.bmp", encoded(pattern(1), ".bmp"));
    write_bytes(folder / "b7.bmp", encoded(pattern(2), ".bmp"));
    const FrameSource source(folder.path(), at_20_per_second());
    EXPECT_EQ(source.number(1), 2);
    EXPECT_TRUE(source.missing().empty());
}

TEST(FrameSource, GivesOnlyTheRequestedRegionAndFrames) {
    const Folder folder;
    write_bytes(folder / "stack.tif", PlainTiff{}.bytes(patterns(6)));
    auto options = at_20_per_second();
    options.region = PictureRegion{5, 3, 20, 17};
    options.first = 3;
    options.last = 5;
    const FrameSource source(folder / "stack.tif", options);
    ASSERT_EQ(source.size(), 3U);
    EXPECT_EQ(source.number(0), 3);
    EXPECT_DOUBLE_EQ(source.time(0), 2.0 / 20);  // since the first frame of the recording
    const FramePixels expected = patterns(6)[2].block(3, 5, 17, 20);
    EXPECT_LE((source.read(0).pixels - expected).abs().maxCoeff(), 0.0f);
    options.region = PictureRegion{30, 0, 20, 10};
    expect_holds(message_of([&] { FrameSource(folder / "stack.tif", options); }), "outside the frames of 37 × 23");
}

TEST(FrameSource, FlagsBadFramesAndReadsTheRest) {
    const Folder folder;
    auto frames = patterns(5);
    frames[1].setConstant(77);
    frames[3] = pattern(3, 40, 23);
    const auto bytes = PlainTiff{}.bytes(frames);
    write_bytes(folder / "stack.tif", bytes.substr(0, bytes.size() - 300));
    const FrameSource source(folder / "stack.tif", at_20_per_second());
    ASSERT_EQ(source.size(), 5U);
    EXPECT_EQ(source.read(0).fault, "");
    EXPECT_EQ(source.read(1).fault, "all pixels have the grey level 77");
    EXPECT_EQ(source.read(2).fault, "");
    EXPECT_EQ(source.read(3).fault, "40 × 23 pixels, but the first frame has 37 × 23");
    expect_holds(source.read(4).fault, "truncated: 551 of 851 bytes");
}

TEST(FrameSource, FlagsTruncatedDirectoriesAndPictures) {
    const Folder folder;
    std::vector<cv::Mat> pages;
    for (const auto& frame : patterns(3)) pages.push_back(as_bytes(frame));
    write_tiff(folder / "lzw.tif", pages);  // directories after pixels
    std::filesystem::resize_file(folder / "lzw.tif", std::filesystem::file_size(folder / "lzw.tif") - 40);
    const FrameSource stack(folder / "lzw.tif", at_20_per_second());
    EXPECT_EQ(stack.read(0).fault, "");
    expect_holds(stack.read(stack.size() - 1).fault, "truncated");
    for (const std::string ending : {".png", ".jpg", ".bmp"}) {
        const auto whole = encoded(pattern(1), ending);
        write_bytes(folder / ("cut_1" + ending), whole);
        write_bytes(folder / ("cut_2" + ending), whole.substr(0, whole.size() / 2));
        const FrameSource pictures({folder / ("cut_1" + ending), folder / ("cut_2" + ending)}, at_20_per_second());
        EXPECT_EQ(pictures.read(0).fault, "") << ending;
        expect_holds(pictures.read(1).fault, "truncated");
    }
    const auto film =
        avi({bitmap_rows(pattern(1), 3), bitmap_rows(pattern(2), 3)}, 37, 23, 24, std::string(4, '\0'), 20);
    write_bytes(folder / "film.avi", film.substr(0, film.size() - 500));
    const FrameSource cut(folder / "film.avi");
    EXPECT_EQ(cut.read(0).fault, "");
    expect_holds(cut.read(1).fault, "truncated");
}

TEST(FrameSource, RefusesFramesTooLargeBeforeReadingThem) {
    const Folder folder;
    auto bytes = PlainTiff{}.bytes(patterns(1));
    bytes.replace(8 + 2 + 8, 4, number_bytes(30000, 4)).replace(8 + 2 + 12 + 8, 4, number_bytes(30000, 4));
    write_bytes(folder / "huge.tif", bytes);
    expect_holds(message_of([&] { FrameSource(folder / "huge.tif", at_20_per_second()); }),
                 "30000 × 30000 pixels, more than the 100000000 a frame may have");
    auto png = encoded(pattern(1), ".png");
    png.replace(16, 8, std::string("\0\0\x75\x30\0\0\x75\x30", 8));
    write_bytes(folder / "huge.png", png);
    expect_holds(message_of([&] { FrameSource(folder / "huge.png", at_20_per_second()); }), "30000 × 30000");
}

/// Opens and reads all; errors of setae are valid results.
void read_all(const std::string& path) {
    try {
        const FrameSource source(path, {.pixel_size = 1e-6, .frame_rate = 20, .max_pixels = 20000});
        for (std::size_t k = 0; k < source.size() && k < 20; ++k) (void)source.read(k);
    } catch (const Error&) {
    }
}

TEST(FrameSource, HandlesDamagedFiles) {
    const Folder folder;
    std::vector<cv::Mat> pages;
    for (const auto& frame : patterns(2)) pages.push_back(as_bytes(frame));
    write_tiff(folder / "lzw.tif", pages);
    std::ifstream lzw(folder / "lzw.tif", std::ios::binary);
    const std::vector<std::string> files{
        PlainTiff{.description = "ImageJ=1.53\nimages=2\n", .resolution = 3}.bytes(patterns(2)),
        std::string(std::istreambuf_iterator<char>(lzw), {}),
        avi({bitmap_rows(pattern(1), 3), bitmap_rows(pattern(2), 3)}, 37, 23, 24, std::string(4, '\0'), 20),
        encoded(pattern(1), ".png")};
    std::mt19937_64 generator(7);
    for (const auto& file : files)
        for (int round = 0; round < 40; ++round) {
            auto bytes = file;
            if (round % 3 == 0) bytes.resize(generator() % bytes.size());
            else
                for (int k = 0; k < 4; ++k)
                    bytes[generator() % std::min<std::size_t>(bytes.size(), 400)] = static_cast<char>(generator());
            write_bytes(folder / "damaged", bytes);
            read_all(folder / "damaged");
        }
}

TEST(FrameSource, NamesTheProblemOfItsFiles) {
    const Folder folder;
    write_bytes(folder / "text.tif", "no picture at all");
    expect_holds(message_of([&] { FrameSource(folder / "text.tif", at_20_per_second()); }),
                 "expected a TIFF, an AVI, or pictures");
    expect_holds(message_of([&] { FrameSource(folder / "missing.tif", at_20_per_second()); }), "no such file");
    expect_holds(message_of([&] { FrameSource(folder.path(), at_20_per_second()); }), "no pictures");
    expect_holds(message_of([&] { FrameSource(std::vector<std::string>{}, at_20_per_second()); }), "no frames");
    write_bytes(folder / "one.png", encoded(pattern(1), ".png"));
    expect_holds(message_of([&] { FrameSource(folder / "one.png"); }), "no frame rate");
    write_bytes(folder / "broken.tif", std::string("II*\0\x08\0\0\0", 8));
    expect_holds(message_of([&] { FrameSource(folder / "broken.tif", at_20_per_second()); }), "truncated");
}

}  // namespace
}  // namespace setae::imaging::tests::frames_test
