// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/core/arrays.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/table.hpp"
#include "setae/tables/force_curve.hpp"

namespace setae::tables {

/// Maximum number of curves of a plausible grid.
inline constexpr Index max_map_points = Index{1} << 22;

/// The grid of a force map: pixels of width/columns × height/rows around a centre, turned by an angle.
struct MapGrid {
    Index columns = 0, rows = 0;
    double width = 0.0, height = 0.0;  ///< extent along columns and rows [m]
    double x = 0.0, y = 0.0;           ///< centre [m]
    double angle = 0.0;                ///< from the x axis to the rows [rad]

    /// Column from the left and row from the top, where y is largest, of a position [m]; empty outside the grid.
    [[nodiscard]] std::optional<std::array<Index, 2>> pixel(double place_x, double place_y) const;
};

/// A force curve from read_force_curve() with its position.
struct PlacedCurve {
    Table table;
    double x = undefined, y = undefined;  ///< [m]; NaN if the file lacks it
};

/// The force curves of a file: one, or those of a map. Opened, but not read: only the caller keeps a curve in memory.
struct ForceCurves {
    std::string format;           ///< its identifier
    std::vector<long> numbers;    ///< numbers of the curves in the file; at least one
    std::optional<MapGrid> grid;  ///< if the file states one
    /// A curve by its number, from any thread. @throws as read_force_curve.
    std::function<PlacedCurve(long number)> read;
};

/// @throws FileError; FormatError if the source is no known force curve or its directory is damaged; InvalidArgument
/// for k or s ≤ 0.
[[nodiscard]] ForceCurves open_force_curves(const bytes::Source& source, const ForceCurveOptions& options = {});
[[nodiscard]] ForceCurves open_force_curves(const std::string& path, const ForceCurveOptions& options = {});

}  // namespace setae::tables
