// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/generalised_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>
#include <boost/math/tools/minima.hpp>
#include <Eigen/Cholesky>

#include "generalised_weights.hpp"
#include "pair_least_squares.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::adhesion {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;
using Label = std::string PairPoint::*;

/// One where both pairs have the same label.
MatrixXd alike(const std::vector<PairPoint>& pairs, Label label) {
    const auto n = static_cast<Index>(pairs.size());
    MatrixXd result(n, n);
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j)
            result(i, j) =
                pairs[static_cast<std::size_t>(i)].*label == pairs[static_cast<std::size_t>(j)].*label ? 1.0 : 0.0;
    return result;
}

/// Pairs by a label.
std::map<std::string, int> counts_of(const std::vector<PairPoint>& pairs, Label label) {
    std::map<std::string, int> counts;
    for (const auto& pair : pairs) ++counts[pair.*label];
    return counts;
}

double freedom_of(const std::vector<PairPoint>& pairs, Label label) {
    return static_cast<double>(counts_of(pairs, label).size()) - 1.0;
}

/// Whether effects of a label can be told from those of pairs: three of them, and one with several pairs.
bool separable(const std::vector<PairPoint>& pairs, Label label) {
    const auto counts = counts_of(pairs, label);
    return counts.size() >= 3 &&
           std::any_of(counts.begin(), counts.end(), [](const auto& entry) { return entry.second > 1; });
}

/// What is known of y − f beside the scatter, at one W.
struct Residuals {
    VectorXd value, slope;  ///< y − f, ∂f/∂W
    VectorXd share;         ///< of an error of the balance that its floor lets through
    std::vector<Components> inputs;
    MatrixXd covariance;  ///< of own noise and inputs
};

Residuals residuals_at(const std::vector<PairPoint>& pairs, double work) {
    const auto n = static_cast<Index>(pairs.size());
    Residuals result{VectorXd(n), VectorXd(n), VectorXd(n), {}, {}};
    for (Index i = 0; i < n; ++i) {
        const auto& pair = pairs[static_cast<std::size_t>(i)];
        result.value[i] = pair.measured.value - pair.prediction(work);
        result.slope[i] = !pair.floored || pair.raw_prediction(work) > 0.0 ? pair.slope : 0.0;
        result.share[i] = share_through_floor(pair, work);
        result.inputs.push_back(residual_inputs(pair, work));
    }
    result.covariance = residual_covariance(pairs, result.inputs);
    return result;
}

Eigen::LLT<MatrixXd> factor_of(const MatrixXd& covariance) {
    Eigen::LLT<MatrixXd> factor(covariance);
    if (factor.info() != Eigen::Success)
        throw UndefinedDataError("the covariance of the pairs is not positive definite");
    return factor;
}

/// The minimum of (y − f(W))ᵀ V⁻¹ (y − f(W)) over W >= 0 that lies next to `start`: with V held, another valley, of
/// floored pairs alone, says nothing. Within a piece between two kinks of the floors the cost is one parabola.
double minimum_of(const std::vector<PairPoint>& pairs, const Eigen::LLT<MatrixXd>& factor, double start) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto n = static_cast<Index>(pairs.size());
    double work = start;
    for (std::size_t step = 0; step <= pairs.size(); ++step) {
        VectorXd slope(n), constant(n);
        double from = 0.0, to = infinity;  // the piece that holds W
        for (Index i = 0; i < n; ++i) {
            const auto& pair = pairs[static_cast<std::size_t>(i)];
            const double kink = pair.offset / pair.slope;
            const bool above = !pair.floored || work >= kink;
            if (pair.floored && above) from = std::max(from, kink);
            if (!above) to = std::min(to, kink);
            slope[i] = above ? pair.slope : 0.0;
            constant[i] = pair.measured.value + (above ? pair.offset : 0.0);
        }
        const VectorXd weighted = factor.solve(slope);
        const double information = slope.dot(weighted);
        if (!(information > 0.0)) return work;
        const double found = weighted.dot(constant) / information;
        if (found >= from && found <= to) return found;
        // on into the next piece, or back to the kink where both sides lead
        const double end = found < from ? std::nextafter(from, -infinity) : to;
        if (end < 0.0 || (step > 0 && end == start)) return std::max(0.0, end);
        start = work;
        work = end;
    }
    return work;
}

