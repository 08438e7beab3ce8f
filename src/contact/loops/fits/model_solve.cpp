// SPDX-License-Identifier: GPL-3.0-or-later
#include "model_solve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "fit_support.hpp"
#include "records/channel_noise.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::loops {
namespace {

constexpr Index samples_of_trial = 100;

double range(const Array1D& series) { return series.maxCoeff() - series.minCoeff(); }

/// Noise as given, else from second differences; never below a millionth of the range, so that exact channels can be
/// weighed.
double noise_of(const Array1D& series, double given, const char* name) {
    const double spread = range(series);
    if (!(spread > 0.0))
        throw UndefinedDataError(
            fmt::format("the {} does not change along the branch; a fit needs one that does", name));
    return std::max(given > 0.0 ? given : white_noise(series), 1e-6 * spread);
}

ChannelNoise channel_noise(const BranchData& data, Channels channels) {
    ChannelNoise noise{.force = noise_of(data.force, data.force_noise, "force"), .all_known = data.force_noise > 0.0};
    if (channels != Channels::force_radius) {
        noise.displacement = noise_of(data.displacement, data.displacement_noise, "displacement");
        noise.all_known = noise.all_known && data.displacement_noise > 0.0;
        const double most = 0.99 * noise.force * noise.displacement;
        noise.force_displacement_covariance = std::clamp(data.force_displacement_covariance, -most, most);
    }
    if (channels != Channels::force_displacement) {
        noise.contact_radius = noise_of(data.contact_radius, data.contact_radius_noise, "contact radius");
        noise.all_known = noise.all_known && data.contact_radius_noise > 0.0;
    }
    return noise;
}

void require_options(const ModelFitOptions& options, Channels channels) {
    const bool has_work = options.model != ContactModel::hertz;
    const bool zone = options.model == ContactModel::maugis_dugdale;
    if (options.model == ContactModel::transition) {
        if (channels != Channels::force_radius)
            throw InvalidArgument(
                "the transition equation relates only contact radius and force; choose the channels "
                "force_radius, or the model maugis_dugdale");
        if (options.contact_modulus || options.work_of_adhesion)
            throw InvalidArgument(
                "the transition equation has the parameters a0, Fc and α; E* and W cannot be held fixed; use "
                "maugis_dugdale");
    }
    if (options.errors == FitErrors::force_only && channels == Channels::force_displacement_radius)
        throw InvalidArgument(
            "force_only treats one channel besides force as exact; choose effective_variance for three "
            "channels");
    if (options.work_of_adhesion && !has_work)
        throw InvalidArgument("hertz has no work of adhesion, but one was given");
    if ((options.cohesive_stress || options.transition_parameter) && !zone)
        throw InvalidArgument(
            fmt::format("{} has no cohesive stress, but one was given; use maugis_dugdale", to_string(options.model)));
    if (options.cohesive_stress && options.transition_parameter)
        throw InvalidArgument("both the cohesive stress and the transition parameter are given; give one of them");
    const auto positive = [](const std::optional<double>& value, const char* name) {
        if (value && !(*value > 0.0 && std::isfinite(*value)))
            throw InvalidArgument(fmt::format("{} must be > 0 and finite, got {}", name, *value));
    };
    positive(options.contact_modulus, "contact modulus");
    positive(options.cohesive_stress, "cohesive stress");
    positive(options.transition_parameter, "transition parameter");
    if (zone) positive(options.work_of_adhesion, "work of adhesion of maugis_dugdale");
}

void require_radii(const BranchData& data, const ModelCurve& curve) {
    if (!(data.contact_radius.minCoeff() > 0.0))
        throw InvalidArgument(
            fmt::format("contact radii must be > 0 m along a branch, got {}", data.contact_radius.minCoeff()));
    if (!(data.contact_radius.maxCoeff() < curve.largest_radius()))
        throw InvalidArgument(
            fmt::format("contact radii must stay below {} m, where the model of {} ends, got {} m; leave out those "
                        "samples",
                        curve.largest_radius(), to_string(curve.model()), data.contact_radius.maxCoeff()));
}

/// Values that the search for a start tries for one slot.
std::vector<double> powers_of_ten(double from, double to, double step) {
    std::vector<double> values;
    for (double power = from; power <= to + 1e-9; power += step) values.push_back(std::pow(10.0, power));
    return values;
}

struct Grid {
    std::vector<double> first, second, third;
};

/// Orders of magnitude of each slot: moduli about that of Hertz's contact, adhesion from none to far above the largest
/// force.
Grid grid(const PreparedFit& fit, const BranchData& data) {
    const ModelCurve& curve = fit.problem.curve();
    const double force = force_scale(data), radius = curve.radius();
    const bool bounded = std::isfinite(curve.largest_radius());
    Grid values;
    if (curve.model() == ContactModel::transition) {
        const double typical = data.contact_radius.maxCoeff();
        for (const double share : powers_of_ten(-1.0, 0.5, 0.125)) values.first.push_back(std::log(share * typical));
        for (const double share : powers_of_ten(-3.0, 1.0, 0.25)) values.second.push_back(std::log(share * force));
        values.third = {-3.0, -1.0, 0.0, 1.0, 3.0};
        return values;
    }
    const double dry = fit.problem.has_radius()
                           ? 0.75 * force * radius / std::pow(data.contact_radius.maxCoeff(), 3)
                           : 0.75 * force / (std::sqrt(radius) * std::pow(range(data.displacement), 1.5));
    for (const double factor : powers_of_ten(bounded ? -3.0 : -1.5, 1.5, bounded ? 0.5 : 0.25))
        values.first.push_back(std::log(factor * dry));
    if (curve.model() != ContactModel::maugis_dugdale) values.second.push_back(0.0);
    if (curve.parameters() > 1)
        for (const double share : powers_of_ten(-2.5, 1.5, 0.5))
            values.second.push_back(curve.work_slot(share * force / (1.5 * pi * radius)));
    if (curve.parameters() > 2)
        for (const double lambda : {0.05, 0.2, 0.7, 2.0, 8.0}) values.third.push_back(std::log(lambda));
    else values.third.push_back(0.0);
    return values;
}

/// Coordinates in which a model is closest to linear: E* and √(E*W) for the models with an edge, E* and W for DMT, in
/// units of the start; the slots themselves for the others and where one of the two is fixed.
class Coordinates {
public:
    Coordinates(const PreparedFit& fit, const FitParameters& start)
        : model_(fit.problem.curve().model()),
          start_(start),
          linear_(fit.problem.curve().parameters() == 2 && fit.is_free(0) && fit.is_free(1)),
          edge_unit_(std::max(std::abs(start[1]), min_unit)) {}

