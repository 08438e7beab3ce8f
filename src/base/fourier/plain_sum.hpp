// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/fourier/nonuniform.hpp"

namespace setae::fourier {

/// nonuniform_transform() by direct summation, O(n_x n_q).
[[nodiscard]] Eigen::ArrayXcd nonuniform_transform_by_sum(const ArrayView1D& positions, const ArrayView1D& coefficients,
                                                          const ArrayView1D& wavevectors,
                                                          parallel::Threads threads = {});

}  // namespace setae::fourier
