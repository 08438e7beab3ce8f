// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_point_estimators.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Core>

#include "fits/least_squares.hpp"
#include "records/baseline.hpp"
#include "records/jump.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/loops/spring_jumps.hpp"
#include "setae/numerics/dense.hpp"

namespace setae::loops {
namespace {

using contact::jkr::Contact;

Estimate measured(double value, double standard_error, const char* method) {
    return {.value = value, .standard_error = standard_error, .method = method};
}

double hypotenuse(std::initializer_list<double> parts) {
    double sum = 0.0;
    for (const double part : parts) sum += part * part;
    return std::sqrt(sum);
}

/// A record with one of its contacts.
class Touch {
public:
    explicit Touch(const ContactPointInputs& inputs)
        : in(inputs),
          contact(inputs.segments.contacts[static_cast<std::size_t>(inputs.contact)]),
          noise(inputs.segments.before) {}

    const ContactPointInputs& in;
    const ContactSegments& contact;
    const Baseline& noise;

    [[nodiscard]] double force(Index i) const { return in.loop.force[i]; }
    /// Standard error of the zero of force at a sample [N].
    [[nodiscard]] double zero_error(Index i) const { return in.force_zero.modes.row(i).matrix().norm(); }
    [[nodiscard]] double displacement(Index i) const { return in.loop.displacement[i]; }

    /// Motion from sample to sample in free flight before or after a sample [m].
    [[nodiscard]] double free_step(Index at, Index direction) const {
        constexpr Index most = 40, fewest = 3;
        const auto next = static_cast<std::size_t>(in.contact) + 1;
        const auto& contacts = in.segments.contacts;
        const Index last = next < contacts.size()
                               ? (contacts[next].jump_in ? contacts[next].jump_in->first : contacts[next].loading.first)
                               : in.loop.force.size() - 1;
        const Index end = direction < 0 ? std::max(at - most, contact.extent.first) : std::min(at + most, last);
        const Index n = std::abs(end - at);
        if (n < fewest)
            throw UndefinedDataError(
                "the free flight next to the jump is too short to give the motion from sample to sample");
        return (displacement(end) - displacement(at)) / static_cast<double>(end - at);
    }

    /// The sample before a jump in the given section: between two frames where the camera records each sample, else at
    /// the largest step of the force. @throws UndefinedDataError for one that does not exceed the noise.
    [[nodiscard]] Index before_jump(const IndexRange& stretch, bool into_contact) const {
        const Array1D& radius = in.loop.contact_radius;
        const auto touching = [&](Index i) { return radius[i] > 0.0; };
        const auto apart = [&](Index i) { return radius[i] == 0.0; };
        if (radius.size() > 0)
            for (Index i = stretch.first; i < stretch.last; ++i)
                if (into_contact ? apart(i) && touching(i + 1) : touching(i) && apart(i + 1)) return i;
        constexpr double clear = 8.0;  // many steps are looked at
        const Index at = largest_step(in.loop.force, stretch);
        if (at < stretch.last && std::abs(force(at + 1) - force(at)) > clear * noise.force_noise) return at;
        throw UndefinedDataError(
            fmt::format("the jump {} contact does not exceed the noise", into_contact ? "into" : "out of"));
    }
    [[nodiscard]] Index before_jump_in() const {
        if (!contact.jump_in && in.loop.contact_radius.size() == 0)
            throw UndefinedDataError("the record has no jump into contact");
        // the minimum of noisy forces may be after the jump
        return before_jump({contact.extent.first, contact.jump_in ? contact.jump_in->last : contact.loading.first},
                           true);
    }
    [[nodiscard]] Index before_jump_out() const {
        if (!contact.pull_off) throw UndefinedDataError("the record does not contain the pull-off");
        return before_jump(*contact.pull_off, false);
    }

