// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::scales {

/// The vectors d = (k Δx, l Δy), k = 0 … x, l = −y … y, for which a map has pairs: half a plane.
struct Lags {
    Index x = 0;
    Index y = 0;
};
[[nodiscard]] Lags lags_of(const topography::HeightMap& map);

/// Receives A(k, −lags.y … lags.y), NaN where there is no pair, on a cache line. Rows of one block of 16 come in order
/// from one thread.
using LagRow = std::function<void(Index k, const double* values)>;

/// A of every vector of the half plane, row by row.
///
/// Linear correlation by one padded transform: rows along y, then column by column along x and, the squared spectrum
/// being real, back by a real transform in place, then rows back. Beside the map there is nothing but the half spectrum
/// of nx padded rows.
/// @throws UndefinedDataError where no height is defined.
void for_each_lag_row(const topography::HeightMap& map, parallel::Threads threads, const LagRow& consume);

}  // namespace setae::scales
