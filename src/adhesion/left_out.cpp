// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/left_out.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "model_scatter_fit.hpp"
#include "pair_least_squares.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/log_gamma.hpp"

namespace setae::adhesion {
namespace {

/// What the fitted W and the scatter add to the error of a pair's prediction.
Components work_and_scatter(const GeneralisedFit& others, const PairPoint& pair) {
    const double share = share_through_floor(pair, others.work_of_adhesion.value);
    return combined(
        {{share * pair.slope, others.work_of_adhesion.components}, {1.0, departure_from(others, pair, share)}});
}

/// Of one pair that was not in the fit.
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

/// Of the residuals of pairs of one surface that was not in the fit: inputs, the fitted W, own noise, the scatter.
Eigen::MatrixXd covariance_by(const GeneralisedFit& others, const std::vector<PairPoint>& own) {
    const double work = others.work_of_adhesion.value;
    std::vector<Components> inputs;
    for (const auto& pair : own)
        inputs.push_back(combined({{1.0, residual_inputs(pair, work)}, {-1.0, work_and_scatter(others, pair)}}));
    return residual_covariance(own, inputs);
}

/// ln density of Student's t in several dimensions about 0.
double log_student(const Eigen::VectorXd& x, const Eigen::MatrixXd& scale, double freedom) {
    const auto factor = factor_of(scale);
    const auto n = static_cast<double>(x.size());
    return log_gamma(0.5 * (freedom + n)) - log_gamma(0.5 * freedom) - 0.5 * n * std::log(freedom * pi) -
           factor.matrixLLT().diagonal().array().log().sum() -
           0.5 * (freedom + n) * std::log1p(x.dot(factor.solve(x)) / freedom);
}

/// ln density of what was measured on a surface that was not in the fit.
double log_density_by(const GeneralisedFit& others, const std::vector<PairPoint>& own) {
    Eigen::VectorXd residual(static_cast<Index>(own.size()));
    for (Index i = 0; i < residual.size(); ++i) {
        const auto& pair = own[static_cast<std::size_t>(i)];
        residual[i] = pair.measured.value - pair.prediction(others.work_of_adhesion.value);
    }
    return log_student(residual, covariance_by(others, own), std::max(1.0, others.freedom.pair));
}

}  // namespace

LeftOut leave_out(const std::vector<PairPoint>& pairs, const PairFit& fit) {
    constexpr std::size_t fewest_surfaces = 3;
    LeftOut result;
    if (groups_of(pairs, &PairPoint::surface).size() < fewest_surfaces) result.surface_log_density = undefined;
    for (const bool surfaces : {true, false}) {
        const auto label = surfaces ? &PairPoint::surface : &PairPoint::elastomer;
        for (const auto& group : groups_of(pairs, label)) {
            const Parted parted(pairs, label, group);
            if (parted.others.size() < 2) {
                if (surfaces) result.surface_log_density = undefined;
                continue;
            }
            const auto of_others = fit(parted.others);
            for (const auto& pair : parted.own) result.predictions.push_back(predicted_by(of_others, pair, surfaces));
            if (surfaces) result.surface_log_density += log_density_by(of_others, parted.own);
        }
    }
    return result;
}

std::vector<LeftOutPrediction> predict_left_out(const std::vector<PairPoint>& pairs) {
    const auto whole = fit_generalised(pairs);
    return leave_out(pairs, [&](const std::vector<PairPoint>& others) { return fit_some_generalised(others, whole); })
        .predictions;
}

}  // namespace setae::adhesion
