// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/texture/distributions.hpp"

namespace setae::texture {

/// Values, each with a weight; no weights: all count the same.
struct CountedValues {
    std::vector<double> values;
    std::vector<double> weights;
};

/// The defined values of a measurement; heights of polylines are not among what it knows.
/// @throws InvalidArgument for slope_y of a line.
[[nodiscard]] CountedValues counted_values(const MeasurementView& measurement, Counted counted);

}  // namespace setae::texture
