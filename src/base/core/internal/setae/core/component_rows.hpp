// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "setae/core/traced_value.hpp"

namespace setae {

/// Components of several values as the rows of one matrix, one column per direction of an input, in the order of first
/// occurrence: the product with its transpose is the covariance of the values.
/// @throws InvalidArgument if two values have one input with different numbers of directions.
[[nodiscard]] Eigen::MatrixXd component_rows(const std::vector<const Components*>& values);

}  // namespace setae
