// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/balance_draws.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "drawn_inputs.hpp"
#include "setae/adhesion/scatter_effects.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/resampling.hpp"
#include "setae/core/words.hpp"
#include "setae/numerics/random_numbers.hpp"

namespace setae::adhesion {

DrawnValue drawn_value(double value, std::vector<double> draws) {
    if (draws.size() < 2)
        throw InvalidArgument(fmt::format("{}; expected two or more", counted(draws.size(), "draw", "draws")));
    double mean = 0.0, squares = 0.0;
    for (const double draw : draws) mean += draw / static_cast<double>(draws.size());
    for (const double draw : draws) squares += (draw - mean) * (draw - mean);
    return {.value = value,
            .standard_error = std::sqrt(squares / (static_cast<double>(draws.size()) - 1.0)),
            .interval = percentile_interval(std::move(draws))};
}

BalanceDraws draw_balances(const TracedValue& work, const ModelScatter& scatter, const std::vector<PairPoint>& lines,
                           int count, std::uint64_t seed) {
    Deviates deviates;
    deviates.add(work.components);
    for (const auto& line : lines) deviates.add_inputs_of(line);
    std::vector<std::vector<double>> predictions(lines.size());
    for (int d = 0; d < count; ++d) {
        const numerics::RandomKey key{seed, static_cast<std::uint64_t>(d)};
        deviates.draw(substream(key, 0));
        ScatterEffects effects(scatter, substream(key, 1));
        const double drawn = work.value + deviates.moved(work.components);
        for (std::size_t k = 0; k < lines.size(); ++k) {
            auto line = lines[k];
            line.slope += deviates.moved(line.slope_inputs);
            line.offset += deviates.moved(line.offset_inputs);
            if (!line.departure.empty()) line.offset -= effects.of(line.surface, line.elastomer);
            predictions[k].push_back(line.prediction(drawn));
        }
    }
    BalanceDraws result{.count = count, .seed = seed};
    for (std::size_t k = 0; k < lines.size(); ++k)
        result.predictions.push_back(drawn_value(lines[k].prediction(work.value), std::move(predictions[k])));
    return result;
}

}  // namespace setae::adhesion
