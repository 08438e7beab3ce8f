// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "electron_files.hpp"
#include "emd_files.hpp"
#include "files/png_chunks.hpp"
#include "micrograph_files.hpp"
#include "picture_codecs.hpp"

namespace setae::imaging::tests {

/// A file's content; its name begins with the identifier of its format.
using Sample = std::pair<std::string, std::string>;

/// A smooth picture.
inline cv::Mat smooth_picture(int type = CV_8U) {
    cv::Mat image(16, 24, type == CV_8UC3 ? CV_8UC3 : CV_8U);
    for (int i = 0; i < image.rows; ++i)
        for (int j = 0; j < image.cols * image.channels(); ++j)
            image.ptr(i)[j] = static_cast<unsigned char>(40 + 5 * i + 3 * j);
    if (type == CV_16U) image.convertTo(image, type, 7.0);
    return image;
}

inline std::string encoded_picture(const std::string& ending, int type = CV_8U) {
    return picture_bytes(smooth_picture(type), ending);
}

inline std::string tiff_picture(int compression) {
    const auto path =
        (std::filesystem::temp_directory_path() / ("setae_tiff_picture_" + std::to_string(::getpid()))).string();
    write_tiff(path, {smooth_picture(CV_16U)}, compression);
    std::ifstream file(path, std::ios::binary);
    std::string bytes(std::istreambuf_iterator<char>(file), {});
    std::filesystem::remove(path);
    return bytes;
}

inline std::string png_picture() { return encoded_picture(".png"); }

/// A PNG with the chunk pHYs after its header.
inline std::string with_pixels_per_metre(std::string png, std::uint64_t x, std::uint64_t y) {
    const Bytes big{true};
    const auto chunk = "pHYs" + big.whole(x, 4) + big.whole(y, 4) + '\1';
    return png.insert(33, big.whole(9, 4) + chunk + big.whole(png_checksum(chunk), 4));
}

/// One small file of every format and variant.
inline std::vector<Sample> micrograph_samples() {
    const TiffFile tiff, big_endian{.big_endian = true}, big_tiff{.big_tiff = true};
    std::vector<Sample> samples{
        {"dm3", dm_file(3).bytes()},
        {"dm3 big endian", dm_file(3, true).bytes()},
        {"dm4", dm_file(4).bytes()},
        {"tiff", tiff.bytes()},
        {"tiff big endian",
         big_endian.bytes({{big_endian.text(34682, "[Scan]\nPixelWidth=1e-9\nPixelHeight=1e-9\n")}})},
        {"tiff BigTIFF", big_tiff.bytes({{big_tiff.text(65003, "nm"), big_tiff.text(65004, "nm"),
                                          big_tiff.real(65009, 0.5), big_tiff.real(65010, 0.5)}})},
        {"mrc", mrc_file().bytes()},
        {"mrc big endian", mrc_file(true).bytes()},
        {"ser", ser_file().bytes()},
        {"ser 64 bit", ser_file(0x0220).bytes()},
        {"emd", EmdFile{}.bytes()},
        {"emd packed", EmdFile{.packed = true}.bytes()},
        {"emd Velox", EmdFile{.velox = true, .unit_x = "m"}.bytes()},
        {"png", png_picture()},
        {"png colour 16 bit", encoded_picture(".png", CV_16U)},
        {"png of a known scale", with_pixels_per_metre(png_picture(), 2'000'000'000, 2'000'000'000)},
        {"jpeg", encoded_picture(".jpg")},
        {"jpeg colour", encoded_picture(".jpg", CV_8UC3)},
        {"bmp", encoded_picture(".bmp")}};
    // 1 none, 5 LZW, 8 deflate, 32773 PackBits
    for (const int compression : {5, 8, 32773})
        samples.emplace_back("tiff compression " + std::to_string(compression), tiff_picture(compression));
    return samples;
}

/// Headers of pictures so large that their pixels are missing.
inline std::vector<Sample> micrographs_of(std::uint64_t side) {
    const TiffFile tiff;
    const Bytes big{true}, little;
    auto dm = dm_file(4);
    auto cut = dm.bytes();
    const auto replace_all = [&](const std::string& from, const std::string& to) {
        for (auto at = cut.find(from); at != std::string::npos; at = cut.find(from, at + to.size()))
            cut.replace(at, from.size(), to);
    };
    const auto dimension = [&](std::uint64_t length) {
        return std::string("%%%%") + big.whole(1, 8) + big.whole(5, 8) + little.whole(length, 4);
    };
    replace_all(dimension(columns), dimension(side));
    replace_all(dimension(rows), dimension(side));
    auto png = png_picture();
    png.replace(16, 8, big.whole(side, 4) + big.whole(side, 4));
    auto jpeg = encoded_picture(".jpg");
    jpeg.replace(jpeg.find("\xFF\xC0") + 5, 4, big.whole(side, 2) + big.whole(side, 2));
    auto bmp = encoded_picture(".bmp");
    bmp.replace(18, 8, little.whole(side, 4) + little.whole(side, 4));
    auto mrc = mrc_file().bytes();
    mrc.replace(0, 8, little.whole(side, 4) + little.whole(side, 4));
    auto ser = ser_file().bytes();
    ser.replace(ser.size() - 24 - 8, 8, little.whole(side, 4) + little.whole(side, 4));
    return {{"dm4", cut},
            {"mrc", mrc},
            {"ser", ser},
            {"tiff", tiff.bytes({{tiff.longs(256, side), tiff.longs(257, side)}})},
            {"tiff LZW", tiff.bytes({{tiff.longs(256, side), tiff.longs(257, side), tiff.shorts(259, 5)}})},
            {"png", png},
            {"jpeg", jpeg},
            {"bmp", bmp}};
}

}  // namespace setae::imaging::tests
