// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/force_curve_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <Eigen/Core>

#include "attempt.hpp"
#include "fits/fit_support.hpp"
#include "fits/least_squares.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/numerics/dense.hpp"

namespace setae::loops {
namespace {

constexpr Index min_in_range = 5;
constexpr std::array<std::pair<TipShape, const char*>, 3> shapes{
    {{TipShape::paraboloid, "paraboloid"},
     {TipShape::cone, "cone"},
     {TipShape::three_sided_pyramid, "three_sided_pyramid"}}};

/// F = E* factor (δ − δ0)^power of a tip without adhesion.
struct TipLaw {
    double factor, power;
};

TipLaw tip_law(const ForceCurveFitOptions& options, double radius) {
    if (options.shape == TipShape::paraboloid) {
        if (!(radius > 0.0) || std::isinf(radius))
            throw InvalidArgument(fmt::format("radius of the tip must be > 0 m and finite, got {}", radius));
        return {4.0 / 3.0 * std::sqrt(radius), 1.5};
    }
    if (!(options.half_angle > 0.0 && options.half_angle < 0.5 * pi))
        throw InvalidArgument(fmt::format("the angle of a {} must lie between 0 and π/2 rad, got {}",
                                          to_string(options.shape), options.half_angle));
    const double slope = std::tan(options.half_angle);
    return {options.shape == TipShape::cone ? 2.0 / pi * slope : 0.887 * slope, 2.0};
}

void require_options(const ForceCurveFitOptions& options) {
    const bool dry = options.model == ContactModel::hertz;
    if (options.shape != TipShape::paraboloid && !dry)
        throw InvalidArgument(fmt::format("a {} has only the model hertz, got {}; choose a paraboloid",
                                          to_string(options.shape), to_string(options.model)));
    if (options.model == ContactModel::transition)
        throw InvalidArgument(
            "the transition equation needs contact radii, which a force curve does not have; use maugis_dugdale");
    if (options.fit_force_offset && !dry)
        throw InvalidArgument("a force offset is fitted only with hertz: with adhesion, W takes its place");
    if ((options.fit_force_offset || options.shape != TipShape::paraboloid) && options.errors != FitErrors::force_only)
        throw InvalidArgument("a force offset, a cone and a pyramid are fitted only with force_only");
}

/// Samples of a segment in the range, and for a model with adhesion in contact.
std::vector<Index> chosen(const CurveSegment& segment, const ForceCurveFitOptions& options, double contact_point) {
    const Array1D depth = segment.displacement - contact_point;
    const Array1D measure = options.range.measure == CurveRange::Measure::force ? segment.force
                            : options.range.measure == CurveRange::Measure::indentation
                                ? depth
                                : Array1D(depth / depth.maxCoeff());
    Index first = 0, last = depth.size() - 1;
    if (options.model != ContactModel::hertz) {
        Index least = 0, deepest = 0;
        segment.force.minCoeff(&least);
        depth.maxCoeff(&deepest);
        first = std::min(least, deepest);
        last = std::max(least, deepest);
    }
    std::vector<Index> samples;
    for (Index i = first; i <= last; ++i)
        if (measure[i] >= options.range.from && measure[i] <= options.range.to) samples.push_back(i);
    if (static_cast<Index>(samples.size()) < min_in_range)
        throw UndefinedDataError(
            fmt::format("{} samples of the {} segment lie in the range from {} to {}; a fit needs at least {}",
                        samples.size(), segment.name, options.range.from, options.range.to, min_in_range));
    return samples;
}

/// Hertz's law for any tip: E* and the offset are linear, the contact point is not.
class DryProblem {
public:
    DryProblem(Array1D displacement, Array1D force, const TipLaw& law, bool offset)
        : displacement_(std::move(displacement)), force_(std::move(force)), law_(law), offset_(offset) {
        depth_unit_ = displacement_.maxCoeff() - displacement_.minCoeff();
        force_unit_ = force_.abs().maxCoeff();
        if (!(depth_unit_ > 0.0 && force_unit_ > 0.0))
            throw UndefinedDataError("force or displacement does not change in the range; a fit needs one that does");
    }

    [[nodiscard]] double depth_unit() const { return depth_unit_; }
    [[nodiscard]] double force_unit() const { return force_unit_; }
    /// E* of a coefficient of 1.
    [[nodiscard]] double modulus_unit() const {
        return force_unit_ / (law_.factor * std::pow(depth_unit_, law_.power));
    }

