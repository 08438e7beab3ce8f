// SPDX-License-Identifier: GPL-3.0-or-later
#include "pair_inputs.hpp"

#include <map>
#include <string_view>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::adhesion {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

/// Columns of every input, in the order of first mention.
class Columns {
public:
    void add(const Components& inputs) {
        for (const auto& [name, component] : inputs) {
            const auto [at, fresh] = places_.try_emplace(name, Place{count_, component.directions.size()});
            if (fresh) count_ += component.directions.size();
            else if (at->second.size != component.directions.size())
                throw InvalidArgument(fmt::format("input '{}' has {} directions in one value and {} in another", name,
                                                  at->second.size, component.directions.size()));
        }
    }
    [[nodiscard]] Index count() const { return count_; }

    template <class Row>
    void write(const Components& inputs, Row row) const {
        for (const auto& [name, component] : inputs) {
            const auto& place = places_.at(name);
            row.segment(place.first, place.size) = component.directions.matrix().transpose();
        }
    }

private:
    struct Place {
        Index first = 0, size = 0;
    };
    std::map<std::string_view, Place> places_;
    Index count_ = 0;
};

}  // namespace

PairInputs::PairInputs(const std::vector<PairPoint>& pairs) : pairs_(pairs), size_(static_cast<Index>(pairs.size())) {
    const auto parts_of = [](const PairPoint& pair) {
        return std::array{&pair.measured_inputs, &pair.measured_noise, &pair.slope_inputs, &pair.offset_inputs};
    };
    Columns columns;
    for (const auto& pair : pairs)
        for (const auto* inputs : parts_of(pair)) columns.add(*inputs);
    MatrixXd rows = MatrixXd::Zero(parts * size_, columns.count());
    for (Index i = 0; i < size_; ++i) {
        const auto of_pair = parts_of(pairs[static_cast<std::size_t>(i)]);
        for (Index part = 0; part < parts; ++part)
            columns.write(*of_pair[static_cast<std::size_t>(part)], rows.row(part * size_ + i));
    }
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
