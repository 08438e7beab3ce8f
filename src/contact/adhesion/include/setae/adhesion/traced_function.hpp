// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "setae/adhesion/prediction.hpp"

namespace setae::adhesion {

/// A function of a surface's spectral parameters and of further inputs.
using RoughFunction = std::function<double(const roughness::SpectralParameters&, const std::vector<double>& inputs)>;

/// Value of the function with all its inputs: inputs by propagated(), uncertainty of the spectrum by its spread.
[[nodiscard]] TracedValue traced_function(const RoughSide& rough, const std::vector<TracedValue>& inputs,
                                          const RoughFunction& function);

}  // namespace setae::adhesion
