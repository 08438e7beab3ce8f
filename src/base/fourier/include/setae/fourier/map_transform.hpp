// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "setae/core/arrays.hpp"
#include "setae/fourier/transform.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::fourier {

/// Some lines of a spectrum: line(m)[k] is mode k of line first + m.
struct SpectrumBlock {
    Index index = 0;  ///< of the block: 0 … block_count − 1, its place in a reduction
    Index first = 0;
    Index lines = 0;
    Index modes = 0;
    Index stride = 0;  ///< from line to line
    const Complex* values = nullptr;

    [[nodiscard]] const Complex* line(Index m) const { return values + m * stride; }
};

/// Called once per block, from any thread; the values are valid until it returns.
using BlockConsumer = std::function<void(const SpectrumBlock&)>;

/// Lines per block; fixed, so that sums over blocks do not depend on threads.
inline constexpr Index lines_per_block = 16;

[[nodiscard]] constexpr Index block_count(Index lines) { return (lines + lines_per_block - 1) / lines_per_block; }

/// Half spectra of the lines along x of a map: line j holds the transform of map(0 … nx−1, j), nx/2 + 1 modes.
///
/// `prepare(j, line)` may change the nx values of line j before its transform (mean, window). Memory: one block per
/// thread.
void transform_lines(const ArrayView2D& map, const std::function<void(Index, double*)>& prepare,
                     const BlockConsumer& consume, parallel::Threads threads);

/// The half spectrum of a map of shape (nx, ny), passed on in blocks.
///
///   H(k, m) = sum_{i,j} h_ij exp(−2πi (ik/nx + jm/ny)),  m = 0 … ny/2 (line of the block), k = 0 … nx − 1 (its modes)
///
/// `load(i, line)` writes the ny values h_i0 … h_i,ny−1; `load` applies window and trend, without a copy of the map.
/// Memory: the half spectrum, nx · (ny/2 + 1) complex values, and one block per thread. O(nx ny log(nx ny)).
/// @throws InvalidArgument for nx or ny < 1.
void transform_map(Index nx, Index ny, const std::function<void(Index, double*)>& load, const BlockConsumer& consume,
                   parallel::Threads threads);

/// The half spectrum of a map whose lines i = rows … nx − 1 are zeros, which are neither loaded nor stored: memory rows
/// · (ny/2 + 1) complex values. @throws InvalidArgument also for rows < 1.
void transform_padded_map(Index nx, Index ny, Index rows, const std::function<void(Index, double*)>& load,
                          const BlockConsumer& consume, parallel::Threads threads);

}  // namespace setae::fourier
