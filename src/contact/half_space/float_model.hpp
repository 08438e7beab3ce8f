// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "setae/fourier/map_filter.hpp"

namespace setae::half_space {

/// Units of lengths and pressures with which all numbers of a model in float are about 1.
struct ModelUnits {
    double length = 1.0, pressure = 1.0;
};

/// factor T in float: a multiplier in the units of a model.
[[nodiscard]] inline fourier::MultiplierOf<float> float_multiplier(const fourier::Multiplier& multiplier,
                                                                   double factor) {
    fourier::MultiplierOf<float> result{.modes_x = multiplier.modes_x,
                                        .modes_y = multiplier.modes_y,
                                        .first_line = multiplier.first_line,
                                        .values = {}};
    result.values.resize(multiplier.values.size());
    std::ranges::transform(multiplier.values, result.values.begin(),
                           [factor](double value) { return static_cast<float>(factor * value); });
    return result;
}

}  // namespace setae::half_space
