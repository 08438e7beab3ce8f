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

/// Most curves of a grid that is believed.
inline constexpr Index max_map_points = Index{1} << 22;

/// The grid on which force curves were taken: pixels of width/columns × height/rows around a centre, turned by an
/// angle.
struct MapGrid {
    Index columns = 0, rows = 0;
    double width = 0.0, height = 0.0;  ///< extent along columns and rows [m]
    double x = 0.0, y = 0.0;           ///< centre [m]
    double angle = 0.0;                ///< from the x axis to the rows [rad]

    /// Column from the left and row from the top, where y is largest, of a place [m]; nothing outside the grid.
    [[nodiscard]] std::optional<std::array<Index, 2>> pixel(double place_x, double place_y) const;
};

/// A force curve as read_force_curve() gives it, and where it was taken.
struct PlacedCurve {
    Table table;
    double x = undefined, y = undefined;  ///< [m]; NaN where the file does not say
};

/// The force curves of a file: one, or those of a map. Opened, but not read: a curve is in memory as long as its caller
/// keeps it.
struct ForceCurves {
    std::string format;           ///< its identifier
    std::vector<long> numbers;    ///< of the curves, as the file counts them; at least one
    std::optional<MapGrid> grid;  ///< where the file states one
    /// A curve by its number, from any thread. @throws as read_force_curve.
    std::function<PlacedCurve(long number)> read;
};

/// @throws FileError; FormatError where the source is no force curve setae reads or its directory is damaged;
/// InvalidArgument for k or s ≤ 0.
[[nodiscard]] ForceCurves open_force_curves(const bytes::Source& source, const ForceCurveOptions& options = {});
[[nodiscard]] ForceCurves open_force_curves(const std::string& path, const ForceCurveOptions& options = {});

}  // namespace setae::tables
