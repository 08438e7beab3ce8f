// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/balance_draws.hpp"

#include <algorithm>
#include <cmath>

#include "drawn_inputs.hpp"
#include "generalised_weights.hpp"
#include "setae/core/resampling.hpp"
#include "setae/core/statistics.hpp"
#include "setae/numerics/random_numbers.hpp"

namespace setae::adhesion {
namespace {

DrawnValue drawn_value(double value, const TracedValue& linear, std::vector<double> draws) {
    DrawnValue result{.value = value, .linear_standard_error = linear.standard_error()};
    double mean = 0.0, squares = 0.0;
    for (const double draw : draws) mean += draw / static_cast<double>(draws.size());
    for (const double draw : draws) squares += (draw - mean) * (draw - mean);
    result.standard_error = std::sqrt(squares / (static_cast<double>(draws.size()) - 1.0));
    result.interval = percentile_interval(std::move(draws));
    const double reach = normal_quantile(0.975) * result.linear_standard_error;
    result.linear_interval = {value - reach, value + reach};
    constexpr double tenth = 0.1;
    const double most = tenth * 2.0 * reach;
    result.parts = std::abs(result.interval.lower - result.linear_interval.lower) > most ||
                   std::abs(result.interval.upper - result.linear_interval.upper) > most;
    return result;
}

}  // namespace

BalanceDraws draw_balances(const std::vector<PairPoint>& pairs, const GeneralisedFit& fit,
                           const std::vector<PairPoint>& lines, int count, std::uint64_t seed) {
    const auto& work = fit.work_of_adhesion;
    Deviates deviates;
    if (pairs.empty()) deviates.add(work.components);
    for (const auto* list : {&pairs, &lines})
        for (const auto& pair : *list) deviates.add_inputs_of(pair);
    std::optional<GeneralisedWeights> weights;
    if (!pairs.empty()) weights.emplace(pairs, fit);
    Effects effects(fit.scatter);
    std::vector<double> works;
    std::vector<std::vector<double>> predictions(lines.size());
    for (int d = 0; d < count; ++d) {
        const numerics::RandomKey key{seed, static_cast<std::uint64_t>(d)};
        deviates.draw(substream(key, 0));
        effects.draw(substream(key, 1));
        const auto noise = numerics::normal_numbers(substream(key, 2), 0, static_cast<Index>(pairs.size()));
        const auto at_draw = [&](PairPoint pair) {
            pair.slope += deviates.moved(pair.slope_inputs);
            pair.offset += deviates.moved(pair.offset_inputs);
            return pair;
        };
        double drawn = work.value;
        if (weights) {
            std::vector<PairPoint> there;
            for (std::size_t i = 0; i < pairs.size(); ++i) {
                auto pair = at_draw(pairs[i]);
                const double relative = predicted_over_measured(pairs[i], work.value);
                pair.measured.value += relative * deviates.moved(pair.measured_inputs) +
                                       deviates.moved(pair.measured_noise) + effects.of(pair, share_through_floor(pairs[i], work.value)) +
                                       std::sqrt(pairs[i].own_variance()) * noise[static_cast<Index>(i)];
                there.push_back(std::move(pair));
            }
            drawn = weights->work_of(there);
        } else {
            drawn += deviates.moved(work.components);
        }
        works.push_back(drawn);
        for (std::size_t k = 0; k < lines.size(); ++k) {
            auto line = at_draw(lines[k]);
            if (!line.departure.empty()) line.offset -= effects.of(line, 1.0);
            predictions[k].push_back(line.prediction(drawn));
        }
    }
    BalanceDraws result{.count = count, .seed = seed};
    if (weights) result.work_of_adhesion = drawn_value(work.value, work, works);
    for (std::size_t k = 0; k < lines.size(); ++k) {
        const auto linear = raw_prediction(lines[k], work);
        result.predictions.push_back(
            drawn_value(lines[k].prediction(work.value), linear, std::move(predictions[k])));
    }
    return result;
}

}  // namespace setae::adhesion
