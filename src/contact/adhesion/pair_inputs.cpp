// SPDX-License-Identifier: GPL-3.0-or-later
#include "pair_inputs.hpp"

#include "setae/core/component_rows.hpp"

namespace setae::adhesion {

using Eigen::MatrixXd, Eigen::VectorXd;

PairInputs::PairInputs(const std::vector<PairPoint>& pairs) : pairs_(pairs), size_(static_cast<Index>(pairs.size())) {
    std::vector<const Components*> values;  // part by part
    for (const auto part :
         {&PairPoint::in_unitputs, &PairPoint::measured_noise, &PairPoint::slope_inputs, &PairPoint::offset_inputs})
        for (const auto& pair : pairs) values.push_back(&(pair.*part));
    const MatrixXd rows = component_rows(values);
    products_.noalias() = rows * rows.transpose();
}

double PairInputs::prediction_variance(Index i, double work) const {
    return work * work * products(slope, slope)(i, i) - 2.0 * work * products(slope, offset)(i, i) +
           products(offset, offset)(i, i);
}

PairResiduals PairInputs::residuals_at(double work) const {
    PairResiduals result{VectorXd(size_), MatrixXd(size_, 1), VectorXd(size_), MatrixXd::Zero(size_, size_)};
    std::array<VectorXd, parts> weights;
    for (auto& weight : weights) weight.resize(size_);
    for (Index i = 0; i < size_; ++i) {
        const auto& pair = pairs_[static_cast<std::size_t>(i)];
        result.value[i] = pair.measured.value - pair.prediction(work);
        result.design(i, 0) = !pair.floored || pair.raw_prediction(work) > 0.0 ? pair.slope : 0.0;
        result.share[i] = share_through_floor(pair, work, prediction_variance(i, work));
        weights[measured][i] = predicted_over_measured(pair, work);
        weights[noise][i] = 1.0;
        weights[slope][i] = -work * result.share[i];
        weights[offset][i] = result.share[i];
    }
    if (result.design.isZero(0.0)) result.design.resize(size_, 0);
    for (Index a = 0; a < parts; ++a)
        for (Index b = 0; b < parts; ++b)
            result.covariance += weights[static_cast<std::size_t>(a)].asDiagonal() * products(a, b) *
                                 weights[static_cast<std::size_t>(b)].asDiagonal();
    for (Index i = 0; i < size_; ++i) result.covariance(i, i) += pairs_[static_cast<std::size_t>(i)].own_variance();
    return result;
}

std::vector<Components> residual_inputs(const std::vector<PairPoint>& pairs, double work) {
    std::vector<Components> inputs;
    for (const auto& pair : pairs) inputs.push_back(residual_inputs(pair, work));
    return inputs;
}

}  // namespace setae::adhesion
