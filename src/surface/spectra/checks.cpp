// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::spectra {
namespace {

void require_extent(Index points, double size, const char* direction, const topography::Metadata& metadata) {
    if (points >= 2 && size > 0.0 && std::isfinite(size)) return;
    throw InvalidArgument(
        fmt::format("{}: {} points over {} m along {}; a spectrum needs at least 2 points and a positive size",
                    topography::label(metadata), points, size, direction));
}

}  // namespace

void require_shape(const topography::LineScan& scan) {
    require_extent(scan.heights.size(), scan.size, "x", scan.metadata);
}

void require_shape(const topography::HeightMap& map) {
    require_extent(map.heights.rows(), map.size[0], "x", map.metadata);
    require_extent(map.heights.cols(), map.size[1], "y", map.metadata);
}

void require_defined(const ArrayView1D& heights, const topography::Metadata& metadata) {
    for (Index i = 0; i < heights.size(); ++i)
        if (!std::isfinite(heights[i])) throw_undefined(metadata, fmt::format("point {}", i));
}

void throw_undefined(const topography::Metadata& metadata, const std::string& where) {
    throw UndefinedDataError(
        fmt::format("{}: undefined or infinite height at {}; a spectrum needs every height: fill the holes or "
                    "analyse a part without them",
                    topography::label(metadata), where));
}

}  // namespace setae::spectra
