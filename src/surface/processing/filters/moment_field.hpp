// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "gaussian_axis.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::processing {

/// Powers of the coordinates along x and y.
struct Powers {
    Index x = 0;
    Index y = 0;
};

/// Powers up to x^max_x, y^max_y whose sum is at most `total`, ordered by total first, so powers of a lower total come
/// first.
[[nodiscard]] std::vector<Powers> powers_up_to(Index total, Index max_x, Index max_y);

/// Writes the values of row i in columns first … first + count − 1.
using LoadValues = std::function<void(Index i, Index first, Index count, double* values)>;

/// Sums of a field with Gaussian weights and powers of coordinates about every point of a map.
///
///   M_kl(i, j) = sum K^x_ii' K^y_jj' ξ^k η^l f_i'j',  ξ, η: coordinates about the point's references (GaussianAxis)
class MomentField {
public:
    MomentField(const GaussianAxis& along_x, const GaussianAxis& along_y, std::vector<Powers> powers,
                const LoadValues& load, parallel::Threads threads);

    [[nodiscard]] const std::vector<Powers>& powers() const { return powers_; }
    /// Moment number p at points (i, first … first + count − 1).
    void moments(Index i, Index first, Index count, std::size_t p, double* values) const;

private:
    void share_rows(const LoadValues& load, parallel::Threads threads);
    void gather_columns(const LoadValues& load, parallel::Threads threads);

    const GaussianAxis* along_x_;
    const GaussianAxis* along_y_;
    std::vector<Powers> powers_;
    Index max_x_ = 0, max_y_ = 0, total_ = 0;
    std::vector<Array2D> shared_;  ///< [m](coarse x, y): before the sums along y
    std::vector<std::vector<Array2D>>
        partial_;  ///< [m][l](coarse x, y): x-moments about coarse points, y-moments about points
};

}  // namespace setae::processing