    /// Compliance 1/k of the testing machine [m/N]: given, else from the jump out, in which the stage continues as in
    /// free flight.
    [[nodiscard]] Estimate compliance() const {
        if (in.machine_stiffness) return measured(1.0 / *in.machine_stiffness, 0.0, "given");
        const Index at = before_jump_out();
        const double rise = force(at + 1) - force(at), moved = displacement(at + 1) - displacement(at);
        constexpr double clear = 3.0;
        if (!(rise > clear * noise.force_noise))
            throw UndefinedDataError(
                "the jump out of contact is too small to give the stiffness of the testing machine");
        const double value = (free_step(at + 1, 1) - moved) / rise;
        // a compliance below the noise of the jump's ends is treated as rigid
        return measured(std::max(value, 0.0),
                        std::sqrt(2.0) * std::hypot(noise.displacement_noise, value * noise.force_noise) / rise,
                        "jump out");
    }
};

/// @throws UndefinedDataError where adhesion exceeds the noise: no power law begins at the contact point then.
void require_repulsion(const Touch& touch, double radius) {
    if (touch.contact.jump_in)
        throw UndefinedDataError(
            "this estimator fits a power law without adhesion, and the approach jumps into contact");
    const double largest = touch.force(touch.contact.loading.last);
    if (touch.in.loop.contact_radius.size() > 0) {
        // the camera shows contact in samples whose force cannot be distinguished from free flight: tests for tension
        constexpr double clear = 3.0, sure = 2.0;
        double sum = 0.0, n = 0.0;
        for (Index i = touch.contact.loading.first;
             i < touch.contact.loading.last && touch.force(i) <= clear * touch.noise.force_noise; ++i, ++n)
            sum += touch.force(i);
        if (n > 0.0 && sum < -sure * touch.noise.force_noise * std::sqrt(n))
            throw UndefinedDataError(
                "this estimator fits a power law without adhesion, and the force is below its zero at the "
                "beginning of contact");
    }
    if (!touch.in.force_displacement) return;
    const double attraction = 1.5 * pi * radius * touch.in.force_displacement->work_of_adhesion.value;
    constexpr double rounding = 1e-4;
    if (attraction > std::max(touch.noise.force_noise, rounding * largest))
        throw UndefinedDataError(
            fmt::format("this estimator fits a power law without adhesion, and adhesion pulls by {:.2g} N, more than "
                        "the noise",
                        attraction));
}

/// Straight line through F^(2/3), which is linear in depth for Hertz's force, from where the force exceeds its noise.
Estimate first_touch(const Touch& touch, double radius) {
    require_repulsion(touch, radius);
    const double largest = touch.force(touch.contact.loading.last);
    constexpr double clear = 5.0, share_min = 1e-3, share_max = 0.25;
    const double least = std::max(clear * touch.noise.force_noise, share_min * largest),
                 most = std::max(share_max * largest, 4.0 * least);
    std::vector<Index> samples;
    Index first = touch.contact.loading.last;
    while (first > touch.contact.extent.first && touch.force(first - 1) > least) --first;
    for (Index i = first; i <= touch.contact.loading.last && touch.force(i) < most; ++i) samples.push_back(i);
    const auto n = static_cast<Index>(samples.size());
    constexpr Index fewest = 5;
    if (n < fewest)
        throw UndefinedDataError(
            fmt::format("{} samples lie between first touch and {:.2g} N; expected at least {}", n, most, fewest));
    const double origin = touch.displacement(first);
    Eigen::MatrixXd design(n, 2);
    Eigen::VectorXd values(n);
    for (Index k = 0; k < n; ++k) {
        const Index i = samples[static_cast<std::size_t>(k)];
        const double power = std::pow(touch.force(i), 2.0 / 3.0);
        const double weight = std::sqrt(power);  // σ of F^(2/3) goes as F^(−1/3)
        design.row(k) << weight * (touch.displacement(i) - origin), weight;
        values[k] = weight * power;
    }
    const LeastSquaresSolution line = solve_linear(design, values);
    const double slope = line.parameters[0], level = line.parameters[1];
    if (!(slope > 0.0)) throw UndefinedDataError("the force does not rise after first touch");
    const Eigen::Vector2d by(level / (slope * slope), -1.0 / slope);
    // an error of the zero of force shifts F^(2/3) of the samples by 2/3 F^(−1/3) of it
    const double zero = touch.zero_error(first) * 2.0 / 3.0 / (std::cbrt(least) * slope);
    return measured(origin - level / slope, std::hypot(std::sqrt(by.dot(line.uncertainty.covariance * by)), zero),
                    "F^(2/3) extrapolated to 0");
}

Estimate force_departure(const Touch& touch, double radius) {
    if (!touch.contact.jump_in) return first_touch(touch, radius);
    constexpr double clear = 3.0;
    Index last_free = touch.before_jump(*touch.contact.jump_in, true);
    while (last_free > touch.contact.extent.first && touch.force(last_free) < -clear * touch.noise.force_noise)
        --last_free;
    const double step = touch.free_step(last_free, -1);
    return measured(touch.displacement(last_free) + 0.5 * step,
                    std::hypot(step / std::sqrt(12.0), touch.noise.displacement_noise),
                    "middle of the step of the jump");
}

Estimate broken_line(const Touch& touch, double radius) {
    const Estimate start = first_touch(touch, radius);
    const Index last = touch.contact.loading.last, first = touch.contact.extent.first;
    const Index n = last - first + 1;
    const double depth_unit = touch.displacement(last) - start.value, force_unit = touch.force(last);
    const Array1D depth = (touch.in.loop.displacement.segment(first, n) - start.value) / depth_unit;
    const Array1D force = touch.in.loop.force.segment(first, n) / force_unit;
    const double force_noise = touch.noise.force_noise / force_unit,
                 depth_noise = touch.noise.displacement_noise / depth_unit;
    Array1D weight = Array1D::Ones(n);
    if (force_noise > 0.0)
        weight = force_noise / (force_noise * force_noise + 2.25 * depth.max(0.0) * depth_noise * depth_noise).sqrt();
    const LeastSquaresSolution solution = solve_nonlinear(
        {.residuals = n,
         .parameters = 3,
         .evaluate =
             [&](const Eigen::VectorXd& at, Eigen::VectorXd& residuals, Eigen::MatrixXd* jacobian) {
                 for (Index i = 0; i < n; ++i) {
                     const double d = std::max(depth[i] - at[2], 0.0), root = std::sqrt(d);
                     residuals[i] = weight[i] * (force[i] - at[0] - at[1] * d * root);
                     if (jacobian)
                         jacobian->row(i) << -weight[i], -weight[i] * d * root, weight[i] * 1.5 * at[1] * root;
                 }
             }},
        Eigen::Vector3d(0.0, 1.0, 0.0));
    if (!solution.converged) throw UndefinedDataError("the fit of the broken line did not converge");
    return measured(start.value + depth_unit * solution.parameters[2],
                    depth_unit * std::sqrt(solution.uncertainty.covariance(2, 2)), "least squares");
}

Estimate behind_jump_in(const Touch& touch) {
    const Index last_free = touch.before_jump_in(), behind = last_free + 1;
    const double step = touch.free_step(last_free, -1);
    const Estimate compliance = touch.compliance();
    const double stage = touch.displacement(behind) + compliance.value * touch.force(behind);
    const double error =
        hypotenuse({step / std::sqrt(12.0), touch.noise.displacement_noise, compliance.value * touch.noise.force_noise,
                    touch.force(behind) * compliance.standard_error});
    return measured(stage - 0.5 * step, error, "line of the testing machine through the first sample after the jump");
}

/// A quadratic through samples: its value and slope at a position, and the standard error of the value.
struct Parabola {
    LeastSquaresSolution solution;
    double origin, unit;

