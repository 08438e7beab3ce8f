// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <functional>
#include <random>

#include "setae/imaging/frames.hpp"

namespace setae::imaging::tests {

/// A picture with an edge given by its signed distance [px], positive in vacuum.
struct EdgePicture {
    long width = 256, height = 200;
    double vacuum = 1100, sample = 1000, blur = 0.9, noise = 0;
    double fringe = 0, fringe_width = 3;  ///< odd, in units of the step
    unsigned seed = 1;
};

inline FramePixels rendered(const EdgePicture& p, const std::function<double(double, double)>& distance) {
    std::mt19937 engine(p.seed);
    std::normal_distribution<double> normal;
    FramePixels pixels(p.height, p.width);
    for (long row = 0; row < p.height; ++row)
        for (long column = 0; column < p.width; ++column) {
            const double d = distance(static_cast<double>(column), static_cast<double>(row)), v = d / p.fringe_width;
            const double share =
                0.5 * (1 + std::erf(d / (p.blur * std::sqrt(2.0)))) + p.fringe * v * std::exp(0.5 - 0.5 * v * v);
            pixels(row, column) =
                static_cast<float>(p.sample + (p.vacuum - p.sample) * share + p.noise * normal(engine));
        }
    return pixels;
}

/// Vacuum above the wave y = level + amplitude sin(2πx/length); the distance is correct to second order in its slope.
struct Wave {
    double level = 100, amplitude = 6, length = 60;
    [[nodiscard]] double height(double x) const {
        return level + amplitude * std::sin(2 * 3.14159265358979 * x / length);
    }
    [[nodiscard]] double operator()(double x, double y) const {
        const double slope = amplitude * 2 * 3.14159265358979 / length * std::cos(2 * 3.14159265358979 * x / length);
        return (height(x) - y) / std::sqrt(1 + slope * slope);
    }
};

}  // namespace setae::imaging::tests
