// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::texture {

/// Significant peaks and pits, by watersheds.
///
/// Every point belongs to the hill of the peak reached by steps to the highest of eight neighbours. A hill whose height
/// above its highest saddle is less than `pruning` Sz is joined to its neighbour across that saddle (Wolf pruning).
/// Hills that reach the edge of the map or an undefined point are left out, because their peaks may be outside. Dales
/// are the hills of −z.
///   Spd, Svd: peaks and pits per area [1/m²];  Spc, Svc: mean of −½(z_xx + z_yy) at them [1/m], pits negative
///   S5p, S5v: mean of the five (or fewer) highest (deepest) from the mean [m];  S10z = S5p + S5v
/// NaN if there is none.
/// Source: ISO 25178-2:2021, 5; Wolf, Proc. 2nd Int. Workshop on surface topography (1984).
struct FeatureParameters {
    double Spd = 0.0, Svd = 0.0;
    double Spc = 0.0, Svc = 0.0;
    double S5p = 0.0, S5v = 0.0, S10z = 0.0;
    Index hills = 0, dales = 0;
};

struct FeatureOptions {
    double pruning = 0.05;  ///< share of Sz
};

/// Cost: linear, and sorting of the points on watersheds. Memory: two integers per point and 16 bytes per point on a
/// watershed. @throws UndefinedDataError if no height is defined; InvalidArgument for pruning outside 0 … 1.
[[nodiscard]] FeatureParameters feature_parameters(const topography::HeightMap& map, const FeatureOptions& options = {},
                                                   parallel::Threads threads = {});

}  // namespace setae::texture