class Fit {
public:
    explicit Fit(const std::vector<PairPoint>& pairs)
        : pairs_(pairs),
          same_surface_(alike(pairs, &PairPoint::surface)),
          same_elastomer_(alike(pairs, &PairPoint::elastomer)),
          with_surfaces_(separable(pairs, &PairPoint::surface)),
          with_elastomers_(separable(pairs, &PairPoint::elastomer)) {
        for (const auto& pair : pairs) largest_ = std::max(largest_, std::abs(pair.measured.value));
        work_ = least_squares(pairs).x;
    }

    void find(bool with_scatter) {
        constexpr int rounds = 100;
        constexpr double settled = 1e-10;
        for (int round = 0; round < rounds; ++round) {
            at_ = residuals_at(pairs_, work_);
            if (with_scatter) estimate_scatter();
            const double before = work_, found = minimum_of(pairs_, factor_of(whole_covariance(scatter_)), work_);
            // halved steps where a pair at its floor would make W swing between two answers
            work_ = round < rounds / 2 ? found : 0.5 * (before + found);
            if (std::abs(work_ - before) <= settled * std::max(std::abs(work_), std::abs(before))) break;
        }
        at_ = residuals_at(pairs_, work_);
    }

    void hold(const ModelScatter& scatter) { scatter_ = scatter; }

    /// h at a W and a scatter.
    [[nodiscard]] VectorXd weights_at(double work, const ModelScatter& scatter) {
        work_ = work;
        scatter_ = scatter;
        at_ = residuals_at(pairs_, work);
        return weights();
    }

    [[nodiscard]] GeneralisedFit result() const {
        GeneralisedFit fit;
        fit.n = static_cast<int>(pairs_.size());
        fit.scatter = scatter_;
        fit.freedom = {static_cast<double>(pairs_.size()) - 1.0, freedom_of(pairs_, &PairPoint::surface),
                       freedom_of(pairs_, &PairPoint::elastomer)};
        fit.restricted_log_likelihood = restricted_log_likelihood(scatter_);
        fit.log_likelihood = log_likelihood();
        std::vector<double> measured;
        for (const auto& pair : pairs_) measured.push_back(pair.measured.value);
        fit.r_squared = 1.0 - at_.value.squaredNorm() / squares_about_mean(measured);
        fit.work_of_adhesion = {work_, components()};
        return fit;
    }

private:
    [[nodiscard]] MatrixXd whole_covariance(const ModelScatter& scatter) const {
        const MatrixXd effects = scatter.surface * scatter.surface * same_surface_ +
                                 scatter.elastomer * scatter.elastomer * same_elastomer_;
        MatrixXd whole = at_.covariance + at_.share.asDiagonal() * effects * at_.share.asDiagonal();
        // where nothing is uncertain every pair counts alike
        const double least = 1e-9 * largest_;
        whole.diagonal().array() += std::max(scatter.pair * scatter.pair, least * least);
        return whole;
    }

    [[nodiscard]] double restricted_log_likelihood(const ModelScatter& scatter) const {
        const Eigen::LLT<MatrixXd> factor(whole_covariance(scatter));
        if (factor.info() != Eigen::Success) return -std::numeric_limits<double>::infinity();
        const VectorXd weighted = factor.solve(at_.value), direction = factor.solve(at_.slope);
        const double information = at_.slope.dot(direction);
        double log_likelihood = -factor.matrixLLT().diagonal().array().log().sum() - 0.5 * at_.value.dot(weighted);
        if (information > 0.0)
            log_likelihood +=
                0.5 * std::pow(at_.slope.dot(weighted), 2) / information - 0.5 * std::log(information);
        return log_likelihood;
    }

    /// −½ (rᵀV⁻¹r + ln|V| + n ln 2π).
    [[nodiscard]] double log_likelihood() const {
        const auto factor = factor_of(whole_covariance(scatter_));
        return -0.5 * at_.value.dot(factor.solve(at_.value)) - factor.matrixLLT().diagonal().array().log().sum() -
               0.5 * static_cast<double>(pairs_.size()) * std::log(2.0 * pi);
    }