    [[nodiscard]] FitParameters from_slots(const FitParameters& slots) const {
        FitParameters at = slots;
        if (!linear_) return at;
        at[0] = std::exp(slots[0] - start_[0]);
        at[1] = slots[1] * (has_edge() ? std::sqrt(at[0]) : 1.0) / edge_unit_;
        return at;
    }
    [[nodiscard]] FitParameters to_slots(const FitParameters& at) const {
        FitParameters slots = at;
        if (!linear_) return slots;
        slots[0] = start_[0] + std::log(at[0]);
        slots[1] = edge_unit_ * at[1] / (has_edge() ? std::sqrt(at[0]) : 1.0);
        return slots;
    }
    /// Turns derivatives by the slots into those by the coordinates.
    void turn(const FitParameters& at, Eigen::MatrixXd& jacobian) const {
        if (!linear_) return;
        const double slot = to_slots(at)[1];
        jacobian.col(0) = (jacobian.col(0) - (has_edge() ? 0.5 * slot : 0.0) * jacobian.col(1)).eval() / at[0];
        jacobian.col(1) *= edge_unit_ / (has_edge() ? std::sqrt(at[0]) : 1.0);
    }

private:
    [[nodiscard]] bool has_edge() const { return model_ != ContactModel::dmt; }

    static constexpr double min_unit = 1e-3;  // starts without adhesion have no unit of their own

