// SPDX-License-Identifier: GPL-3.0-or-later
#include "model_scatter_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "alike.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/minimum.hpp"

namespace setae::adhesion {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;
using Label = std::string PairPoint::*;

/// Whether effects of a label can be distinguished from those of pairs: three of them, and one with several pairs.
bool separable(const std::vector<PairPoint>& pairs, Label label) {
    std::map<std::string, int> counts;
    for (const auto& pair : pairs) ++counts[pair.*label];
    return counts.size() >= 3 &&
           std::any_of(counts.begin(), counts.end(), [](const auto& entry) { return entry.second > 1; });
}

}  // namespace

Eigen::LLT<MatrixXd> factor_of(const MatrixXd& covariance) {
    Eigen::LLT<MatrixXd> factor(covariance);
    if (factor.info() != Eigen::Success)
        throw UndefinedDataError("the covariance of the pairs is not positive definite");
    return factor;
}

MatrixXd generalised_weights(const MatrixXd& design, const MatrixXd& covariance) {
    const MatrixXd weighted = factor_of(covariance).solve(design);
    return factor_of(design.transpose() * weighted).solve(weighted.transpose());
}

ScatterFit::ScatterFit(const std::vector<PairPoint>& pairs, ScatterLevels wanted)
    : pairs_(pairs),
      same_surface_(alike(pairs, &PairPoint::surface)),
      same_elastomer_(alike(pairs, &PairPoint::elastomer)),
      levels_{&ModelScatter::pair} {
    if (wanted.surfaces && separable(pairs, &PairPoint::surface)) levels_.push_back(&ModelScatter::surface);
    if (wanted.elastomers && separable(pairs, &PairPoint::elastomer)) levels_.push_back(&ModelScatter::elastomer);
    for (const auto& pair : pairs) largest_ = std::max(largest_, std::abs(pair.measured.value));
}

MatrixXd ScatterFit::covariance(const PairResiduals& at, const ModelScatter& scatter) const {
    MatrixXd whole(at.covariance.rows(), at.covariance.cols());
    write_covariance(at, scatter, whole);
    return whole;
}

void ScatterFit::write_covariance(const PairResiduals& at, const ModelScatter& scatter, MatrixXd& whole) const {
    const double of_surfaces = scatter.surface * scatter.surface, of_elastomers = scatter.elastomer * scatter.elastomer;
    for (Index j = 0; j < whole.cols(); ++j)
        whole.col(j).array() = at.covariance.col(j).array() + at.share[j] * at.share.array() *
                                                                  (of_surfaces * same_surface_.col(j).array() +
                                                                   of_elastomers * same_elastomer_.col(j).array());
    const double least = 1e-9 * largest_;
    whole.diagonal().array() += std::max(scatter.pair * scatter.pair, least * least);
}

/// With V = LLᵀ everything follows from L⁻¹[X r].
class ScatterFit::Restricted {
public:
    Restricted(const ScatterFit& fit, const PairResiduals& at)
        : fit_(fit), at_(at), covariance_(at.covariance.rows(), at.covariance.cols()) {}

    [[nodiscard]] double log_likelihood(const ModelScatter& scatter) {
        constexpr double impossible = -std::numeric_limits<double>::infinity();
        fit_.write_covariance(at_, scatter, covariance_);
        factor_.compute(covariance_);
        if (factor_.info() != Eigen::Success) return impossible;
        residual_ = at_.value;
        factor_.matrixL().solveInPlace(residual_);
        const double log_likelihood =
            -factor_.matrixLLT().diagonal().array().log().sum() - 0.5 * residual_.squaredNorm();
        if (at_.design.cols() == 0) return log_likelihood;
        design_ = at_.design;
        factor_.matrixL().solveInPlace(design_);
        information_.compute(design_.transpose() * design_);
        if (information_.info() != Eigen::Success) return impossible;
        scores_ = design_.transpose() * residual_;
        information_.matrixL().solveInPlace(scores_);
        return log_likelihood + 0.5 * scores_.squaredNorm() - information_.matrixLLT().diagonal().array().log().sum();
    }

private:
    const ScatterFit& fit_;
    const PairResiduals& at_;
    MatrixXd covariance_, design_;
    VectorXd residual_, scores_;
    Eigen::LLT<MatrixXd> factor_, information_;
};

double ScatterFit::restricted_log_likelihood(const PairResiduals& at, const ModelScatter& scatter) const {
    return Restricted(*this, at).log_likelihood(scatter);
}

double ScatterFit::log_likelihood(const PairResiduals& at, const ModelScatter& scatter) const {
    const auto factor = factor_of(covariance(at, scatter));
    return -0.5 * at.value.dot(factor.solve(at.value)) - factor.matrixLLT().diagonal().array().log().sum() -
           0.5 * static_cast<double>(pairs_.size()) * std::log(2.0 * pi);
}

bool ScatterFit::tells(double ModelScatter::*level) const { return std::ranges::find(levels_, level) != levels_.end(); }

