// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace setae {

/// Owned series of doubles: a line of heights, wavevectors, a column of a table.
using Array1D = Eigen::ArrayXd;

/// Owned map of doubles, row-major, shape (nx, ny): the first index is x, y lies contiguous in memory.
using Array2D = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Read-only views that bind to owned arrays, segments and foreign memory without copying.
using ArrayView1D = Eigen::Ref<const Array1D>;
using ArrayView2D = Eigen::Ref<const Array2D>;

using Index = Eigen::Index;

}  // namespace setae
