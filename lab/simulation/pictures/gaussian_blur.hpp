// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::simulation {

/// A Gaussian at whole pixels, out to five standard deviations, of sum 1; one value for a deviation of 0.
struct GaussianKernel {
    explicit GaussianKernel(double standard_deviation);

    Array1D weights;

    [[nodiscard]] long half() const { return static_cast<long>(weights.size()) / 2; }
    /// Standard deviation of white noise of deviation 1 after blurring along rows and columns.
    [[nodiscard]] double noise_left() const { return weights.square().sum(); }
};

/// The picture blurred along rows and columns, without the border of half() pixels that its surroundings would be
/// needed for.
[[nodiscard]] Array2D blurred(const Array2D& picture, const GaussianKernel& kernel);

}  // namespace setae::simulation
