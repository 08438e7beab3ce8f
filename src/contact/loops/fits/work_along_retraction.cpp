// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/work_along_retraction.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Cholesky>

#include "fit_support.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/contact/jkr_curve.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/loops/spring_jumps.hpp"
#include "setae/numerics/bracketing.hpp"

namespace setae::loops {
namespace {

/// W_ret(a) between two radii, by its values there.
struct Line {
    double smallest_radius = 0.0, largest_radius = 0.0;
    double at_pull_off = 0.0, at_largest_contact = 0.0;

    [[nodiscard]] double slope() const {
        return (at_largest_contact - at_pull_off) / (largest_radius - smallest_radius);
    }
    [[nodiscard]] double operator()(double a) const { return at_pull_off + slope() * (a - smallest_radius); }
    /// ∫ W_ret dA from radius a to the largest contact [J].
    [[nodiscard]] double work_beyond(double a) const {
        const double b = largest_radius;
        return pi * (at_pull_off - slope() * smallest_radius) * (b * b - a * a) +
               2.0 / 3.0 * pi * slope() * (b * b * b - a * a * a);
    }
};

/// A retraction along a line, with given W_app and E*.
struct Retraction {
    const RetractionCourse& course;
    double contact_modulus = 0.0, work_approach = 0.0;

    [[nodiscard]] contact::jkr::Contact contact_at(double a, const Line& line) const {
        return {course.radius, contact_modulus, std::max(0.0, line(a))};
    }
    /// Position of the motor: δ + F/k.
    [[nodiscard]] double stage(double a, const Line& line) const {
        const auto contact = contact_at(a, line);
        return contact::jkr::displacement(a, contact) + contact::jkr::force(a, contact) / course.machine_stiffness;
    }
    /// The radius below which the stage would have to turn back.
    [[nodiscard]] double separation_radius(const Line& line) const {
        constexpr int steps = 400, rounds = 40;
        const double a_max = line.largest_radius, step = a_max / steps;
        for (int i = 1; i < steps; ++i) {
            const double a = a_max - step * i;
            if (!(line(a) > 0.0)) break;
            if (stage(a - step, line) > stage(a, line) || i + 1 == steps)
                return numerics::golden_section([&](double x) { return stage(x, line); },
                                                std::max(a - step, 0.1 * step), std::min(a + step, a_max), rounds);
        }
        throw UndefinedDataError("the line of W_ret falls to 0 before the contact separates");
    }
    /// ∮F dδ [J].
    [[nodiscard]] double energy_loss(const Line& line) const {
        const double R = course.radius, E = contact_modulus, k = course.machine_stiffness, a = separation_radius(line);
        const auto contact = contact_at(a, line);
        const double depth = contact::jkr::displacement(a, contact), force = contact::jkr::force(a, contact);
        const double stored =
            E * (depth * depth * a - 2.0 / 3.0 * depth * a * a * a / R + std::pow(a, 5) / (5.0 * R * R));
        const double jump_in = work_approach > 0.0 ? spring_jumps({R, E, work_approach}, k).jump_in_loss : 0.0;
        const double largest_area = pi * line.largest_radius * line.largest_radius;
        return jump_in + stored + force * force / (2.0 * k) + line.work_beyond(a) - work_approach * largest_area;
    }
};

struct FittedLine {
    Line line;
    LeastSquaresSolution solution;
    Array1D residuals;  ///< [J/m²]
    double chi2 = 0.0;
};

FittedLine fitted_line(const BranchData& data, const RetractionCourse& course, double contact_modulus) {
    const contact::SphereOnFlat sphere{.radius = course.radius, .contact_modulus = contact_modulus};
    const Array1D& a = data.contact_radius;
    const Index n = a.size();
    Array1D rate(n), by_force(n), by_radius(n);
    for (Index i = 0; i < n; ++i) {
        const auto slopes = contact::jkr::energy_release_slopes(a[i], data.force[i], sphere);
        rate[i] = slopes.value;
        by_force[i] = slopes.by_force;
        by_radius[i] = slopes.by_radius;
    }
    FittedLine fitted;
    Line& line = fitted.line;
    line.smallest_radius = a.minCoeff();
    line.largest_radius = course.largest_contact_radius;
    const Array1D along = (a - line.smallest_radius) / (line.largest_radius - line.smallest_radius);
    const bool noise_known = data.force_noise > 0.0 && data.contact_radius_noise > 0.0;
    const int rounds = noise_known ? 4 : 1;  // iterations of the weights, which depend on the slope
    for (int round = 0; round < rounds; ++round) {
        Array1D deviation = Array1D::Ones(n);
        if (noise_known)
            deviation = ((by_force * data.force_noise).square() +
                         ((by_radius - line.slope()) * data.contact_radius_noise).square())
                            .sqrt();
        Eigen::MatrixXd design(n, 2);
        design << ((1.0 - along) / deviation).matrix(), (along / deviation).matrix();
        fitted.solution = solve_linear(design, (rate / deviation).matrix());
        line.at_pull_off = fitted.solution.parameters[0];
        line.at_largest_contact = fitted.solution.parameters[1];
    }
    fitted.residuals = rate - line.at_pull_off - (line.at_largest_contact - line.at_pull_off) * along;
    fitted.chi2 = noise_known ? fitted.solution.residuals.squaredNorm() / static_cast<double>(n - 2) : undefined;
    return fitted;
}

/// Results of a line and their standard errors.
struct Numbers {
    enum Which : Eigen::Index { at_pull_off, at_largest_contact, slope, loss, constant_loss, count };
    using Values = Eigen::Array<double, count, 1>;

