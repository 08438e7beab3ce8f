// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::scales {

/// The vectors d = (k Δx, l Δy), k = 0 … x, l = −y … y, of pairs on a map: half a plane.
struct Lags {
    Index x = 0;
    Index y = 0;
};
[[nodiscard]] Lags lags_of(const topography::HeightMap& map);

/// Receives A(k, −lags.y … lags.y), NaN without a pair, aligned to a cache line. Rows of one block of 16 come in order
/// from one thread.
using LagRow = std::function<void(Index k, const double* values)>;

/// A for every vector of the half plane, row by row.
///
/// Linear correlation by one padded transform: rows along y, then column by column along x and, since the squared
/// spectrum is real, back by a real transform in place, then the inverse transform of the rows. Additional memory: only
/// the half spectrum of nx padded rows.
/// @throws UndefinedDataError if no height is defined.
void for_each_lag_row(const topography::HeightMap& map, parallel::Threads threads, const LagRow& consume);

}  // namespace setae::scales
