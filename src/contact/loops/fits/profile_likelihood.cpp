// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/profile_likelihood.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <Eigen/Dense>

#include "errors_in_variables/routes.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"

namespace setae::loops {
namespace {

namespace eiv = errors_in_variables;
using eiv::Held;
using eiv::Points;
using eiv::Solution;

/// χ² against one fixed parameter, from one value to the next.
class LikelihoodProfile {
public:
    /// straight: the fitted samples, with the offset of the curvature subtracted. unit: variance in units of which the
    /// rise is given.
    LikelihoodProfile(Points straight, const Solution& best, Held held, double unit)
        : points_(std::move(straight)), best_(best), held_(held), unit_(unit) {
        best_ = eiv::solve_carefully(points_, best.parameters, best.x);
    }

    /// Δχ² with the parameter at a value; NaN where no fit is found.
    [[nodiscard]] double rise(double value) {
        const Solution start = at(value);
        const Solution found = eiv::solve_carefully(points_, start.parameters, start.x, {.held = held_});
        if (!found.converged) return undefined;
        last_ = found;
        return std::max(0.0, (found.squares - best_.squares) / unit_);
    }

    /// From the best fit again.
    void begin() { last_ = best_; }

private:
    /// The last solution with its parameter moved to a value.
    [[nodiscard]] Solution at(double value) const {
        Solution moved = last_;
        double& modulus = moved.parameters[0];
        double& root = moved.parameters[1];
        if (held_ == Held::modulus) {
            // W is kept
            root *= std::sqrt(eiv::reduced_parameters(points_, value, 0.0, 0.0)[0] / modulus);
            modulus = eiv::reduced_parameters(points_, value, 0.0, 0.0)[0];
        } else {
            root = eiv::reduced_parameters(points_, modulus / eiv::reduced_parameters(points_, 1.0, 0.0, 0.0)[0], value,
                                           0.0)[1];
        }
        return moved;
    }

    Points points_;
    Solution best_, last_;
    Held held_;
    double unit_;
};

/// Where the rise crosses the threshold on one side, between multiples of the standard error that bracket it.
std::optional<double> crossing(LikelihoodProfile& profile, double best, double step, double threshold) {
    constexpr double furthest = 10.0;
    constexpr int halvings = 60;
    profile.begin();
    double inside = 0.0, outside = 0.0;
    for (double steps = 0.5; steps <= furthest && outside == 0.0; steps += 0.5) {
        const double rise = profile.rise(best + steps * step);
        if (std::isnan(rise)) return std::nullopt;
        (rise < threshold ? inside : outside) = steps;
    }
    if (outside == 0.0) return std::nullopt;
    for (int i = 0; i < halvings && outside - inside > 1e-6 * outside; ++i) {
        const double middle = 0.5 * (inside + outside), rise = profile.rise(best + middle * step);
        if (std::isnan(rise)) return std::nullopt;
        (rise < threshold ? inside : outside) = middle;
    }
    return best + inside * step;
}

ParameterProfile profiled(LikelihoodProfile profile, Estimate estimate, const ProfileOptions& options) {
    ParameterProfile result{.estimate = estimate};
    const double quantile =
        student_t_quantile(0.5 + 0.5 * options.level, estimate.degrees_of_freedom.value_or(INFINITY));
    result.threshold = quantile * quantile;
    const double best = estimate.value, step = estimate.standard_error;
    const auto lower = crossing(profile, best, -step, result.threshold),
               upper = crossing(profile, best, step, result.threshold);
    result.estimate.method = "profile likelihood";
    result.estimate.interval.reset();
    if (lower && upper) result.estimate.interval = {.lower = *lower, .upper = *upper, .level = options.level};
    const double left = lower ? best - *lower : quantile * step, right = upper ? *upper - best : quantile * step;
    result.values = Array1D::LinSpaced(options.points, best - options.reach * left, best + options.reach * right);
    result.chi2_rise.resize(options.points);
    // outwards from the best fit on each side, each from its neighbour
    const auto middle =
        static_cast<Index>(std::lower_bound(result.values.begin(), result.values.end(), best) - result.values.begin());
    profile.begin();
    for (Index i = middle; i < options.points; ++i) result.chi2_rise[i] = profile.rise(result.values[i]);
    profile.begin();
    for (Index i = middle - 1; i >= 0; --i) result.chi2_rise[i] = profile.rise(result.values[i]);
    return result;
}

void require_valid(const ProfileOptions& options) {
    if (options.points < 3)
        throw InvalidArgument(fmt::format("a profile needs at least 3 points, got {}", options.points));
    if (!(options.level > 0.0 && options.level < 1.0))
        throw InvalidArgument(
            fmt::format("the level of a profile's interval must lie between 0 and 1, got {}", options.level));
    if (!(options.reach > 0.0))
        throw InvalidArgument(fmt::format("the reach of a profile must be > 0, got {}", options.reach));
}

}  // namespace

ProfileLikelihood profile_likelihood(const BranchData& data, const LensAndCounterBody& bodies,
                                     const ProfileOptions& options) {
    require_valid(options);
    const eiv::Route route =
        options.fit == ProfiledFit::effective_variance   ? eiv::effective_variance_route(data, bodies)
        : options.fit == ProfiledFit::force_displacement ? eiv::force_displacement_route(data, bodies)
                                                         : eiv::joint_route(data, bodies);
    const eiv::Fitted& fitted = route.fitted;
    if (!route.fit.covariance.allFinite())
        throw UndefinedDataError(fmt::format("{}: no profile likelihood, the fit has no covariance", route.fit.method));
    const Points straight = eiv::straightened(fitted.points, fitted.solution);
    const Eigen::MatrixXd independent = eiv::independent_covariance(fitted);
    const auto of = [&](Held held, const Estimate& estimate, Index parameter) {
        const double unit = route.fit.covariance(parameter, parameter) / independent(parameter, parameter);
        return profiled(LikelihoodProfile(straight, fitted.solution, held, unit), estimate, options);
    };
    return {.contact_modulus = of(Held::modulus, route.fit.contact_modulus, 0),
            .work_of_adhesion = of(Held::work, route.fit.work_of_adhesion, 1),
            .fit = route.fit};
}

}  // namespace setae::loops