    /// Coefficients and contact point [m] of least squares.
    [[nodiscard]] LeastSquaresSolution solve(std::optional<double> contact_point) const {
        if (contact_point) return solve_linear(design(*contact_point), force_ / force_unit_);
        double best = displacement_.minCoeff(), least = std::numeric_limits<double>::infinity();
        constexpr int candidates = 200;
        for (int k = 0; k < candidates; ++k) {
            // also before the range: a range within contact begins after the contact point
            const double point = displacement_.minCoeff() + (2.0 * k / candidates - 1.0) * depth_unit_;
            const LeastSquaresSolution linear = plain(design(point));
            const double cost = linear.residuals.squaredNorm();
            if (linear.parameters[0] > 0.0 && cost < least) {
                least = cost;
                best = point;
            }
        }
        if (!std::isfinite(least)) require_modulus(undefined);
        const LeastSquaresSolution linear = plain(design(best));
        Eigen::VectorXd start(linear.parameters.size() + 1);
        start << linear.parameters, best / depth_unit_;
        const Index point_column = start.size() - 1;
        return solve_nonlinear(
            {.residuals = force_.size(),
             .parameters = start.size(),
             .evaluate =
                 [&](const Eigen::VectorXd& at, Eigen::VectorXd& residuals, Eigen::MatrixXd* jacobian) {
                     const Eigen::MatrixXd columns = design(at[point_column] * depth_unit_);
                     residuals = (force_ / force_unit_).matrix() - columns * at.head(point_column);
                     if (!jacobian) return;
                     jacobian->leftCols(point_column) = -columns;
                     const Array1D depth = (displacement_ / depth_unit_ - at[point_column]).cwiseMax(0.0);
                     jacobian->col(point_column) = at[0] * law_.power * depth.pow(law_.power - 1.0);
                 }},
            start);
    }

private:
    [[nodiscard]] Eigen::MatrixXd design(double contact_point) const {
        Eigen::MatrixXd columns(force_.size(), offset_ ? 2 : 1);
        columns.col(0) = ((displacement_ - contact_point) / depth_unit_).cwiseMax(0.0).pow(law_.power);
        if (offset_) columns.col(1).setOnes();
        return columns;
    }
    /// solve_linear without the errors from the residuals.
    [[nodiscard]] LeastSquaresSolution plain(const Eigen::MatrixXd& columns) const {
        LeastSquaresSolution solution{.parameters = numerics::least_squares(columns, (force_ / force_unit_).matrix())};
        solution.residuals = (force_ / force_unit_).matrix() - columns * solution.parameters;
        return solution;
    }