    ContactModel model_;
    FitParameters start_;
    bool linear_;
    double edge_unit_;
};

Eigen::VectorXd picked(const PreparedFit& fit, const FitParameters& at) {
    Eigen::VectorXd moved(static_cast<Index>(fit.free.size()));
    for (std::size_t i = 0; i < fit.free.size(); ++i) moved[static_cast<Index>(i)] = at[fit.free[i]];
    return moved;
}

FitParameters merged(const PreparedFit& fit, const FitParameters& start, const Eigen::VectorXd& moved) {
    FitParameters at = start;
    for (std::size_t i = 0; i < fit.free.size(); ++i) at[fit.free[i]] = moved[static_cast<Index>(i)];
    return at;
}

Eigen::MatrixXd picked_columns(const PreparedFit& fit, const Eigen::MatrixXd& all) {
    Eigen::MatrixXd columns(all.rows(), static_cast<Index>(fit.free.size()));
    for (std::size_t i = 0; i < fit.free.size(); ++i) columns.col(static_cast<Index>(i)) = all.col(fit.free[i]);
    return columns;
}

struct Refined {
    FitParameters at;
    LeastSquaresSolution least_squares;  ///< of the free slots
};

Refined least_squares(const PreparedFit& fit, const BranchProblem& problem, const FitParameters& start,
                      int max_iterations) {
    const Coordinates coordinates(fit, start);
    const FitParameters begin = coordinates.from_slots(start);
    const ResidualFunction function{
        .residuals = problem.residuals(),
        .parameters = static_cast<Index>(fit.free.size()),
        .evaluate = [&](const Eigen::VectorXd& moved, Eigen::VectorXd& residuals, Eigen::MatrixXd* jacobian) {
            const FitParameters at = merged(fit, begin, moved), slots = coordinates.to_slots(at);
            if (!drawable(slots)) {
                residuals.setConstant(undefined);
                return;
            }
            Eigen::MatrixXd all;
            problem.evaluate(slots, residuals, jacobian ? &all : nullptr);
            if (!jacobian) return;
            coordinates.turn(at, all);
            *jacobian = picked_columns(fit, all);
        }};
    Refined refined{.at = start, .least_squares = solve_nonlinear(function, picked(fit, begin), max_iterations)};
    refined.at = coordinates.to_slots(merged(fit, begin, refined.least_squares.parameters));
    if (!drawable(refined.at)) return refined;
    Eigen::MatrixXd all;
    problem.evaluate(refined.at, refined.least_squares.residuals, &all);
    refined.least_squares.parameters = picked(fit, refined.at);
    refined.least_squares.uncertainty =
        correlated_covariance(picked_columns(fit, all), refined.least_squares.residuals);
    return refined;
}

}  // namespace

bool PreparedFit::is_free(Index slot) const { return std::find(free.begin(), free.end(), slot) != free.end(); }

void PreparedFit::hold(Index slot, double value) {
    free.erase(std::remove(free.begin(), free.end(), slot), free.end());
    given[slot] = value;
}

bool drawable(const FitParameters& at) { return at.allFinite() && at.cwiseAbs().maxCoeff() < 150.0; }

PreparedFit prepare(const BranchData& data, const LensAndCounterBody& bodies, const ModelFitOptions& options) {
    const Channels channels = options.channels ? *options.channels : channels_of(data);
    const bool displacement = channels != Channels::force_radius, radius = channels != Channels::force_displacement;
    require_options(options, channels);
    ModelCurve curve(options.model, bodies, options.cohesive_stress.has_value());
    const bool fits_point = displacement && !options.contact_point;
    const Index fewest = curve.parameters() + (fits_point ? 1 : 0) + 1;
    require_data(data, bodies,
                 {.contact_radius = radius, .displacement = displacement, .fewest = std::max<Index>(fewest, 3)});
    if (radius) require_radii(data, curve);
    const ChannelNoise noise = channel_noise(data, channels);
    // equal shares of the ranges: weights of exact channels would make the way to the least squares a narrow, bent
    // valley
    ChannelNoise coarse{.force = 0.01 * range(data.force)};
    if (displacement) coarse.displacement = 0.01 * range(data.displacement);
    if (radius) coarse.contact_radius = 0.01 * range(data.contact_radius);
    const FitErrors trial_errors =
        options.errors == FitErrors::force_only ? options.errors : FitErrors::orthogonal_distance;
    PreparedFit fit{.problem = BranchProblem(curve, data, channels, options.errors, noise),
                    .trial = BranchProblem(curve, data, channels, trial_errors, coarse).thinned(samples_of_trial),
                    .noise = noise};
    for (Index slot = 0; slot < curve.parameters(); ++slot) fit.free.push_back(slot);
    if (displacement) fit.free.push_back(contact_point_slot);
    if (options.contact_modulus) fit.hold(0, std::log(*options.contact_modulus));
    if (options.work_of_adhesion) fit.hold(1, curve.work_slot(*options.work_of_adhesion));
    if (options.cohesive_stress) fit.hold(2, std::log(*options.cohesive_stress));
    if (options.transition_parameter) fit.hold(2, std::log(*options.transition_parameter));
    if (displacement && options.contact_point)
        fit.hold(contact_point_slot, fit.problem.contact_point_value(*options.contact_point));
    return fit;
}

