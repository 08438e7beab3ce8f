// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::contact {

/// Values of a function for each entry of a series, in order.
template <class Function>
[[nodiscard]] Array1D mapped(const ArrayView1D& values, Function&& function) {
    Array1D result(values.size());
    for (Index i = 0; i < values.size(); ++i) result[i] = function(values[i]);
    return result;
}

}  // namespace setae::contact
