// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/left_out.hpp"

#include <cmath>
#include <set>

namespace setae::adhesion {
namespace {

/// Of one pair that was not in the fit.
LeftOutPrediction predicted_by(const GeneralisedFit& others, const PairPoint& pair, bool surface_left_out) {
    const double work = others.work_of_adhesion.value, share = share_through_floor(pair, work);
    const auto& scatter = others.scatter;
    const auto& freedom = others.freedom;
    // of the group that stayed in the fit the others know the effect in part: it counts whole
    const auto anew = [&pair](double size, double known_with, const char* groups) {
        const Estimate effect{.value = 0.0, .standard_error = size, .degrees_of_freedom = known_with};
        return TracedValue(effect, pair.scatter_between(groups) + ", anew").components;
    };
    const auto of_model = combined({{1.0, anew(scatter.pair, freedom.pair, "pairs")},
                                    {share, anew(scatter.surface, freedom.surface, "surfaces")},
                                    {share, anew(scatter.elastomer, freedom.elastomer, "elastomers")}});
    const auto of_work = combined({{share * pair.slope, others.work_of_adhesion.components}, {1.0, of_model}});
    const TracedValue predicted{pair.prediction(work),
                                combined({{share, pair.prediction_inputs(work)}, {1.0, of_work}})};
    const Components own{{pair.own_noise(), own_noise(pair, 1.0)}};
    const TracedValue residual{
        pair.measured.value - predicted.value,
        combined({{1.0, residual_inputs(pair, work)}, {-1.0, of_work}, {1.0, own}})};
    const auto estimate = residual.estimate();
    const auto interval = interval_of(estimate);
    return {surface_left_out,
            pair.surface,
            pair.elastomer,
            predicted.estimate(),
            pair.measured,
            residual.value,
            estimate.standard_error,
            interval && interval->lower <= 0.0 && interval->upper >= 0.0};
}

}  // namespace

std::vector<LeftOutPrediction> predict_left_out(const std::vector<PairPoint>& pairs) {
    std::vector<LeftOutPrediction> result;
    for (const bool surfaces : {true, false}) {
        const auto label = surfaces ? &PairPoint::surface : &PairPoint::elastomer;
        std::set<std::string> groups;
        for (const auto& pair : pairs) groups.insert(pair.*label);
        for (const auto& group : groups) {
            std::vector<PairPoint> others, own;
            for (const auto& pair : pairs) (pair.*label == group ? own : others).push_back(pair);
            if (others.size() < 2) continue;
            const auto fit = fit_generalised(others);
            for (const auto& pair : own) result.push_back(predicted_by(fit, pair, surfaces));
        }
    }
    return result;
}

}  // namespace setae::adhesion
