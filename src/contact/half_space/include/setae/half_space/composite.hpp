// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::half_space {

/// Heights [m] of the one rough surface that meets a flat as two rough surfaces meet each other, both measured looking
/// at them: the second is turned over about the y axis.
///
///   h(x_i, y_j) = h_1(x_i, y_j) + h_2(x_{nx−1−i}, y_j)
///
/// With the contact modulus of both bodies, contact::contact_modulus, the problem of two half-spaces is that of one.
/// @throws InvalidArgument for maps of different shapes.
/// Source: Johnson, Contact Mechanics (1985), ch. 13.
[[nodiscard]] Array2D composite_heights(const ArrayView2D& first, const ArrayView2D& second);

}  // namespace setae::half_space
