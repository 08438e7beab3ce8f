// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/traced_function.hpp"

namespace setae::adhesion {

TracedValue traced_function(const RoughSide& rough, const std::vector<TracedValue>& inputs,
                            const RoughFunction& function) {
    const auto of_inputs =
        propagated([&](const std::vector<double>& values) { return function(rough.parameters, values); }, inputs);
    std::vector<double> centre;
    for (const auto& input : inputs) centre.push_back(input.value);
    const auto of_spectrum = rough.traced([&](const roughness::SpectralParameters& p) { return function(p, centre); });
    return {of_inputs.value, combined({{1.0, of_spectrum.components}, {1.0, of_inputs.components}})};
}

}  // namespace setae::adhesion
