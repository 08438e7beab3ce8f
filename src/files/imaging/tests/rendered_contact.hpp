// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>

#include "setae/imaging/frames.hpp"

namespace setae::imaging::tests {

/// A contact as recorded by a camera: area sampled on a grid finer than pixels, blurred, noisy, in 256 levels.
struct RenderedContact {
    long width = 160, height = 120;
    double centre_x = 80.3, centre_y = 59.6;
    double semi_major = 30, semi_minor = 0;  ///< 0: a circle
    double angle = 0;
    double inside = 80, contrast = 60;  ///< grey level; outside minus inside
    double blur = 0.8;                  ///< standard deviation [px]
    double slope_x = 0, slope_y = 0;    ///< of illumination [levels/px]
    double noise = 0;
    double noise_blur = 0;  ///< of the noise, whose deviation is kept
    bool quantised = true;
    unsigned seed = 1;
    std::function<double(double)> outside;  ///< brightness in [0, 1] by the distance from the edge [px]; none: 1
    std::function<double(double)> ripple;   ///< for a circle by the angle: outward displacement of the edge [px]; none:
                                            ///< 0
    double largest_ripple = 0;              ///< [px]
    double void_x = 0, void_y = 0, void_radius = 0;  ///< a hole in the contact
    static constexpr int finer = 6;

    [[nodiscard]] FramePixels make() const {
        const double b = semi_minor > 0 ? semi_minor : semi_major;
        const long margin = 8;
        FramePixels fine = FramePixels::Zero(height + 2 * margin, width + 2 * margin);
        for (long row = 0; row < fine.rows(); ++row)
            for (long column = 0; column < fine.cols(); ++column)
                fine(row, column) = static_cast<float>(
                    pixel(static_cast<double>(column - margin), static_cast<double>(row - margin), b));
        fine = blurred(fine, blur);
        FramePixels pixels = fine.block(margin, margin, height, width);
        FramePixels added = FramePixels::Zero(height + 2 * margin, width + 2 * margin);
        std::mt19937_64 generator(seed);
        std::normal_distribution<double> normal(0.0, 1.0);
        if (noise > 0) {
            for (long i = 0; i < added.size(); ++i) added.data()[i] = static_cast<float>(normal(generator));
            added = blurred(added, noise_blur);
            added *= static_cast<float>(noise / std::sqrt(static_cast<double>(added.square().mean())));
        }
        for (long row = 0; row < height; ++row)
            for (long column = 0; column < width; ++column) {
                float& grey = pixels(row, column);
                grey += static_cast<float>(slope_x * static_cast<double>(column - width / 2) +
                                           slope_y * static_cast<double>(row - height / 2)) +
                        added(row + margin, column + margin);
                if (quantised) grey = std::clamp(std::round(grey), 0.0f, 255.0f);
            }
        return pixels;
    }

private:
    [[nodiscard]] double level(double x, double y, double b) const {
        const double dx = x - centre_x, dy = y - centre_y;
        const double u = (std::cos(angle) * dx + std::sin(angle) * dy) / semi_major,
                     v = (std::cos(angle) * dy - std::sin(angle) * dx) / b;
        if (void_radius > 0 && std::hypot(x - void_x, y - void_y) < void_radius) return inside + contrast;
        const double level = std::hypot(u, v) / (ripple ? 1 + ripple(std::atan2(dy, dx)) / semi_major : 1.0);
        if (level <= 1) return inside;
        return inside + contrast * (outside ? outside((level - 1) * semi_major) : 1.0);
    }
    [[nodiscard]] double pixel(double x, double y, double b) const {
        const double far = std::abs(std::hypot(x - centre_x, y - centre_y) - 0.5 * (semi_major + b)) -
                           std::abs(semi_major - b) - largest_ripple;
        if (far > 2 && std::abs(std::hypot(x - void_x, y - void_y) - void_radius) > 2 &&
            (!outside || std::hypot(x - centre_x, y - centre_y) < std::min(semi_major, b)))
            return level(x, y, b);
        double sum = 0;
        for (int i = 0; i < finer; ++i)
            for (int j = 0; j < finer; ++j) sum += level(x + (j + 0.5) / finer - 0.5, y + (i + 0.5) / finer - 0.5, b);
        return sum / (finer * finer);
    }
    static FramePixels blurred(const FramePixels& image, double deviation) {
        if (deviation <= 0) return image;
        const int half = static_cast<int>(std::ceil(4 * deviation));
        Eigen::ArrayXf kernel(2 * half + 1);
        for (int k = -half; k <= half; ++k)
            kernel[k + half] = static_cast<float>(std::exp(-0.5 * k * k / (deviation * deviation)));
        kernel /= kernel.sum();
        FramePixels rows = FramePixels::Zero(image.rows(), image.cols()), result = rows;
        for (long i = 0; i < image.rows(); ++i)
            for (long j = 0; j < image.cols(); ++j)
                for (int k = -half; k <= half; ++k)
                    rows(i, j) += kernel[k + half] * image(i, std::clamp(j + k, 0L, image.cols() - 1));
        for (long i = 0; i < image.rows(); ++i)
            for (long j = 0; j < image.cols(); ++j)
                for (int k = -half; k <= half; ++k)
                    result(i, j) += kernel[k + half] * rows(std::clamp(i + k, 0L, image.rows() - 1), j);
        return result;
    }
};

}  // namespace setae::imaging::tests
