// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "drawn_letters.hpp"
#include "files/picture.hpp"
#include "picture_codecs.hpp"
#include "setae/imaging/frames.hpp"

namespace setae::imaging::tests {

/// Background of a bar: sample of graphitic layers below, vacuum above, noise on both.
struct RenderedGround {
    int width = 512, height = 512;
    double vacuum = 150, sample = 115;  ///< grey levels
    double layers = 30;                 ///< amplitude of the layers
    double noise = 10;
    unsigned seed = 1;

    [[nodiscard]] cv::Mat1f make() const {
        cv::Mat1f picture(height, width);
        std::mt19937_64 generator(seed);
        std::normal_distribution<float> normal(0.0f, 1.0f);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const double edge = 0.4 * height + 25 * std::sin(x / 37.0) + 12 * std::sin(x / 11.0 + 1);
                const double phase =
                    2 * CV_PI * (0.16 * y + 0.03 * x + 0.9 * std::sin(x / 53.0) + 0.7 * std::sin(y / 41.0));
                const double level =
                    y < edge ? vacuum
                             : sample + layers * std::sin(phase) + 0.5 * layers * std::sin(1.7 * phase + x / 19.0);
                picture(y, x) = static_cast<float>(level + noise * static_cast<double>(normal(generator)));
            }
        return picture;
    }
};

/// A bar as drawn by programs. Coordinates as FramePixels.
struct RenderedBar {
    double begin_x = 60.5, length = 120;  ///< begin between two pixels: whole pixels if length is an integer
    int top = 440, thickness = 6;
    double level = 0;
    int outline = 0;  ///< px around it
    double outline_level = 255;
    int tick_width = 0, tick_reach = 0;  ///< at the ends, the length of the bar between their middles
    std::u32string label = U"20 nm";
    double letters = 1.0;  ///< magnification of 22 px
    int label_x = 70, label_y = 408;
    int data_bar = 0;  ///< rows at the bottom of one level
    double data_bar_level = 255;

    static void blend(cv::Mat1f& picture, int y, int x, double share, double level) {
        if (y < 0 || x < 0 || y >= picture.rows || x >= picture.cols) return;
        picture(y, x) = static_cast<float>((1 - share) * static_cast<double>(picture(y, x)) + share * level);
    }
    /// Pixels are covered by their share.
    static void rectangle(cv::Mat1f& picture, double begin, double end, int top, int rows, double level) {
        for (int y = top; y < top + rows; ++y)
            for (int x = static_cast<int>(std::floor(begin)); x <= static_cast<int>(std::ceil(end)); ++x)
                blend(picture, y, x, std::clamp(std::min(x + 0.5, end) - std::max(x - 0.5, begin), 0.0, 1.0), level);
    }
    static void write(cv::Mat1f& picture, const std::u32string& text, int left, int top, double factor, double level) {
        double x = left;
        for (const char32_t letter : text) {
            const auto& rows = drawn_letters().at(letter);
            cv::Mat1f mask(static_cast<int>(rows.size()), static_cast<int>(rows.front().size()));
            for (int r = 0; r < mask.rows; ++r)
                for (int c = 0; c < mask.cols; ++c)
                    mask(r, c) = rows[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] == '#' ? 1.0f : 0.0f;
            const double advance = factor * mask.cols;
            if (factor != 1.0)
                cv::resize(mask, mask, {}, factor, factor, factor > 1 ? cv::INTER_LINEAR : cv::INTER_AREA);
            for (int r = 0; r < mask.rows; ++r)
                for (int c = 0; c < mask.cols; ++c)
                    blend(picture, top + r, static_cast<int>(x) + c,
                          std::clamp(static_cast<double>(mask(r, c)), 0.0, 1.0), level);
            x += std::ceil(advance);
        }
    }
    void draw(cv::Mat1f& picture) const {
        if (data_bar > 0)
            picture.rowRange(picture.rows - data_bar, picture.rows).setTo(static_cast<float>(data_bar_level));
        const double half = 0.5 * outline, tick = 0.5 * tick_width, end = begin_x + length;
        if (outline > 0)
            rectangle(picture, begin_x - half, end + half, top - outline, thickness + 2 * outline, outline_level);
        rectangle(picture, begin_x + half - tick, end - half + tick, top, thickness, level);
        if (tick_width > 0)
            for (const double middle : {begin_x, end})
                rectangle(picture, middle - tick, middle + tick, top - tick_reach, thickness + 2 * tick_reach, level);
        write(picture, label, label_x, label_y, letters, level);
    }
};

/// Grey levels 0 to 255, rounded as in a file of 8 bits.
inline FramePixels eight_bits(const cv::Mat1f& picture) {
    FramePixels pixels(picture.rows, picture.cols);
    for (int y = 0; y < picture.rows; ++y)
        for (int x = 0; x < picture.cols; ++x) pixels(y, x) = std::clamp(std::round(picture(y, x)), 0.0f, 255.0f);
    return pixels;
}

/// Through a JPEG file of that quality.
inline FramePixels through_jpeg(const cv::Mat1f& picture, int quality) {
    cv::Mat bytes;
    picture.convertTo(bytes, CV_8U);
    return decoded_picture(jpeg_bytes(bytes, quality)).pixels;
}

/// A background with a bar on it.
inline FramePixels picture_with_bar(const RenderedGround& ground, const RenderedBar& bar) {
    auto picture = ground.make();
    bar.draw(picture);
    return eight_bits(picture);
}

}  // namespace setae::imaging::tests
