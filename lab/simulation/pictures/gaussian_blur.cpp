// SPDX-License-Identifier: GPL-3.0-or-later
#include "gaussian_blur.hpp"

#include <cmath>

namespace setae::simulation {

GaussianKernel::GaussianKernel(double standard_deviation) {
    const auto reach = static_cast<Index>(std::ceil(5.0 * standard_deviation));
    weights = Array1D::Ones(2 * reach + 1);
    for (Index k = 0; k < weights.size() && reach > 0; ++k)
        weights[k] = std::exp(-0.5 * std::pow(static_cast<double>(k - reach) / standard_deviation, 2));
    weights /= weights.sum();
}

Array2D blurred(const Array2D& picture, const GaussianKernel& kernel) {
    const Index taps = kernel.weights.size(), rows = picture.rows() - taps + 1, columns = picture.cols() - taps + 1;
    if (taps == 1) return picture;
    Array2D result(rows, columns);
    Array1D down(picture.cols()), across(columns);
    for (Index row = 0; row < rows; ++row) {
        down = kernel.weights[0] * picture.row(row).transpose();
        for (Index k = 1; k < taps; ++k) down += kernel.weights[k] * picture.row(row + k).transpose();
        across = kernel.weights[0] * down.head(columns);
        for (Index k = 1; k < taps; ++k) across += kernel.weights[k] * down.segment(k, columns);
        result.row(row) = across.transpose();
    }
    return result;
}

}  // namespace setae::simulation