FitParameters find_start(const PreparedFit& fit, const BranchData& data) {
    struct Candidate {
        FitParameters at;
        double distance;
    };
    Grid values = grid(fit, data);
    for (const Index slot : {0, 1, 2}) {
        std::vector<double>& tried = slot == 0 ? values.first : slot == 1 ? values.second : values.third;
        if (slot < fit.problem.curve().parameters() && !fit.is_free(slot)) tried = {fit.given[slot]};
    }
    const BranchProblem coarse = fit.trial.thinned(40);
    const bool point_given = fit.problem.has_displacement() && !fit.is_free(contact_point_slot);
    const auto refined = [&](const PreparedFit& moving, const FitParameters& from) {
        const Refined solution = least_squares(moving, fit.trial, from, 50);
        const double cost = solution.least_squares.residuals.squaredNorm();
        return Candidate{solution.at, std::isfinite(cost) ? cost : std::numeric_limits<double>::infinity()};
    };
    const auto by_distance = [](const Candidate& one, const Candidate& other) { return one.distance < other.distance; };
    // the third slot is fixed at each of its values first: with all free, far from the solution, it would diverge
    PreparedFit two_slots = fit;
    std::erase(two_slots.free, Index{2});
    std::vector<Candidate> nearest;
    for (const double third : values.third) {
        std::vector<Candidate> candidates;
        for (const double first : values.first)
            for (const double second : values.second) {
                FitParameters at(first, second, third, fit.given[contact_point_slot]);
                const double distance = coarse.distance(at, point_given);
                if (std::isfinite(distance)) candidates.push_back({at, distance});
            }
        const std::size_t kept = std::min<std::size_t>(candidates.size(), values.third.size() > 1 ? 1 : 3);
        std::partial_sort(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(kept), candidates.end(),
                          by_distance);
        for (std::size_t i = 0; i < kept; ++i) nearest.push_back(refined(two_slots, candidates[i].at));
    }
    std::sort(nearest.begin(), nearest.end(), by_distance);
    if (fit.is_free(2)) {
        // refined for all: force and displacement have two minima in λ, about 0.4 and 0.75, which agree to 1e-5 of the
        // range
        for (Candidate& candidate : nearest) candidate = refined(fit, candidate.at);
        std::sort(nearest.begin(), nearest.end(), by_distance);
    }
    if (nearest.empty() || !std::isfinite(nearest.front().distance)) require_modulus(undefined);
    return nearest.front().at;
}

FitSolution solve(PreparedFit& fit, const FitParameters& start) {
    FitSolution solution{.at = start};
    constexpr int max_rounds = 30;
    int iterations = 0;
    bool settled = false;
    for (int round = 0; round < max_rounds && !settled; ++round) {
        const double change = fit.problem.renew_weights(solution.at);
        if (round > 0 && change < 1e-9) break;
        Refined refined = least_squares(fit, fit.problem, solution.at, 200);
        solution = {.at = refined.at, .least_squares = std::move(refined.least_squares)};
        iterations += solution.least_squares.iterations;
        settled = !fit.problem.weights_change() || !solution.least_squares.converged;
    }
    solution.least_squares.iterations = iterations;
    return solution;
}

}  // namespace setae::loops
