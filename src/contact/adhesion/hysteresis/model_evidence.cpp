// SPDX-License-Identifier: GPL-3.0-or-later
#include "model_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "setae/adhesion/marginal_scatter.hpp"
#include "setae/core/statistics.hpp"

namespace setae::hysteresis {
namespace {

using adhesion::MarginalScatter;
using Eigen::MatrixXd, Eigen::VectorXd;

using Places = std::vector<Index>;

/// Nodes for the density; the fit of inputs uses fewer.
constexpr adhesion::ScatterNodes density_nodes{8, 6, 6}, search_nodes{4, 3, 3};

/// Scatter of some of the pairs.
class Scatter {
public:
    Scatter(const std::vector<RankedPair>& pairs, const Places& places, double scale)
        : density(labels_of(pairs, places), scale, density_nodes),
          search(labels_of(pairs, places), scale, search_nodes) {}
    MarginalScatter density, search;

private:
    static std::vector<adhesion::PairLabels> labels_of(const std::vector<RankedPair>& pairs, const Places& places) {
        std::vector<adhesion::PairLabels> labels;
        for (const Index i : places) {
            const auto& pair = pairs[static_cast<std::size_t>(i)].pair;
            labels.push_back({pair.rough.name, pair.soft.name});
        }
        return labels;
    }
};

/// The most likely inputs for a branch of some pairs, and their distribution.
struct Step {
    BranchLines lines;  ///< lines of all pairs, about the inputs from the pairs in the fit
    Knowledge known;    ///< after them
    MatrixXd gain;      ///< shift of the mean per residual of each pair in the fit
    adhesion::ModelScatter scatter;
};

Step learn(const BothBranches& model, Branch branch, const Knowledge& before, const Places& seen,
           const MarginalScatter& scatter) {
    constexpr int steps = 4;
    constexpr double damping = 0.8;
    VectorXd x = before.mean;
    Step step;
    for (int round = 0; round <= steps; ++round) {
        step.lines = model.lines_at(branch, x, before);
        const MatrixXd covariance = step.lines.covariance(seen, seen);
        const VectorXd residual = step.lines.residual(seen);
        step.scatter = scatter.posterior_scatter(covariance, residual);
        const Eigen::LLT<MatrixXd> factor(scatter.with(covariance, step.scatter));
        const MatrixXd with = step.lines.covariance_with(Eigen::all, seen);
        step.gain = factor.solve(with.transpose()).transpose();
        const VectorXd found = before.mean + step.gain * residual;
        if (round == steps) {
            step.known.mean = found;
            step.known.covariance = before.covariance - step.gain * with.transpose();
            return step;
        }
        x += damping * (found - x);
    }
    return step;
}

Places all_of(Index n) {
    Places places;
    for (Index i = 0; i < n; ++i) places.push_back(i);
    return places;
}

/// ln m(all) − ln m(pairs in the fit) of residuals, one column each.
VectorXd log_density_of_rest(const BranchLines& lines, const MatrixXd& residuals, const Places& seen,
                             const Scatter& of_all, const Scatter& of_seen) {
    return of_all.density.log_densities(lines.covariance, residuals) -
           of_seen.density.log_densities(lines.covariance(seen, seen), residuals(seen, Eigen::all));
}

/// The data, and the data with noise.
MatrixXd columns(const VectorXd& residual, const MatrixXd& noise) {
    MatrixXd result(residual.size(), 1 + noise.cols());
    result.col(0) = residual;
    result.rightCols(noise.cols()) = noise.colwise() + residual;
    return result;
}

adhesion::LeftOutPrediction prediction_of(const BothBranches& model, const std::vector<RankedPair>& pairs, Index i,
                                          const Step& learnt, const BranchLines& lines, bool by_surface) {
    const auto& [pair, approach, measured] = pairs[static_cast<std::size_t>(i)];
    const auto& s = learnt.scatter;
    const double inputs = lines.covariance(i, i) - lines.own_variance[i],
                 scatter = s.pair * s.pair + s.surface * s.surface + s.elastomer * s.elastomer;
    adhesion::LeftOutPrediction prediction{.surface_left_out = by_surface,
                                           .surface = pair.rough.name,
                                           .elastomer = pair.soft.name,
                                           .measured = measured.value};
    const double predicted = model.predicted(Branch::retraction, i, learnt.known.mean);
    prediction.predicted = {
        .value = predicted, .standard_error = std::sqrt(std::max(0.0, inputs) + scatter), .method = "posterior"};
    prediction.residual = measured.value.value - predicted;
    prediction.standard_error = std::sqrt(std::max(0.0, inputs) + scatter + lines.own_variance[i]);
    constexpr double reach = 1.959963984540054;
    prediction.within_interval = std::abs(prediction.residual) <= reach * prediction.standard_error;
    return prediction;
}

}  // namespace

LeftOutEvidence left_out_evidence(const BothBranches& model, const std::vector<RankedPair>& pairs,
                                  const ScatterScales& scales, bool by_surface, bool with_constant) {
    const auto group_of = [&](Index i) -> const std::string& {
        const auto& pair = pairs[static_cast<std::size_t>(i)].pair;
        return by_surface ? pair.rough.name : pair.soft.name;
    };
    std::set<std::string> groups;
    for (Index i = 0; i < model.size(); ++i) groups.insert(group_of(i));
    const Places all = all_of(model.size());
    const Scatter all_approach(pairs, all, scales.approach), all_retraction(pairs, all, scales.retraction);
    LeftOutEvidence evidence;
    for (const auto& group : groups) {
        Places seen;
        for (const Index i : all)
            if (group_of(i) != group) seen.push_back(i);
        if (seen.size() < 2) continue;
        const Scatter seen_approach(pairs, seen, scales.approach), seen_retraction(pairs, seen, scales.retraction);
        auto on_approach = learn(model, Branch::approach, model.prior(with_constant), seen, seen_approach.search);
        auto on_retraction = learn(model, Branch::retraction, on_approach.known, seen, seen_retraction.search);
        evidence.approach +=
            log_density_of_rest(on_approach.lines, on_approach.lines.residual, seen, all_approach, seen_approach)[0];
        evidence.retraction += log_density_of_rest(on_retraction.lines, on_retraction.lines.residual, seen,
                                                   all_retraction, seen_retraction)[0];
        if (!with_constant) {
            const auto lines = model.lines_at(Branch::retraction, on_retraction.known.mean, on_retraction.known);
            for (const Index i : all)
                if (group_of(i) == group)
                    evidence.predictions.push_back(prediction_of(model, pairs, i, on_retraction, lines, by_surface));
        }
        evidence.fits.push_back({std::move(seen), std::move(on_approach.lines), std::move(on_retraction.lines),
                                 std::move(on_approach.gain)});
    }
    return evidence;
}

VariedEvidence varied_evidence(const LeftOutEvidence& evidence, const std::vector<RankedPair>& pairs,
                               const ScatterScales& scales, const DrawnNoise& noise) {
    const Places all = all_of(noise.approach.rows());
    const Scatter all_approach(pairs, all, scales.approach), all_retraction(pairs, all, scales.retraction);
    VariedEvidence varied;
    varied.approach = varied.retraction = VectorXd::Zero(1 + noise.approach.cols());
    for (const auto& [seen, on_approach, on_retraction, gain] : evidence.fits) {
        const Scatter seen_approach(pairs, seen, scales.approach), seen_retraction(pairs, seen, scales.retraction);
        varied.approach += log_density_of_rest(on_approach, columns(on_approach.residual, noise.approach), seen,
                                               all_approach, seen_approach);
        // noise of W_app shifts the initial inputs of retraction, and the measured W_app
        const MatrixXd of_approach = noise.approach(seen, Eigen::all), moved = gain * of_approach;
        const MatrixXd shift =
            noise.retraction - on_retraction.by_approach.asDiagonal() * noise.approach - on_retraction.jacobian * moved;
        varied.retraction += log_density_of_rest(on_retraction, columns(on_retraction.residual, shift), seen,
                                                 all_retraction, seen_retraction);
    }
    return varied;
}

double rms_of_approach(const BothBranches& model, const std::vector<RankedPair>& pairs, double scale) {
    const Places all = all_of(model.size());
    const auto learnt = learn(model, Branch::approach, model.prior(false), all, Scatter(pairs, all, scale).search);
    double squares = 0.0;
    for (Index i = 0; i < model.size(); ++i)
        squares +=
            std::pow(model.measured(Branch::approach)[i] - model.predicted(Branch::approach, i, learnt.known.mean), 2);
    return std::sqrt(squares / static_cast<double>(model.size()));
}

WholeEvidence whole_evidence(const BothBranches& model, const std::vector<RankedPair>& pairs,
                             const ScatterScales& scales, bool with_constant) {
    const Places all = all_of(model.size());
    const Scatter of_approach(pairs, all, scales.approach), of_retraction(pairs, all, scales.retraction);
    const auto on_approach = learn(model, Branch::approach, model.prior(with_constant), all, of_approach.search);
    const auto on_retraction = learn(model, Branch::retraction, on_approach.known, all, of_retraction.search);
    WholeEvidence evidence;
    evidence.work_of_adhesion = model.value_of(BothBranches::work, on_retraction.known);
    evidence.approach_scatter = on_approach.scatter;
    if (!with_constant) return evidence;
    // for each scatter the constant is normal; its tail is a mixture
    const auto& lines = on_retraction.lines;
    const VectorXd with = lines.covariance_with.row(BothBranches::constant).transpose();
    const double prior = on_approach.known.covariance(BothBranches::constant, BothBranches::constant),
                 start = on_approach.known.mean[BothBranches::constant];
    struct Normal {
        double log_weight, mean, deviation;
    };
    std::vector<Normal> mixture;
    adhesion::LogSum total;
    of_retraction.density.visit(lines.covariance, [&](const MarginalScatter::Node& node) {
        const VectorXd whitened = node.factor.matrixL().solve(lines.residual), solved = node.factor.solve(with);
        const double log_weight =
            -0.5 * whitened.squaredNorm() - node.factor.matrixLLT().diagonal().array().log().sum();
        total.add(log_weight);
        mixture.push_back(
            {log_weight, start + solved.dot(lines.residual), std::sqrt(std::max(1e-300, prior - with.dot(solved)))});
    });
    double mean = 0.0, square = 0.0, below = 0.0;
    for (const auto& part : mixture) {
        const double weight = std::exp(part.log_weight - total.value());
        mean += weight * part.mean;
        square += weight * (part.mean * part.mean + part.deviation * part.deviation);
        below += weight * normal_probability(-part.mean / part.deviation);
    }
    const double unit =
        model
            .value_of(BothBranches::constant, {VectorXd::Ones(lines.jacobian.cols()),
                                               MatrixXd::Zero(lines.jacobian.cols(), lines.jacobian.cols())})
            .value;
    evidence.constant = {.value = unit * mean,
                         .standard_error = unit * std::sqrt(std::max(0.0, square - mean * mean)),
                         .method = "posterior"};
    evidence.constant_tail = 2.0 * std::min(below, 1.0 - below);
    return evidence;
}

}  // namespace setae::hysteresis