/// Each of the levels in turn, until none moves: a maximum that is one along every axis.
ModelScatter ScatterFit::climbed(Restricted& restricted, ModelScatter scatter, double reach) const {
    constexpr int sweeps = 60, bits = 20;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        double moved = 0.0;
        for (const auto level : levels_) {
            const auto loss = [&](double value) {
                auto tried = scatter;
                tried.*level = value;
                return -restricted.log_likelihood(tried);
            };
            const double before = scatter.*level;
            auto best = numerics::minimum_between(loss, 0.0, reach, bits);
            // Brent's rule looks into one valley: neither the end at 0 nor where it came from is to be lost
            for (const double known : {0.0, before})
                if (const double there = loss(known); there <= best.value) best = {known, there};
            moved = std::max(moved, std::abs(best.place - before));
            scatter.*level = best.place;
        }
        if (moved < 1e-5 * reach) break;
    }
    return scatter;
}

/// Points of a grid of all levels that no neighbour exceeds: from each a climb may end on another summit.
std::vector<ModelScatter> ScatterFit::summits_of_grid(Restricted& restricted, double reach) const {
    static constexpr std::array steps{0.0, 0.06, 0.16, 0.4, 1.0};  // shares of the reach
    constexpr Index side = steps.size();
    const auto levels = static_cast<Index>(levels_.size());
    const auto count = static_cast<Index>(std::llround(std::pow(side, levels)));
    const auto place = [](Index point, Index level) {
        for (Index k = 0; k < level; ++k) point /= side;
        return point % side;
    };
    const auto at = [&](Index point) {
        ModelScatter scatter;
        for (Index k = 0; k < levels; ++k)
            scatter.*levels_[static_cast<std::size_t>(k)] = steps[static_cast<std::size_t>(place(point, k))] * reach;
        return scatter;
    };
    std::vector<double> heights;
    for (Index point = 0; point < count; ++point) heights.push_back(restricted.log_likelihood(at(point)));
    std::vector<ModelScatter> summits;
    for (Index point = 0; point < count; ++point) {
        bool highest = true;
        for (Index k = 0, stride = 1; k < levels; ++k, stride *= side)
            for (const Index step : {-stride, stride}) {
                const Index along = place(point, k) + (step < 0 ? -1 : 1);
                if (along < 0 || along >= side) continue;
                highest = highest &&
                          heights[static_cast<std::size_t>(point)] >= heights[static_cast<std::size_t>(point + step)];
            }
        if (highest) summits.push_back(at(point));
    }
    return summits;
}

double ScatterFit::reach_of(const PairResiduals& at) const {
    return 3.0 * std::sqrt(at.value.squaredNorm() / static_cast<double>(pairs_.size() - 1));
}

ModelScatter ScatterFit::nearest_summit(const PairResiduals& at, const ModelScatter& scatter) const {
    const double reach = reach_of(at);
    if (!(reach > 0.0)) return scatter;
    Restricted restricted(*this, at);
    return climbed(restricted, scatter, reach);
}

ModelScatter ScatterFit::most_likely(const PairResiduals& at, ModelScatter scatter) const {
    const double reach = reach_of(at);
    if (!(reach > 0.0)) return scatter;
    Restricted restricted(*this, at);
    auto best = climbed(restricted, scatter, reach);
    double highest = restricted.log_likelihood(best);
    for (auto summit : summits_of_grid(restricted, reach)) {
        // for levels that the pairs do not determine, the given ones
        for (const auto level : {&ModelScatter::pair, &ModelScatter::surface, &ModelScatter::elastomer})
            if (!tells(level)) summit.*level = scatter.*level;
        const auto found = climbed(restricted, summit, reach);
        // of two equal maxima the nearer one
        constexpr double alike = 1e-9;
        if (const double there = restricted.log_likelihood(found); there > highest + alike) {
            highest = there;
            best = found;
        }
    }
    return best;
}

Components ScatterFit::components(const PairResiduals& at, const std::vector<Components>& inputs,
                                  const ModelScatter& scatter, const VectorXd& h) const {
    std::vector<Dependence> parts;
    for (std::size_t i = 0; i < pairs_.size(); ++i) parts.push_back({h[static_cast<Index>(i)], inputs[i]});
    auto result = combined(parts);
    for (std::size_t i = 0; i < pairs_.size(); ++i)
        if (pairs_[i].own_variance() > 0.0)
            result[pairs_[i].own_noise()] = own_noise(pairs_[i], h[static_cast<Index>(i)]);
    add_scatter(result, at, scatter, h);
    return result;
}

void ScatterFit::add_scatter(Components& result, const PairResiduals& at, const ModelScatter& scatter,
                             const VectorXd& h) const {
    if (scatter.pair > 0.0) {
        const auto freedom = static_cast<double>(pairs_.size()) - std::max(1.0, static_cast<double>(at.design.cols()));
        result[pairs_.front().scatter_between("pairs")] = {scatter.pair * h.array(), freedom};
    }
    const auto add = [&](const char* groups, double size, Label label) {
        if (!(size > 0.0)) return;
        std::map<std::string, double> sums;
        for (std::size_t i = 0; i < pairs_.size(); ++i)
            sums[pairs_[i].*label] += h[static_cast<Index>(i)] * at.share[static_cast<Index>(i)];
        Component component{Array1D(static_cast<Index>(sums.size())), static_cast<double>(sums.size()) - 1.0};
        Index place = 0;
        for (const auto& [group, sum] : sums) component.directions[place++] = size * sum;
        result[pairs_.front().scatter_between(groups)] = std::move(component);
    };
    add("surfaces", scatter.surface, &PairPoint::surface);
    add("elastomers", scatter.elastomer, &PairPoint::elastomer);
}

}  // namespace setae::adhesion
