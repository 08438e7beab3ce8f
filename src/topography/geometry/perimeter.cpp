// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/geometry/perimeter.hpp"

#include <cmath>

#include <fmt/format.h>

#include "checks.hpp"
#include "setae/core/arrays.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::geometry {
namespace {

using topography::Mask;

/// Points that are `inside` and touch one that is not.
Mask rim(const Mask& mask, bool inside, Neighbours neighbours, bool periodic) {
    require_points(mask);
    const Index nx = mask.rows(), ny = mask.cols();
    const auto differs = [&](Index i, Index j) {
        if (!periodic && (i < 0 || i >= nx || j < 0 || j >= ny)) return false;
        return (mask((i + nx) % nx, (j + ny) % ny) != 0) != inside;
    };
    Mask result = Mask::Zero(nx, ny);
    for (Index i = 0; i < nx; ++i)
        for (Index j = 0; j < ny; ++j) {
            if ((mask(i, j) != 0) != inside) continue;
            bool touches = differs(i - 1, j) || differs(i + 1, j) || differs(i, j - 1) || differs(i, j + 1);
            if (!touches && neighbours == Neighbours::edges_and_corners)
                touches =
                    differs(i - 1, j - 1) || differs(i - 1, j + 1) || differs(i + 1, j - 1) || differs(i + 1, j + 1);
            result(i, j) = touches ? 1 : 0;
        }
    return result;
}

/// Pairs of neighbouring points of which one is chosen, in two lines of n points.
Index changes(const std::uint8_t* a, const std::uint8_t* b, Index n) {
    Index count = 0;
    for (Index j = 0; j < n; ++j) count += (a[j] != 0) != (b[j] != 0);
    return count;
}

}  // namespace

EdgeLength edge_length(const Mask& mask, const PointGrid& grid) {
    require_points(mask);
    require_pixels(grid);
    const Index nx = mask.rows(), ny = mask.cols();
    Index along_x = 0, along_y = 0;
    for (Index i = 0; i < nx; ++i) {
        const std::uint8_t* row = mask.row(i).data();
        along_x += changes(row, row + 1, ny - 1);
        if (grid.periodic) along_x += (row[ny - 1] != 0) != (row[0] != 0);
        if (i + 1 < nx || grid.periodic) along_y += changes(row, mask.row((i + 1) % nx).data(), ny);
    }
    return {static_cast<double>(along_x) * grid.pixel_size[0], static_cast<double>(along_y) * grid.pixel_size[1]};
}

double isotropic_perimeter(double edge_length) { return 0.25 * pi * edge_length; }

double corrected_contact_area(double counted_area, double edge_length, double pixel_size) {
    for (const double value : {counted_area, edge_length, pixel_size})
        if (!(value >= 0.0 && std::isfinite(value)))
            throw InvalidArgument(
                fmt::format("contact area of {} m2, edge of {} m, pixels of {} m; expected none negative", counted_area,
                            edge_length, pixel_size));
    static const double share = (pi - 1.0 + std::log(2.0)) / 24.0;
    return counted_area - share * edge_length * pixel_size;
}

Mask inner_perimeter(const Mask& mask, Neighbours neighbours, bool periodic) {
    return rim(mask, true, neighbours, periodic);
}

Mask outer_perimeter(const Mask& mask, Neighbours neighbours, bool periodic) {
    return rim(mask, false, neighbours, periodic);
}

}  // namespace setae::geometry