    /// Each of the three in turn, until none moves.
    void estimate_scatter() {
        constexpr int sweeps = 30, bits = 26;
        const double reach = 3.0 * std::sqrt(at_.value.squaredNorm() / static_cast<double>(pairs_.size() - 1));
        if (!(reach > 0.0)) {
            scatter_ = {};
            return;
        }
        std::vector<double ModelScatter::*> levels{&ModelScatter::pair};
        if (with_surfaces_) levels.push_back(&ModelScatter::surface);
        if (with_elastomers_) levels.push_back(&ModelScatter::elastomer);
        for (int sweep = 0; sweep < sweeps; ++sweep) {
            double moved = 0.0;
            for (const auto level : levels) {
                const auto loss = [&](double value) {
                    auto tried = scatter_;
                    tried.*level = value;
                    return -restricted_log_likelihood(tried);
                };
                auto best = boost::math::tools::brent_find_minima(loss, 0.0, reach, bits);
                if (loss(0.0) <= best.second) best.first = 0.0;
                moved = std::max(moved, std::abs(best.first - scatter_.*level));
                scatter_.*level = best.first;
            }
            if (moved < 1e-5 * reach) return;
        }
    }

    /// h = V⁻¹g/(gᵀV⁻¹g); 0 where no pair answers to W.
    [[nodiscard]] VectorXd weights() const {
        const VectorXd direction = factor_of(whole_covariance(scatter_)).solve(at_.slope);
        const double information = at_.slope.dot(direction);
        return information > 0.0 ? VectorXd(direction / information) : VectorXd::Zero(direction.size());
    }

    [[nodiscard]] Components components() const {
        const VectorXd h = weights();
        std::vector<Dependence> parts;
        for (std::size_t i = 0; i < pairs_.size(); ++i)
            parts.push_back({h[static_cast<Index>(i)], at_.inputs[i]});
        auto result = combined(parts);
        for (std::size_t i = 0; i < pairs_.size(); ++i)
            if (pairs_[i].own_variance() > 0.0)
                result[pairs_[i].own_noise()] = own_noise(pairs_[i], h[static_cast<Index>(i)]);
        add_scatter(result, h);
        return result;
    }

    void add_scatter(Components& result, const VectorXd& h) const {
        if (scatter_.pair > 0.0)
            result[pairs_.front().scatter_between("pairs")] = {scatter_.pair * h.array(),
                                                               static_cast<double>(pairs_.size()) - 1.0};
        const auto add = [&](const char* groups, double scatter, Label label) {
            if (!(scatter > 0.0)) return;
            std::map<std::string, double> sums;
            for (std::size_t i = 0; i < pairs_.size(); ++i)
                sums[pairs_[i].*label] += h[static_cast<Index>(i)] * at_.share[static_cast<Index>(i)];
            Component component{Array1D(static_cast<Index>(sums.size())), static_cast<double>(sums.size()) - 1.0};
            Index at = 0;
            for (const auto& [group, sum] : sums) component.directions[at++] = scatter * sum;
            result[pairs_.front().scatter_between(groups)] = std::move(component);
        };
        add("surfaces", scatter_.surface, &PairPoint::surface);
        add("elastomers", scatter_.elastomer, &PairPoint::elastomer);
    }

    const std::vector<PairPoint>& pairs_;
    MatrixXd same_surface_, same_elastomer_;
    bool with_surfaces_, with_elastomers_;
    double largest_ = 0.0;
    double work_ = 0.0;
    ModelScatter scatter_;
    Residuals at_;
};

}  // namespace

Estimate GeneralisedFit::estimate() const {
    auto result = work_of_adhesion.estimate("generalised least squares");
    if (!drawn_interval) return result;
    result.interval = drawn_interval;
    result.method += ", interval by draws";
    return result;
}

GeneralisedWeights::GeneralisedWeights(const std::vector<PairPoint>& pairs, const GeneralisedFit& fit)
    : weights_(Fit(pairs).weights_at(fit.work_of_adhesion.value, fit.scatter)), work_(fit.work_of_adhesion.value) {}

double GeneralisedWeights::work_of(const std::vector<PairPoint>& pairs) const {
    double work = work_;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        work += weights_[static_cast<Index>(i)] * (pairs[i].measured.value - pairs[i].prediction(work_));
    return std::max(0.0, work);
}

GeneralisedFit fit_generalised(const std::vector<PairPoint>& pairs) {
    require_pairs(pairs);
    Fit fit(pairs);
    fit.find(true);
    return fit.result();
}

GeneralisedFit fit_generalised(const std::vector<PairPoint>& pairs, const ModelScatter& scatter) {
    require_pairs(pairs);
    Fit fit(pairs);
    fit.hold(scatter);
    fit.find(false);
    return fit.result();
}

}  // namespace setae::adhesion