    static Values of(const Retraction& retraction, const Line& line) {
        Line constant = line;
        constant.at_largest_contact = line.at_pull_off;
        Values values;
        values << line.at_pull_off, line.at_largest_contact, line.slope(), retraction.energy_loss(line),
            retraction.energy_loss(constant);
        return values;
    }
};

void require_course(const BranchData& data, const RetractionCourse& course) {
    require_data(data, {.radius = course.radius}, {.contact_radius = true, .fewest = 8});
    if (!(course.contact_modulus.value > 0.0 && course.largest_contact_radius > 0.0 && course.machine_stiffness > 0.0))
        throw InvalidArgument(
            fmt::format("E* = {} Pa, largest contact radius {} m, machine stiffness {} N/m; expected all three above 0",
                        course.contact_modulus.value, course.largest_contact_radius, course.machine_stiffness));
    constexpr double min_share = 0.05;
    const double covered = data.contact_radius.maxCoeff() - data.contact_radius.minCoeff();
    if (!(covered > min_share * course.largest_contact_radius))
        throw UndefinedDataError(
            fmt::format("undetermined: the contact radius changes by {:.1f} % before pull-off; 5 % are needed",
                        100.0 * covered / course.largest_contact_radius));
}

}  // namespace

WorkAlongRetraction fit_work_along_retraction(const BranchData& retraction, const RetractionCourse& course) {
    require_course(retraction, course);
    const double modulus = course.contact_modulus.value, approach = course.work_approach.value;
    const auto fit = fitted_line(retraction, course, modulus);
    const Retraction as_found{course, modulus, approach};
    const auto values = Numbers::of(as_found, fit.line);
    Numbers::Values variance = Numbers::Values::Zero();
    const auto add = [&](const Numbers::Values& moved) { variance += (moved - values).square(); };

    // the scatter, along the principal directions of its covariance
    const Eigen::Matrix2d covariance = fit.solution.uncertainty.covariance;
    const Eigen::LLT<Eigen::Matrix2d> factor(covariance);
    if (factor.info() == Eigen::Success) {
        const Eigen::Matrix2d root = factor.matrixL();
        for (int i = 0; i < 2; ++i) {
            Line moved = fit.line;
            moved.at_pull_off += root(0, i);
            moved.at_largest_contact += root(1, i);
            add(Numbers::of(as_found, moved));
        }
    }
    for (Index mode = 0; mode < retraction.force_zero_modes.cols(); ++mode)
        add(Numbers::of(
            as_found,
            fitted_line(retraction.with_higher_force(retraction.force_zero_modes.col(mode)), course, modulus).line));
    if (course.contact_modulus.uncertain()) {
        const double stiffer = modulus + course.contact_modulus.standard_error;
        add(Numbers::of({course, stiffer, approach}, fitted_line(retraction, course, stiffer).line));
    }
    if (course.work_approach.uncertain())
        add(Numbers::of({course, modulus, approach + course.work_approach.standard_error}, fit.line));

    const auto estimate = [&](Numbers::Which which) {
        return fit.solution.estimate(values[which], std::sqrt(variance[which]));
    };
    return {.at_pull_off = estimate(Numbers::at_pull_off),
            .at_largest_contact = estimate(Numbers::at_largest_contact),
            .slope = estimate(Numbers::slope),
            .smallest_radius = fit.line.smallest_radius,
            .largest_radius = fit.line.largest_radius,
            .n = retraction.force.size(),
            .rms_residual = std::sqrt(fit.residuals.square().mean()),
            .chi2_reduced = fit.chi2,
            .energy_loss = estimate(Numbers::loss),
            .energy_loss_constant = estimate(Numbers::constant_loss)};
}

}  // namespace setae::loops
