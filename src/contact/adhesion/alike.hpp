// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace setae::adhesion {

/// One where both pairs have the same label.
template <class Pair>
[[nodiscard]] Eigen::MatrixXd alike(const std::vector<Pair>& pairs, std::string Pair::*label) {
    const auto n = static_cast<Eigen::Index>(pairs.size());
    Eigen::MatrixXd result(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j)
            result(i, j) =
                pairs[static_cast<std::size_t>(i)].*label == pairs[static_cast<std::size_t>(j)].*label ? 1.0 : 0.0;
    return result;
}

}  // namespace setae::adhesion
