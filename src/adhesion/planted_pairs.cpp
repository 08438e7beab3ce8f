// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/planted_pairs.hpp"

#include <algorithm>
#include <cmath>

#include "drawn_inputs.hpp"

namespace setae::adhesion {

std::vector<double> planted_values(const std::vector<PairPoint>& pairs, double work, const ModelScatter& scatter,
                                   std::uint64_t seed) {
    Deviates deviates;
    for (const auto& pair : pairs) deviates.add_inputs_of(pair);
    Effects effects(scatter);
    const numerics::RandomKey key{seed};
    deviates.draw(numerics::substream(key, 0));
    effects.draw(numerics::substream(key, 1));
    const auto noise = numerics::normal_numbers(numerics::substream(key, 2), 0, static_cast<Index>(pairs.size()));
    std::vector<double> values;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const auto& pair = pairs[i];
        // inputs are off in what is predicted with them; the truth is where they are right
        const double truth = pair.raw_prediction(work) - deviates.moved(pair.prediction_inputs(work));
        const double measured = (pair.floored ? std::max(0.0, truth) : truth) + effects.of(pair) +
                                deviates.moved(pair.measured_inputs) + deviates.moved(pair.measured_noise);
        values.push_back(measured + std::sqrt(pair.own_variance()) * noise[static_cast<Index>(i)]);
    }
    return values;
}

}  // namespace setae::adhesion
