// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/spectra/log_grid.hpp"
#include "setae/spectra/reliability.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::scales {

/// A quantity of one measurement as a function of a distance.
struct FunctionOfScale {
    std::string quantity;    ///< such as "autocorrelation", "variable_bandwidth", "rms_slope"
    std::string unit;        ///< SI unit of `value`
    Array1D distance;        ///< increasing, > 0 [m]
    Array1D value;           ///< [unit]
    Array1D standard_error;  ///< between measurements [unit]; NaN for one measurement
    Array1D count;  ///< basis of each value: number of pairs of points, residuals, differences, vectors; for polylines
                    ///< a length
    std::string count_unit = "1";  ///< "m" for the length of a polyline
    double reliable_from = 0.0;    ///< shorter distances are limited by sampling, tip or resolution [m]
    std::vector<Alert> alerts;
    topography::Metadata metadata;
};

/// Only distances >= reliable_from (up to rounding, 1e-9): the same rule for single and combined results.
[[nodiscard]] FunctionOfScale within_limit(FunctionOfScale function);

/// Averages over the bins of a grid: arithmetic means of distance and value over the members of each bin, counts added;
/// empty bins are left out. Idempotent.
[[nodiscard]] FunctionOfScale binned(const FunctionOfScale& function, const spectra::LogGrid& grid = {});

/// The shortest reliable wavelength of a measurement, limited by sampling, tip radius and resolution [m]: 2π over the
/// end of its reliable band. The shortest reliable distance depends on the quantity: half this wavelength for height
/// differences (the tip criterion uses the curvature, a stencil of two steps), n/2 of it for n-th derivatives over a
/// whole stencil, the wavelength for cells of a bandwidth. Source: 10.1016/j.apsadv.2021.100190.
[[nodiscard]] double shortest_reliable_wavelength(const topography::HeightMap& map,
                                                  const spectra::ReliabilityOptions& options = {},
                                                  parallel::Threads threads = {});
[[nodiscard]] double shortest_reliable_wavelength(const topography::TiledMap& map, Index lines_together,
                                                  const spectra::ReliabilityOptions& options = {},
                                                  parallel::Threads threads = {});
[[nodiscard]] double shortest_reliable_wavelength(const topography::LineScan& scan,
                                                  const spectra::ReliabilityOptions& options = {},
                                                  parallel::Threads threads = {});
[[nodiscard]] double shortest_reliable_wavelength(const topography::Profile& profile,
                                                  const spectra::ReliabilityOptions& options = {},
                                                  parallel::Threads threads = {});
[[nodiscard]] double shortest_reliable_wavelength(const topography::Measurement& measurement,
                                                  const spectra::ReliabilityOptions& options = {},
                                                  parallel::Threads threads = {});

/// Weights of measurements in the same bin.
enum class Weighting {
    equal,           ///< arithmetic mean over measurements
    per_instrument,  ///< arithmetic mean over instruments of the means of their measurements
    by_count,  ///< by `count`: the number of pairs, residuals or differences; lines and polylines cannot be combined
               ///< with these weights
};

struct CombinationOptions {
    spectra::LogGrid grid;  ///< of distances: bin b spans [10^(b/n), 10^((b+1)/n)) m, for all measurements
    Weighting weighting = Weighting::equal;
};

/// One function of scale from many measurements.
struct CombinedFunction {
    std::string quantity;
    std::string unit;
    Array1D distance;  ///< mean of the members' mean distances in the bin, weighted as the values [m]
    Array1D value;
    Array1D standard_error;                        ///< between measurements; NaN for one
    Array1D count;                                 ///< number of measurements in the bin
    Array1D instrument_count;                      ///< number of different instruments in the bin
    std::vector<std::vector<Index>> contributors;  ///< measurements in each bin
    std::vector<Alert> alerts;                     ///< COVERAGE_GAP: distances between measurements that are in none
};

/// Mean over measurements in each bin, for the reliable distances of each.
///
///   v = Σ w_i v_i/Σ w_i;   SE² = n/(n−1) Σ w_i² (v_i − v)²/(Σ w_i)²
///
/// Values that are not finite are skipped. The edges of bins depend neither on the order nor on the measurements.
/// @throws InvalidArgument for an empty list, for different quantities, for counts of different units as weights, or
/// without a reliable distance.
[[nodiscard]] CombinedFunction combine(std::span<const FunctionOfScale> functions,
                                       const CombinationOptions& options = {});

/// "equal", "per_instrument", "by_count". @throws InvalidArgument that lists them.
[[nodiscard]] Weighting weighting_from_name(const std::string& name);

}  // namespace setae::scales
