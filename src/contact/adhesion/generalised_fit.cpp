// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/generalised_fit.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>

#include <fmt/format.h>

#include "model_scatter_fit.hpp"
#include "pair_least_squares.hpp"

namespace setae::adhesion {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

/// The minimum of (y − f(W))ᵀ V⁻¹ (y − f(W)) over W >= 0 next to `start`: with fixed V, another minimum with only
/// floored pairs is meaningless. Between two kinks of the floors the cost is one parabola.
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
        : pairs_(pairs), inputs_(pairs), model_(pairs, {}), work_(least_squares(pairs).x) {}

    void find(bool with_scatter) {
        constexpr int searches = 4;
        for (int search = 0; search < searches; ++search) {
            at_ = inputs_.residuals_at(work_);
            const double height = search == 0 || !with_scatter ? -std::numeric_limits<double>::infinity()
                                                               : model_.restricted_log_likelihood(at_, scatter_);
            if (with_scatter) scatter_ = model_.most_likely(at_, scatter_);
            constexpr double higher = 1e-6;
            if (search > 0 && !(model_.restricted_log_likelihood(at_, scatter_) > height + higher)) break;
            settle(with_scatter);
            if (!with_scatter) break;
        }
        at_ = inputs_.residuals_at(work_);
    }

    void hold(const ModelScatter& scatter) { scatter_ = scatter; }
    [[nodiscard]] bool tells(double ModelScatter::*level) const { return model_.tells(level); }

    /// The scatter at a W that is not fitted, no pair answers to it.
    void find_scatter_at(double work) {
        work_ = work;
        at_ = inputs_.residuals_at(work);
        at_.design.resize(at_.value.size(), 0);
        scatter_ = model_.most_likely(at_, scatter_);
    }

    void look_at(double work, const ModelScatter& scatter) {
        work_ = work;
        scatter_ = scatter;
        at_ = inputs_.residuals_at(work);
    }

    [[nodiscard]] GeneralisedFit result() const {
        GeneralisedFit fit;
        fit.n = static_cast<int>(pairs_.size());
        fit.scatter = scatter_;
        fit.surfaces = groups_of(pairs_, &PairPoint::surface);
        fit.elastomers = groups_of(pairs_, &PairPoint::elastomer);
        const auto spare = [](const auto& of) { return static_cast<double>(of.size()) - 1.0; };
        fit.freedom = {spare(pairs_), spare(fit.surfaces), spare(fit.elastomers)};
        fit.restricted_log_likelihood = model_.restricted_log_likelihood(at_, scatter_);
        fit.log_likelihood = model_.log_likelihood(at_, scatter_);
        std::vector<double> measured;
        for (const auto& pair : pairs_) measured.push_back(pair.measured.value);
        fit.r_squared = 1.0 - at_.value.squaredNorm() / squares_about_mean(measured);
        fit.work_of_adhesion = {work_, model_.components(at_, residual_inputs(pairs_, work_), scatter_, weights())};
        return fit;
    }

private:
    /// W, the scatter on the summit next to where it is, and V to a common answer.
    void settle(bool with_scatter) {
        constexpr int rounds = 100;
        constexpr double settled = 1e-10;
        for (int round = 0; round < rounds; ++round) {
            at_ = inputs_.residuals_at(work_);
            if (with_scatter) scatter_ = model_.nearest_summit(at_, scatter_);
            const double before = work_, found = minimum_of(pairs_, factor_of(model_.covariance(at_, scatter_)), work_);
            // halved steps where a pair at its floor would make W oscillate between two solutions
            work_ = round < rounds / 2 ? found : 0.5 * (before + found);
            if (std::abs(work_ - before) <= settled * std::max(std::abs(work_), std::abs(before))) break;
        }
    }

    /// h = V⁻¹g/(gᵀV⁻¹g); 0 where no pair answers to W.
    [[nodiscard]] VectorXd weights() const {
        if (at_.design.cols() == 0) return VectorXd::Zero(at_.value.size());
        return generalised_weights(at_.design, model_.covariance(at_, scatter_)).transpose();
    }

    const std::vector<PairPoint>& pairs_;
    PairInputs inputs_;
    ScatterFit model_;
    double work_ = 0.0;
    ModelScatter scatter_;
    PairResiduals at_;
};

}  // namespace

Estimate GeneralisedFit::estimate() const { return work_of_adhesion.estimate("generalised least squares"); }

GeneralisedFit fit_generalised(const std::vector<PairPoint>& pairs) {
    require_pairs(pairs);
    Fit fit(pairs);
    fit.find(true);
    return fit.result();
}

GeneralisedFit fit_some_generalised(const std::vector<PairPoint>& pairs, const GeneralisedFit& whole) {
    require_pairs(pairs);
    Fit fit(pairs);
    fit.hold(whole.scatter);
    fit.find(true);
    auto result = fit.result();
    if (!fit.tells(&ModelScatter::surface)) result.freedom.surface = whole.freedom.surface;
    if (!fit.tells(&ModelScatter::elastomer)) result.freedom.elastomer = whole.freedom.elastomer;
    return result;
}

GeneralisedFit fit_generalised(const std::vector<PairPoint>& pairs, const ModelScatter& scatter) {
    require_pairs(pairs);
    Fit fit(pairs);
    fit.hold(scatter);
    fit.find(false);
    return fit.result();
}

GeneralisedFit generalised_at(const std::vector<PairPoint>& pairs, double work_of_adhesion,
                              const ModelScatter& scatter) {
    require_pairs(pairs);
    Fit fit(pairs);
    fit.look_at(work_of_adhesion, scatter);
    return fit.result();
}

GeneralisedFit fit_scatter(const std::vector<PairPoint>& pairs, double work_of_adhesion) {
    require_pairs(pairs);
    Fit fit(pairs);
    fit.find_scatter_at(work_of_adhesion);
    auto result = fit.result();
    result.work_of_adhesion.components.clear();
    result.freedom.pair += 1.0;
    return result;
}

Components departure_from(const GeneralisedFit& fit, const PairPoint& pair, double share) {
    Components result;
    const auto add = [&](const char* between, double size, double freedom, const std::set<std::string>& known,
                         const std::string& group) {
        if (!(size > 0.0)) return;
        auto name = pair.scatter_between(between);
        Component effect{Array1D::Constant(1, -size), freedom};
        if (const auto at = known.find(group); at == known.end()) {
            name += ": " + group;
        } else {
            effect.directions = Array1D::Zero(static_cast<Index>(known.size()));
            effect.directions[std::distance(known.begin(), at)] = -size;
        }
        result.emplace(std::move(name), std::move(effect));
    };
    add("pairs", fit.scatter.pair, fit.freedom.pair, {}, fmt::format("{} × {}", pair.surface, pair.elastomer));
    add("surfaces", share * fit.scatter.surface, fit.freedom.surface, fit.surfaces, pair.surface);
    add("elastomers", share * fit.scatter.elastomer, fit.freedom.elastomer, fit.elastomers, pair.elastomer);
    return result;
}

}  // namespace setae::adhesion