    Array1D displacement_, force_;
    TipLaw law_;
    bool offset_;
    double depth_unit_ = 1.0, force_unit_ = 1.0;
};

void fit_dry(ForceCurveFit& fit, const Array1D& displacement, const Array1D& force, const TipLaw& law,
             const ForceCurveFitOptions& options, std::optional<double> contact_point) {
    const double origin = displacement[0];
    const DryProblem problem(displacement - origin, force, law, options.fit_force_offset);
    const LeastSquaresSolution solution =
        problem.solve(contact_point ? std::optional(*contact_point - origin) : std::nullopt);
    const Eigen::VectorXd& at = solution.parameters;
    const Index last = at.size() - 1;
    Eigen::VectorXd units = Eigen::VectorXd::Constant(at.size(), problem.force_unit());
    units[0] = problem.modulus_unit();
    if (!contact_point) units[last] = problem.depth_unit();
    fit.covariance = units.asDiagonal() * solution.uncertainty.covariance * units.asDiagonal();
    const auto estimate = [&](double value, Index k) {
        return solution.estimate(value, std::sqrt(fit.covariance(k, k)));
    };
    require_modulus(at[0] * units[0]);
    fit.parameters = {"contact_modulus"};
    fit.contact_modulus = estimate(at[0] * units[0], 0);
    if (options.fit_force_offset) {
        fit.parameters.emplace_back("force_offset");
        fit.force_offset = estimate(at[1] * units[1], 1);
    }
    fit.contact_point = {.value = contact_point.value_or(0.0), .standard_error = 0.0, .method = "given"};
    if (!contact_point) {
        fit.parameters.emplace_back("contact_point");
        fit.contact_point = estimate(origin + at[last] * units[last], last);
    }
    fit.work_of_adhesion = Outcome<Estimate>::missing("hertz has no adhesion");
    fit.residuals = solution.residuals * problem.force_unit();
    fit.converged = solution.converged && fit.covariance.allFinite();
}

void fit_adhesive(ForceCurveFit& fit, const CurveSegment& segment, const Array1D& displacement, const Array1D& force,
                  const LensAndCounterBody& bodies, const ForceCurveFitOptions& options,
                  std::optional<double> contact_point) {
    const BranchData data{.force = force, .displacement = displacement, .force_noise = segment.baseline.force_noise};
    fit.model_fit = fit_model(data, bodies,
                              {.model = options.model,
                               .channels = Channels::force_displacement,
                               .errors = options.errors,
                               .contact_point = contact_point,
                               .work_of_adhesion = options.work_of_adhesion,
                               .cohesive_stress = options.cohesive_stress});
    fit.parameters = fit.model_fit->parameters;
    fit.covariance = fit.model_fit->covariance;
    fit.contact_modulus = fit.model_fit->contact_modulus;
    fit.contact_point = fit.model_fit->contact_point;
    fit.work_of_adhesion = fit.model_fit->work_of_adhesion;
    fit.residuals = fit.model_fit->force_residuals.values;
    fit.converged = fit.model_fit->converged;
}

}  // namespace

std::string to_string(TipShape shape) {
    for (const auto& [known, name] : shapes)
        if (known == shape) return name;
    throw InternalError("a tip shape without a name");
}

TipShape tip_shape_named(std::string_view name) {
    std::vector<std::string> known;
    for (const auto& [shape, word] : shapes) {
        if (word == name) return shape;
        known.emplace_back(word);
    }
    const std::string nearest = nearest_match(name, known);
    throw InvalidArgument(fmt::format("unknown tip shape '{}'{}; expected one of {}", name,
                                      nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest),
                                      fmt::join(known, ", ")));
}

ForceCurveFit fit_force_curve(const CurveSegment& segment, const LensAndCounterBody& bodies,
                              const ForceCurveFitOptions& options) {
    require_options(options);
    if (segment.name == "pause") throw InvalidArgument("a pause has no curve to fit; choose a segment that moves");
    const TipLaw law = tip_law(options, bodies.radius);
    const double zero = options.contact_point.value_or(segment.contact_point);
    if (!std::isfinite(zero))
        throw UndefinedDataError(
            fmt::format("no force of the {} segment exceeds the noise of {:.2g} N; check that the segment contains a "
                        "contact, or give the contact point",
                        segment.name, segment.baseline.force_noise));
    const std::vector<Index> samples = chosen(segment, options, zero);
    const Array1D displacement = segment.displacement(samples), force = segment.force(samples);
    const std::optional<double> held = options.fit_contact_point ? std::nullopt : std::optional(zero);
    ForceCurveFit fit{.segment = segment,
                      .shape = options.shape,
                      .model = options.model,
                      .force_offset = {.value = 0.0, .standard_error = 0.0, .method = "given"},
                      .n = static_cast<Index>(samples.size()),
                      .samples = samples};
    if (options.model == ContactModel::hertz && options.errors == FitErrors::force_only)
        fit_dry(fit, displacement, force, law, options, held);
    else fit_adhesive(fit, segment, displacement, force, bodies, options, held);
    fit.youngs_modulus = youngs_modulus(fit.contact_modulus, bodies);
    fit.indentation_from = displacement.minCoeff() - fit.contact_point.value;
    fit.indentation_to = displacement.maxCoeff() - fit.contact_point.value;
    fit.rms_residual = std::sqrt(fit.residuals.square().mean());
    fit.relative_residual = fit.rms_residual / (force.maxCoeff() - force.minCoeff());
    return fit;
}

std::vector<NamedCurveFit> fit_force_curve(const Table& curve, const LensAndCounterBody& bodies,
                                           const ForceCurveFitOptions& options) {
    std::vector<NamedCurveFit> fits;
    for (const CurveSegment& segment : segments_of_curve(curve, options))
        if (segment.name != "pause")
            fits.push_back({segment.name, attempt([&] { return fit_force_curve(segment, bodies, options); })});
    return fits;
}

}  // namespace setae::loops
