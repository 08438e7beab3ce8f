// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "setae/core/arrays.hpp"

namespace setae::formats {

/// Any quantity on a grid: first index x, rows from the top, NaN if undefined.
struct QuantityMap {
    std::string name;
    std::string unit;  ///< SI, such as "Pa"
    Array2D values;
};

/// Writes maps on one grid as channels of a Gwyddion file, each with its unit; undefined points are marked as in
/// write_gwy().
/// size: extent along x and y [m], > 0.
/// @throws FileError; InvalidArgument for an empty list, maps of different shape or 4 GiB and more.
void write_quantity_maps(const std::string& path, const std::vector<QuantityMap>& maps,
                         const std::array<double, 2>& size);

}  // namespace setae::formats
