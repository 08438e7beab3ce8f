// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "setae/core/arrays.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::study {

/// Heights of a measurement for a picture, as analysed: trend removed, thinned.
struct HeightPreview {
    Array1D positions;             ///< x of scans and contours [m]; empty for maps
    Array1D heights;               ///< h(x) [m]; NaN where undefined
    Array2D map;                   ///< (nx, ny) heights of maps [m], each the mean of the defined pixels of its cell
    std::array<double, 2> size{};  ///< extent along x and y [m]; for lines the second is 0
};

/// The preview of a map that is read by bands of scan lines.
class MapPreview {
public:
    MapPreview(Index nx, Index ny, std::array<double, 2> size, Index max_pixels = 128);
    /// Scan lines first, first + 1, …; `band` has shape (nx, count).
    void add(const ArrayView2D& band, Index first);
    [[nodiscard]] HeightPreview result() const;

private:
    Index nx_, ny_;
    std::array<double, 2> size_;
    Array2D sum_, count_;
};

/// Lines of more than 2 · `max_points` points are reduced to the lowest and the highest point of each of `max_points`
/// sections, in order of x, so that all peaks are kept; maps have at most `max_pixels` per side.
[[nodiscard]] HeightPreview height_preview(const topography::Measurement& measurement, Index max_points = 1000,
                                           Index max_pixels = 128);

}  // namespace setae::study
