// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/left_out.hpp"

#include <set>

#include "pair_least_squares.hpp"

namespace setae::adhesion {
namespace {

/// Contributions of the fitted W and of the scatter to the error of a pair's prediction.
Components work_and_scatter(const GeneralisedFit& others, const PairPoint& pair) {
    const double share = share_through_floor(pair, others.work_of_adhesion.value);
    return combined(
        {{share * pair.slope, others.work_of_adhesion.components}, {1.0, departure_from(others, pair, share)}});
}

/// Prediction of one pair that was not in the fit.
LeftOutPrediction predicted_by(const GeneralisedFit& others, const PairPoint& pair, bool surface_left_out) {
    const double work = others.work_of_adhesion.value, share = share_through_floor(pair, work);
    const auto of_work = work_and_scatter(others, pair);
    const TracedValue predicted{pair.prediction(work),
                                combined({{share, pair.prediction_inputs(work)}, {1.0, of_work}})};
    const Components own{{pair.own_noise(), own_noise(pair, 1.0)}};
    const TracedValue residual{pair.measured.value - predicted.value,
                               combined({{1.0, residual_inputs(pair, work)}, {-1.0, of_work}, {1.0, own}})};
    const auto estimate = residual.estimate();
    const auto interval = interval_of(estimate);
    return {surface_left_out,        pair.surface,
            pair.elastomer,          predicted.estimate(),
            pair.measured,           residual.value,
            estimate.standard_error, interval && interval->lower <= 0.0 && interval->upper >= 0.0};
}

/// Pairs by whether their label is the group's.
struct Parted {
    std::vector<PairPoint> others, own;
    Parted(const std::vector<PairPoint>& pairs, std::string PairPoint::*label, const std::string& group) {
        for (const auto& pair : pairs) (pair.*label == group ? own : others).push_back(pair);
    }
};

}  // namespace

std::vector<LeftOutPrediction> predict_left_out(const std::vector<PairPoint>& pairs) {
    const auto whole = fit_generalised(pairs);
    std::vector<LeftOutPrediction> predictions;
    for (const bool surfaces : {true, false}) {
        const auto label = surfaces ? &PairPoint::surface : &PairPoint::elastomer;
        for (const auto& group : groups_of(pairs, label)) {
            const Parted parted(pairs, label, group);
            if (parted.others.size() < 2) continue;
            const auto of_others = fit_some_generalised(parted.others, whole);
            for (const auto& pair : parted.own) predictions.push_back(predicted_by(of_others, pair, surfaces));
        }
    }
    return predictions;
}

}  // namespace setae::adhesion
