// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "picture_codecs.hpp"
#include "setae/imaging/frames.hpp"

namespace setae::imaging::tests {

/// A folder of a test, removed with it.
class Folder {
public:
    Folder()
        : path_(std::filesystem::temp_directory_path() /
                ("setae_imaging_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()))) {
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    [[nodiscard]] std::string operator/(const std::string& name) const { return (path_ / name).string(); }
    [[nodiscard]] std::string path() const { return path_.string(); }

private:
    std::filesystem::path path_;
};

inline void write_bytes(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

inline std::string number_bytes(std::uint64_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += static_cast<char>((value >> (8 * i)) & 0xFF);
    return text;
}

inline cv::Mat as_bytes(const FramePixels& pixels) {
    cv::Mat image(static_cast<int>(pixels.rows()), static_cast<int>(pixels.cols()), CV_8U);
    for (int i = 0; i < image.rows; ++i)
        for (int j = 0; j < image.cols; ++j) image.at<std::uint8_t>(i, j) = static_cast<std::uint8_t>(pixels(i, j));
    return image;
}

/// An uncompressed stack of 8 bits, directories before pixels as ImageJ writes them.
struct PlainTiff {
    std::string description;                             ///< "ImageJ=1.53\nunit=micron\n"
    std::uint32_t resolution = 0, resolution_below = 1;  ///< pixels per unit; 0: no tags
    std::uint32_t resolution_unit = 1;
    bool first_directory_only = false;  ///< ImageJ beyond 4 GiB

    [[nodiscard]] std::string bytes(const std::vector<FramePixels>& frames) const {
        const std::size_t entries = 8 + (resolution ? 3 : 0) + (description.empty() ? 0 : 1);
        const std::size_t head = 2 + 12 * entries + 4, extra = 16 + description.size() + 1;
        const std::size_t directories = first_directory_only ? 1 : frames.size();
        std::size_t pixels_at = 8 + directories * (head + extra);
        std::string text = std::string("II*\0", 4) + number_bytes(8, 4), pixels;
        for (std::size_t k = 0; k < frames.size(); ++k) {
            const auto& frame = frames[k];
            if (k < directories) {
                const std::size_t extra_at = text.size() + head;
                text += number_bytes(entries, 2);
                const auto entry = [&](int tag, int type, std::uint64_t count, std::uint64_t value) {
                    text += number_bytes(static_cast<std::uint64_t>(tag), 2) +
                            number_bytes(static_cast<std::uint64_t>(type), 2) + number_bytes(count, 4) +
                            number_bytes(value, 4);
                };
                entry(256, 4, 1, static_cast<std::uint64_t>(frame.cols()));
                entry(257, 4, 1, static_cast<std::uint64_t>(frame.rows()));
                entry(258, 3, 1, 8);
                entry(259, 3, 1, 1);
                entry(262, 3, 1, 1);
                if (!description.empty()) entry(270, 2, description.size() + 1, extra_at + 16);
                entry(273, 4, 1, pixels_at + pixels.size());
                entry(278, 4, 1, static_cast<std::uint64_t>(frame.rows()));
                entry(279, 4, 1, static_cast<std::uint64_t>(frame.size()));
                if (resolution)
                    entry(282, 5, 1, extra_at), entry(283, 5, 1, extra_at + 8), entry(296, 3, 1, resolution_unit);
                text += number_bytes(k + 1 < directories ? text.size() + 4 + extra : 0, 4);
                for (int i = 0; i < 2; ++i) text += number_bytes(resolution, 4) + number_bytes(resolution_below, 4);
                text += description + '\0';
            }
            for (long i = 0; i < frame.size(); ++i)
                pixels += static_cast<char>(static_cast<std::uint8_t>(frame.data()[i]));
        }
        return text + pixels;
    }
};

/// An AVI of one video; frames are the bytes of their chunks.
inline std::string avi(const std::vector<std::string>& frames, long width, long height, int bits,
                       const std::string& codec, double rate, const std::string& palette = {}) {
    const auto chunk = [](const std::string& id, const std::string& body) {
        return id + number_bytes(body.size(), 4) + body + std::string(body.size() % 2, '\0');
    };
    const auto list = [&](const std::string& kind, const std::string& body) { return chunk("LIST", kind + body); };
    const std::string avih = number_bytes(static_cast<std::uint64_t>(1e6 / rate), 4) + std::string(52, '\0');
    const std::string strh = "vids" + codec + std::string(12, '\0') + number_bytes(1000, 4) +
                             number_bytes(static_cast<std::uint64_t>(1000 * rate), 4) + std::string(28, '\0');
    const std::string strf = number_bytes(40, 4) + number_bytes(static_cast<std::uint64_t>(width), 4) +
                             number_bytes(static_cast<std::uint64_t>(height), 4) + number_bytes(1, 2) +
                             number_bytes(static_cast<std::uint64_t>(bits), 2) + codec + std::string(20, '\0') +
                             palette;
    std::string movi;
    for (const auto& frame : frames) movi += chunk("00dc", frame);
    return chunk("RIFF",
                 "AVI " + list("hdrl", chunk("avih", avih) + list("strl", chunk("strh", strh) + chunk("strf", strf))) +
                     list("movi", movi));
}

/// Rows from the bottom up, padded to 4 bytes, each pixel as so many equal bytes.
inline std::string bitmap_rows(const FramePixels& pixels, int bytes_per_pixel) {
    std::string text;
    for (long row = pixels.rows() - 1; row >= 0; --row) {
        for (long column = 0; column < pixels.cols(); ++column)
            text += std::string(static_cast<std::size_t>(bytes_per_pixel),
                                static_cast<char>(static_cast<std::uint8_t>(pixels(row, column))));
        while (text.size() % 4 != 0) text += '\0';
    }
    return text;
}

inline std::string grey_palette() {
    std::string text;
    for (int i = 0; i < 256; ++i) text += std::string(3, static_cast<char>(i)) + '\0';
    return text;
}

inline std::string encoded(const FramePixels& pixels, const std::string& ending) {
    return picture_bytes(as_bytes(pixels), ending);
}

}  // namespace setae::imaging::tests