    Parabola(const Array1D& x, const Array1D& y) : origin(x.mean()), unit((x - x.mean()).abs().maxCoeff()) {
        const Array1D u = (x - origin) / unit;
        Eigen::MatrixXd design(x.size(), 3);
        design << Array1D::Ones(x.size()), u, u.square();
        solution = solve_linear(design, y);
    }
    [[nodiscard]] Eigen::Vector3d row(double x) const {
        const double u = (x - origin) / unit;
        return {1.0, u, u * u};
    }
    [[nodiscard]] double at(double x) const { return row(x).dot(solution.parameters.head<3>()); }
    [[nodiscard]] double slope(double x) const {
        return (solution.parameters[1] + 2.0 * solution.parameters[2] * (x - origin) / unit) / unit;
    }
    [[nodiscard]] double error(double x) const {
        return std::sqrt(row(x).dot(solution.uncertainty.covariance * row(x)));
    }
};

/// Samples of the branch around where its force passes zero.
IndexRange around_zero(const BranchData& data, double noise) {
    constexpr double share = 0.15, clear = 3.0;
    constexpr Index fewest = 8;
    const double window = std::max(share * (data.force.maxCoeff() - data.force.minCoeff()), clear * noise);
    IndexRange range{0, data.force.size() - 1};
    while (range.first < range.last && data.force[range.first] < -window) ++range.first;
    while (range.last > range.first && data.force[range.last] > window) --range.last;
    constexpr Index ends = 3;
    const bool passes = range.count() >= fewest && data.force.segment(range.first, ends).mean() < 0.0 &&
                        data.force.segment(range.last - ends + 1, ends).mean() > 0.0;
    if (!passes)
        throw UndefinedDataError(
            "the force of the loading fit does not pass through zero, or has too few samples there");
    return range;
}

/// a²/(3R) at F = 0 from W/E*, a³ = 9πWR²/(2E*).
Estimate zero_load_depth(const JkrFit& fit, double radius) {
    const double W = fit.work_of_adhesion.value, E = fit.contact_modulus.value;
    if (!(W > 0.0)) throw UndefinedDataError("the loading fit has no adhesion: F = 0 is first touch itself");
    const double a = std::cbrt(4.5 * pi * W * radius * radius / E), depth = a * a / (3.0 * radius);
    const double relative =
        fit.covariance(1, 1) / (W * W) + fit.covariance(0, 0) / (E * E) - 2.0 * fit.covariance(0, 1) / (W * E);
    return measured(depth, 2.0 / 3.0 * depth * std::sqrt(std::max(relative, 0.0)), "jkr");
}

Estimate from_zero_force(const Touch& touch, double radius) {
    const BranchData& data = touch.in.loading;
    const IndexRange range = around_zero(data, touch.noise.force_noise);
    const Array1D depth = data.displacement.segment(range.first, range.count());
    const Parabola force(depth, data.force.segment(range.first, range.count()));
    double at = depth.mean();
    constexpr int rounds = 20;
    for (int i = 0; i < rounds; ++i) at -= force.at(at) / force.slope(at);
    if (!(at >= depth.minCoeff() && at <= depth.maxCoeff() && force.slope(at) > 0.0))
        throw UndefinedDataError("the force has no zero between the samples on both sides of zero");
    const double zero_error =
        hypotenuse({force.error(at), touch.zero_error(touch.contact.loading.first)}) / force.slope(at);
    if (data.contact_radius.size() > 0) {
        const Parabola radii(depth, data.contact_radius.segment(range.first, range.count()));
        const double a = radii.at(at), by_radius = 2.0 * a / (3.0 * radius);
        // a zero found too deep has a larger radius, too: 0.6 of its error is left in a jkr contact
        return measured(at - a * a / (3.0 * radius),
                        std::hypot(zero_error * (1.0 - by_radius * radii.slope(at)), by_radius * radii.error(at)),
                        "measured radius at F = 0");
    }
    if (!touch.in.force_displacement)
        throw UndefinedDataError("neither a measured contact radius nor a fit gives the contact radius at F = 0");
    const Estimate below = zero_load_depth(*touch.in.force_displacement, radius);
    return measured(at - below.value, std::hypot(zero_error, below.standard_error), "jkr radius at F = 0");
}

/// Stage position δ + F/k of a contact at its instability, relative to first contact.
double stage_at_instability(double modulus, double work, double radius, double compliance) {
    const auto state =
        spring_jumps({radius, modulus, work}, compliance > 0.0 ? 1.0 / compliance : INFINITY).before_jump_out;
    return state.displacement + compliance * state.force;
}

Estimate from_pull_off(const Touch& touch, double radius) {
    const Index free = touch.before_jump_out() + 1;
    if (!touch.in.unloading)
        throw UndefinedDataError("the retraction has no fit, whose W and E* would give the displacement at separation");
    const JkrFit& fit = *touch.in.unloading;
    const double W = fit.work_of_adhesion.value, E = fit.contact_modulus.value;
    if (!(W > 0.0)) throw UndefinedDataError("the fit of the retraction has no adhesion, hence no jump out of contact");
    const Estimate compliance = touch.compliance();
    // free of force, the displacement is the stage's
    const double step = touch.free_step(free, 1), stage = touch.displacement(free) - 0.5 * step;
    constexpr double small = 1e-3;
    const auto separation = [&](double modulus, double work, double soft) {
        return stage_at_instability(modulus, work, radius, soft);
    };
    const double here = separation(E, W, compliance.value);
    const double by_modulus = (separation((1.0 + small) * E, W, compliance.value) - here) / (small * E);
    const double by_work = (separation(E, (1.0 + small) * W, compliance.value) - here) / (small * W);
    const double by_compliance = separation(E, W, compliance.value + compliance.standard_error) - here;
    const double fitted = by_modulus * by_modulus * fit.covariance(0, 0) + by_work * by_work * fit.covariance(1, 1) +
                          2.0 * by_modulus * by_work * fit.covariance(0, 1);
    return measured(stage - here,
                    hypotenuse({step / std::sqrt(12.0), touch.noise.displacement_noise, by_compliance,
                                std::sqrt(std::max(fitted, 0.0))}),
                    "instability of the fit of the retraction");
}

/// F = 2aE* (δ − a²/(3R)) − 2aE* δ0 in force, where noise of the force is the same everywhere; weighed by the noise of
/// displacement and contact radius, too.
Estimate without_work(const Touch& touch, double radius) {
    if (!touch.in.pointwise) throw UndefinedDataError(touch.in.pointwise.reason);
    const BranchData& data = touch.in.loading;
    const Array1D& a = data.contact_radius;
    const double origin = data.displacement[0];
    const Array1D depth = data.displacement - origin;
    Array1D weight = Array1D::Ones(a.size());
    double modulus = touch.in.pointwise->contact_modulus.value, zero = touch.in.pointwise->contact_point.value - origin;
    double by_zero_of_force = 0.0;
    LeastSquaresSolution solution;
    constexpr int rounds = 2;
    for (int round = 0; round < rounds; ++round) {
        const Array1D by_depth = 2.0 * modulus * a, by_radius = 2.0 * modulus * (depth - zero - a.square() / radius);
        const Array1D variance =
            (by_depth * data.displacement_noise).square() + (by_radius * data.contact_radius_noise).square() +
            data.force_noise * data.force_noise - 2.0 * by_depth * data.force_displacement_covariance;
        if (variance.minCoeff() > 0.0) weight = (variance.mean() / variance).sqrt();
        Eigen::MatrixXd design(a.size(), 2);
        design << 2.0 * weight * a * (depth - a.square() / (3.0 * radius)), -2.0 * weight * a;
        solution = solve_linear(design, weight * data.force);
        modulus = solution.parameters[0];
        zero = solution.parameters[1] / modulus;
        double squares = 0.0;
        for (Index mode = 0; mode < data.force_zero_modes.cols(); ++mode) {
            const Eigen::Vector2d shift = numerics::least_squares(design, weight * data.force_zero_modes.col(mode));
            squares += std::pow((shift[1] - zero * shift[0]) / modulus, 2);
        }
        by_zero_of_force = std::sqrt(squares);
    }
    const Eigen::Vector2d by(-zero / modulus, 1.0 / modulus);
    return measured(origin + zero,
                    std::hypot(std::sqrt(by.dot(solution.uncertainty.covariance * by)), by_zero_of_force),
                    "weighted least squares in force");
}

}  // namespace

Estimate estimated_contact_point(ContactPointMethod method, const ContactPointInputs& inputs,
                                 const LensAndCounterBody& bodies) {
    const Touch touch(inputs);
    switch (method) {
        case ContactPointMethod::force_departure: return force_departure(touch, bodies.radius);
        case ContactPointMethod::broken_line: return broken_line(touch, bodies.radius);
        case ContactPointMethod::jump_in: return behind_jump_in(touch);
        case ContactPointMethod::force_displacement:
            if (!inputs.force_displacement) throw UndefinedDataError(inputs.force_displacement.reason);
            return inputs.force_displacement->contact_point;
        case ContactPointMethod::pointwise: return without_work(touch, bodies.radius);
        case ContactPointMethod::zero_force: return from_zero_force(touch, bodies.radius);
        case ContactPointMethod::pull_off: return from_pull_off(touch, bodies.radius);
    }
    throw InternalError("unknown contact point method");
}

}  // namespace setae::loops
