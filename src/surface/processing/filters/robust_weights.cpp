// SPDX-License-Identifier: GPL-3.0-or-later
#include "robust_weights.hpp"

#include <cmath>
#include <vector>

#include "setae/core/statistics.hpp"

namespace setae::processing {
namespace {

constexpr double scales_per_median = 4.4478;
constexpr double settled = 1e-4;
constexpr int max_updates = 50;

double median_size(const Array2D& residuals) {
    std::vector<double> sizes;
    sizes.reserve(static_cast<std::size_t>(residuals.size()));
    for (const double residual : residuals.reshaped<Eigen::RowMajor>())
        if (!std::isnan(residual)) sizes.push_back(std::abs(residual));
    return sizes.empty() ? 0.0 : median(sizes);
}

}  // namespace

bool RobustScale::update(const ArrayView2D& heights, const ArrayView2D& smooth, Array2D& weights) {
    if (updates_ == max_updates) return false;
    weights = heights - smooth;
    const double before = scale_;
    scale_ = scales_per_median * median_size(weights);
    if (!(scale_ > 0.0) || std::abs(scale_ - before) < settled * scale_) return false;
    ++updates_;
    weights = (weights.abs() < scale_).select((1.0 - (weights / scale_).square()).square(), 0.0);
    return true;
}

}  // namespace setae::processing
