// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"
#include "setae/topography/tiled_map.hpp"

namespace setae::topography {

/// What is subtracted before analysis.
enum class Trend {
    none,      ///< nothing
    mean,      ///< the mean height
    tilt,      ///< the best line or plane
    parabola,  ///< the best parabola, for maps the best paraboloid 1, x, y, x², y², xy
};

/// Heights minus the trend that fits them best in the least-squares sense over defined points.
///
/// Lines and maps: sum over points. Profiles: exact integral over the polyline, so that the result does not depend on
/// collinear points. Positions are centred and scaled first, so an offset of x costs no digits.
/// @throws UndefinedDataError where fewer points are defined than the trend has coefficients.
[[nodiscard]] HeightMap detrended(HeightMap&& map, Trend trend, parallel::Threads threads = {});
[[nodiscard]] HeightMap detrended(const HeightMap& map, Trend trend, parallel::Threads threads = {});
[[nodiscard]] LineScan detrended(LineScan scan, Trend trend);
[[nodiscard]] Profile detrended(Profile profile, Trend trend);
[[nodiscard]] Measurement detrended(Measurement measurement, Trend trend, parallel::Threads threads = {});

class PolynomialRows;

/// What detrended() subtracts from a map, for rows one by one, so that no second map is held.
class MapTrend {
public:
    /// Cost: one pass over the heights.
    /// @throws InvalidArgument for Trend::none; UndefinedDataError as detrended().
    MapTrend(const ArrayView2D& heights, Trend trend, parallel::Threads threads = {});

    /// Heights of row i without the trend, ny numbers each [m]; `rest` may be `heights`.
    void take_from(Index i, const double* heights, double* rest) const;

private:
    std::shared_ptr<const PolynomialRows> rows_;
};

/// The same of a map larger than memory: a pass over it finds the trend, which is then taken from every band read.
/// Equal to detrended() of the whole map up to rounding. lines_together: scan lines of a band of that pass, > 0.
[[nodiscard]] TiledMap detrended(TiledMap map, Trend trend, Index lines_together, parallel::Threads threads = {});

/// "none", "mean", "tilt", "parabola", or the step that does it, "level_plane". @throws InvalidArgument that lists
/// them.
[[nodiscard]] Trend trend_from_name(const std::string& name);
[[nodiscard]] std::string name(Trend trend);

}  // namespace setae::topography
