// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/marginal_scatter.hpp"

#include <cmath>

#include <fmt/format.h>

#include "alike.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::adhesion {
namespace {

using Eigen::Index, Eigen::LLT, Eigen::MatrixXd, Eigen::VectorXd;

/// Medians of equally probable pieces of a half-Cauchy.
std::vector<double> quantiles(double scale, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(scale * std::tan(0.5 * pi * (i + 0.5) / count));
    return values;
}

/// ln of the normal density about 0 of each column, [..]^−n.
VectorXd log_normal(const LLT<MatrixXd>& factor, const MatrixXd& residuals) {
    const MatrixXd whitened = factor.matrixL().solve(residuals);
    const double norm = factor.matrixLLT().diagonal().array().log().sum() +
                        0.5 * static_cast<double>(residuals.rows()) * std::log(2.0 * pi);
    return (-0.5 * whitened.colwise().squaredNorm().array() - norm).matrix().transpose();
}

}  // namespace

void LogSum::add(double x) {
    if (x > largest_) {
        sum_ = sum_ * std::exp(largest_ - x) + 1.0;
        largest_ = x;
    } else {
        sum_ += std::exp(x - largest_);
    }
}

double LogSum::value() const { return largest_ + std::log(sum_); }

MarginalScatter::MarginalScatter(const std::vector<PairLabels>& pairs, double scale, ScatterNodes nodes)
    : same_surface_(alike(pairs, &PairLabels::surface)),
      same_elastomer_(alike(pairs, &PairLabels::elastomer)),
      pair_levels_(quantiles(scale, nodes.pair)),
      surface_levels_(quantiles(scale, nodes.surface)),
      elastomer_levels_(quantiles(scale, nodes.elastomer)) {
    if (pairs.empty() || !(scale > 0.0))
        throw InvalidArgument(
            fmt::format("scatter of {} pairs with a prior of scale {}; expected one pair or more and a scale above 0",
                        pairs.size(), scale));
}

MatrixXd MarginalScatter::with(const MatrixXd& covariance, const ModelScatter& scatter) const {
    MatrixXd whole = covariance + scatter.surface * scatter.surface * same_surface_ +
                     scatter.elastomer * scatter.elastomer * same_elastomer_;
    whole.diagonal().array() += scatter.pair * scatter.pair;
    return whole;
}

void MarginalScatter::visit(const MatrixXd& covariance, const std::function<void(const Node&)>& visitor) const {
    const double weight =
        -std::log(static_cast<double>(pair_levels_.size() * surface_levels_.size() * elastomer_levels_.size()));
    LLT<MatrixXd> factor(size());
    MatrixXd whole(size(), size());
    for (const double of_surfaces : surface_levels_)
        for (const double of_elastomers : elastomer_levels_) {
            const MatrixXd grouped = covariance + of_surfaces * of_surfaces * same_surface_ +
                                     of_elastomers * of_elastomers * same_elastomer_;
            for (const double of_pairs : pair_levels_) {
                whole = grouped;
                whole.diagonal().array() += of_pairs * of_pairs;
                factor.compute(whole);
                if (factor.info() != Eigen::Success)
                    throw UndefinedDataError("the covariance of the pairs is not positive definite");
                visitor({{of_pairs, of_surfaces, of_elastomers}, weight, factor});
            }
        }
}

VectorXd MarginalScatter::log_densities(const MatrixXd& covariance, const MatrixXd& residuals) const {
    std::vector<LogSum> sums(static_cast<std::size_t>(residuals.cols()));
    visit(covariance, [&](const Node& node) {
        const VectorXd there = log_normal(node.factor, residuals);
        for (Index k = 0; k < there.size(); ++k) sums[static_cast<std::size_t>(k)].add(node.log_weight + there[k]);
    });
    VectorXd result(residuals.cols());
    for (Index k = 0; k < result.size(); ++k) result[k] = sums[static_cast<std::size_t>(k)].value();
    return result;
}

ModelScatter MarginalScatter::posterior_scatter(const MatrixXd& covariance, const VectorXd& residuals) const {
    std::vector<std::pair<double, ModelScatter>> nodes;
    LogSum all;
    visit(covariance, [&](const Node& node) {
        const double there = node.log_weight + log_normal(node.factor, residuals)[0];
        all.add(there);
        nodes.emplace_back(there, node.scatter);
    });
    ModelScatter squares;
    const double total = all.value();
    for (const auto& [density, scatter] : nodes) {
        const double share = std::exp(density - total);
        for (const auto level : {&ModelScatter::pair, &ModelScatter::surface, &ModelScatter::elastomer})
            squares.*level += share * scatter.*level * scatter.*level;
    }
    return {std::sqrt(squares.pair), std::sqrt(squares.surface), std::sqrt(squares.elastomer)};
}

}  // namespace setae::adhesion
