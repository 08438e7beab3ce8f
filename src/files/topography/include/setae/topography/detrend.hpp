// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"
#include "setae/topography/tiled_map.hpp"

namespace setae::topography {

/// Trend that is subtracted before analysis.
enum class Trend {
    none,      ///< nothing
    mean,      ///< the mean height
    tilt,      ///< the best fitting line or plane
    parabola,  ///< the best fitting parabola, for maps the paraboloid 1, x, y, x², y², xy
};

/// Heights minus the best fitting trend, by least squares over defined points.
///
/// Lines and maps: sum over points. Profiles: exact integral over the polyline, so collinear points do not change the
/// result. Positions are centred and scaled first, so an offset of x causes no loss of digits.
/// @throws UndefinedDataError if fewer points are defined than the trend has coefficients.
[[nodiscard]] HeightMap detrended(HeightMap&& map, Trend trend, parallel::Threads threads = {});
[[nodiscard]] HeightMap detrended(const HeightMap& map, Trend trend, parallel::Threads threads = {});
[[nodiscard]] LineScan detrended(LineScan scan, Trend trend);
[[nodiscard]] Profile detrended(Profile profile, Trend trend);
[[nodiscard]] Measurement detrended(Measurement measurement, Trend trend, parallel::Threads threads = {});

class PolynomialRows;

/// The trend that detrended() subtracts from a map, for single rows: no second map is stored.
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

/// Subtracts a trend from a map larger than memory: one pass finds the trend, which is subtracted from every band when
/// it is read. Equal to detrended() of the whole map, up to rounding. lines_together: scan lines per band of that pass,
/// > 0.
[[nodiscard]] TiledMap detrended(TiledMap map, Trend trend, Index lines_together, parallel::Threads threads = {});

/// "none", "mean", "tilt", "parabola", or the name of the processing step, "level_plane". @throws InvalidArgument that
/// lists them.
[[nodiscard]] Trend trend_from_name(const std::string& name);
[[nodiscard]] std::string name(Trend trend);

}  // namespace setae::topography
