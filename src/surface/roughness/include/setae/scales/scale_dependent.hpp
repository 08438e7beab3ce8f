// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "setae/scales/function_of_scale.hpp"

namespace setae::scales {

/// Direction of finite differences on a map; lines and polylines have x only.
enum class Along {
    x,  ///< the fast axis
    y,
    both,  ///< order 1: |∇h|, order 2: ½∇²h, at points with both components
};

/// Interpolation of heights between points.
enum class Interpolation {
    linear,   ///< between neighbours along the difference (the two triangles of a pixel share that edge)
    fourier,  ///< the trigonometric polynomial through all points: only periodic, fully defined data
};

/// Finite differences over a distance.
///
///   order 1: [h(x + s) − h(x)]/s                                    d = s
///   order 2: [h(x − s) − 2h(x) + h(x + s)]/s²                       d = 2s
///   order 3: [−h(x − s) + 3h(x) − 3h(x + s) + h(x + 2s)]/s³         d = 3s
///
/// d: length of the whole stencil [m]. If s is a whole number of steps (to 1e-9) heights are not interpolated. A
/// difference exists if every height with a nonzero weight is defined; differences do not extend beyond the ends of
/// non-periodic data.
struct DifferenceOptions {
    int order = 1;  ///< 1, 2 or 3
    Along along = Along::x;
    Interpolation interpolation = Interpolation::linear;
    /// Lengths of stencils [m]; by default the 10^(b/n) m of `grid` from order · pixel size to the size (order 1 of
    /// periodic data: half of it).
    std::optional<Array1D> distances;
    spectra::LogGrid grid;
    Index fewest = 4;  ///< distances with fewer differences are left out
    spectra::ReliabilityOptions reliability;
    parallel::Threads threads;
};

/// Statistics of differences at each distance; units are those of the derivative, [m^(1 − order)].
struct DifferenceStatistics {
    int order = 1;
    Along along = Along::x;
    Array1D distance;              ///< [m]
    Array1D count;                 ///< number of differences; for polylines the length of integration
    std::string count_unit = "1";  ///< "m" for a length
    Array1D mean;
    Array1D rms;       ///< about zero
    Array1D variance;  ///< about the mean, over `count`
    Array1D skewness;  ///< third central moment over variance^(3/2); NaN for variance 0
    Array1D kurtosis;  ///< fourth central moment over variance², 3 for Gaussian heights; NaN for variance 0
    Array1D minimum;
    Array1D maximum;
    double reliable_from = 0.0;  ///< order/2 of the shortest reliable wavelength [m]
    topography::Metadata metadata;
};

/// One pass over the heights for all distances; no map of derivatives is stored. O(points · distances). Rows are summed
/// in fixed blocks about the mean difference of the first row: same bytes for any number of threads.
/// @throws InvalidArgument for an order outside 1 … 3, order 3 along both, distances that are not positive or longer
/// than the data, Fourier interpolation of data that are not periodic, y of a line; UndefinedDataError for Fourier
/// interpolation of undefined points. Source: 10.1016/j.apsadv.2021.100190.
[[nodiscard]] DifferenceStatistics difference_statistics(const topography::HeightMap& map,
                                                         const DifferenceOptions& options = {});
[[nodiscard]] DifferenceStatistics difference_statistics(const topography::LineScan& scan,
                                                         const DifferenceOptions& options = {});
/// Polylines: integrals over x of the exact, piecewise linear difference, the same moments; O(points) per distance.
[[nodiscard]] DifferenceStatistics difference_statistics(const topography::Profile& profile,
                                                         const DifferenceOptions& options = {});
[[nodiscard]] DifferenceStatistics difference_statistics(const topography::Measurement& measurement,
                                                         const DifferenceOptions& options = {});

/// Statistic as a function of distance.
enum class Statistic { rms, variance, mean, skewness, kurtosis, minimum, maximum };

/// One statistic, with a name such as "rms_slope", "variance_of_curvature".
[[nodiscard]] FunctionOfScale function_of(const DifferenceStatistics& statistics, Statistic statistic);

/// Receives the differences at one distance along x or y, row by row of the map: `row` is the first index, `first` the
/// second index of values[0]; NaN if undefined. Called in order from one thread.
using RowConsumer = std::function<void(Index row, Index first, const ArrayView1D& values)>;

/// Passes all differences at one distance to a function: any statistic without a stored map. A line scan is a single
/// row.
/// @throws InvalidArgument as difference_statistics, and for Along::both.
void for_each_row_of_differences(const topography::HeightMap& map, double distance, const DifferenceOptions& options,
                                 const RowConsumer& consume);
void for_each_row_of_differences(const topography::LineScan& scan, double distance, const DifferenceOptions& options,
                                 const RowConsumer& consume);

/// "rms", "variance", "mean", "skewness", "kurtosis", "minimum", "maximum". @throws InvalidArgument that lists them.
[[nodiscard]] Statistic statistic_from_name(const std::string& name);
/// "x", "y", "both". @throws InvalidArgument that lists them.
[[nodiscard]] Along along_from_name(const std::string& name);

}  // namespace setae::scales
