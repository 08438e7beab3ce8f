// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"
#include "setae/simulation/micrograph.hpp"

namespace setae::simulation {

/// Pixels of a picture and of its surroundings: columns left … left + width − 1, rows top … top + height − 1. Pixel
/// (row, column) is the square of side 1 about that place.
struct PixelWindow {
    long left = 0, top = 0, width = 0, height = 0;
};

/// Share of each pixel that lies below the curve (larger y), shape (height, width): exact for the polygon through its
/// points.
///
///   B(row, column) = Σ_segments ∫ clamp(row + ½ − y(x), 0, 1) dx,  over the column, dx < 0 where the curve turns back
///
/// Signed areas of segments within pixels, summed down the columns; the curve continues horizontally beyond its ends.
/// Values outside [0, 1] are those of a curve that crosses itself. O(pixels + length). Source: rasterisation of fonts,
/// Levien, font-rs (2016).
[[nodiscard]] Array2D coverage_below(const PixelCurve& curve, const PixelWindow& window);

/// Distance of each pixel's centre to the curve [px], shape (height, width): positive above, negative below, ±reach
/// beyond reach.
///
/// O(pixels + length reach²).
[[nodiscard]] Array2D signed_distance(const PixelCurve& curve, const PixelWindow& window, double reach);

}  // namespace setae::simulation
