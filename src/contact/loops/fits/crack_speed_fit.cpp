// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/crack_speed_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "edge_course.hpp"
#include "least_squares.hpp"
#include "setae/contact/jkr_curve.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"
#include "setae/numerics/dense.hpp"

namespace setae::loops {
namespace {

constexpr Index min_frames = 8;

/// Relative error of v0 that the method itself leaves, frames and forces between them taken for straight: 1.3 % of
/// records without noise.
constexpr double speed_error = 0.015;

void require_edge(const RetractingEdge& edge, double radius, const Estimate& contact_modulus,
                  const CrackSpeedOptions& options) {
    const auto same = [&](const Array1D& series, const char* name) {
        if (series.size() != edge.time.size())
            throw InvalidArgument(fmt::format("{} has {} samples, time has {}", name, series.size(), edge.time.size()));
    };
    same(edge.force, "force");
    same(edge.contact_radius, "contact radius");
    if (!edge.force.allFinite()) throw InvalidArgument("forces of the retraction must be defined");
    for (Index i = 1; i < edge.time.size(); ++i)
        if (!(edge.time[i] > edge.time[i - 1]))
            throw InvalidArgument(
                fmt::format("time must increase: sample {} at {} s follows {} s", i, edge.time[i], edge.time[i - 1]));
    if (!(radius > 0.0)) throw InvalidArgument(fmt::format("sphere radius must be > 0, got {}", radius));
    if (!(contact_modulus.value > 0.0))
        throw InvalidArgument(fmt::format("contact modulus must be > 0, got {}", contact_modulus.value));
    if (options.exponent && !(*options.exponent > 0.0))
        throw InvalidArgument(fmt::format("exponent of the crack-speed law must be > 0, got {}", *options.exponent));
}

/// The samples from the first frame to the last: only there the radii bound the course.
RetractingEdge between_frames(const RetractingEdge& edge, std::vector<Index>& frames) {
    for (Index i = 0; i < edge.time.size(); ++i)
        if (edge.contact_radius[i] > 0.0) frames.push_back(i);
    if (static_cast<Index>(frames.size()) < min_frames)
        throw UndefinedDataError(
            fmt::format("{} frames show the moving contact edge; a fit of the crack speed needs at least {}",
                        frames.size(), min_frames));
    const Index first = frames.front(), count = frames.back() - first + 1;
    for (Index& frame : frames) frame -= first;
    return {.time = edge.time.segment(first, count),
            .force = edge.force.segment(first, count),
            .contact_radius = edge.contact_radius.segment(first, count),
            .contact_radius_noise = edge.contact_radius_noise};
}

/// Radii of the frames by parabolas through neighbours.
Array1D smoothed(const Array1D& time, const Array1D& values) {
    const Index n = values.size(), window = std::clamp<Index>(n / 12, 5, n);
    Array1D result(n);
    for (Index i = 0; i < n; ++i) {
        const Index first = std::clamp<Index>(i - window / 2, 0, n - window);
        const Array1D steps = (time.segment(first, window) - time[i]) / (time[first + window - 1] - time[first]);
        Eigen::MatrixXd design(window, 3);
        design << Array1D::Ones(window), steps, steps.square();
        result[i] = numerics::least_squares(design, values.segment(first, window).matrix())[0];
    }
    return result;
}

/// Radii predicted by a law, and their positions among the measured ones.
class Problem {
public:
    Problem(const RetractingEdge& edge, double radius, const Estimate& contact_modulus,
            const CrackSpeedOptions& options)
        : edge_(between_frames(edge, frames_)), radius_(radius), given_(contact_modulus), exponent_(options.exponent) {
        const auto n = static_cast<Index>(frames_.size());
        measured_ = edge_.contact_radius(frames_);
        unit_ = measured_.maxCoeff() - measured_.minCoeff();
        const Array1D time = edge_.time(frames_);
        const Array1D course = smoothed(time, measured_);
        rates_ = Array1D(n);
        for (Index i = 0; i < n; ++i)
            rates_[i] =
                contact::jkr::energy_release_slopes(course[i], edge_.force[frames_[i]], {radius, contact_modulus.value})
                    .value;
        if (!(course[n - 1] < course[0]))
            throw UndefinedDataError(
                "the contact edge does not move inwards along the branch; a fit of the crack speed needs a "
                "shrinking contact");
    }

    [[nodiscard]] const Array1D& measured() const { return measured_; }
    [[nodiscard]] double unit() const { return unit_; }

    [[nodiscard]] EdgeCourse course(const EdgeParameters& at) const {
        EdgeCourse all = edge_course(edge_, radius_, at);
        EdgeCourse result{.contact_radius = all.contact_radius(frames_), .speed = all.speed(frames_)};
        result.by_logarithm = all.by_logarithm(frames_, Eigen::all);
        return result;
    }

    /// Integrated, the law is linear in its scale: a(0) − a(t) = c ∫(G − G0)^m dt, m = 1/n, G from smoothed radii. Of
    /// many G0 and m, each with the best c, the one whose course is nearest to the radii.
    [[nodiscard]] EdgeParameters start() const {
        std::vector<double> powers{1.0, 1.25, 1.6, 2.0, 2.8, 4.5, 8.0};
        if (exponent_) powers = {1.0 / *exponent_};
        const double lowest = rates_.minCoeff(), highest = rates_.maxCoeff();
        EdgeParameters best;
        double least = std::numeric_limits<double>::infinity();
        for (const double power : powers)
            for (const double share : {0.3, 0.6, 0.8, 0.9, 0.95, 1.0, 1.05, 1.15, 1.3, 1.6}) {
                const double threshold = share * lowest;
                if (!(threshold < highest)) continue;
                const auto found = with_best_scale(threshold, power);
                if (!found) continue;
                const double squares = (course(*found).contact_radius - measured_).square().sum();
                if (squares < least) {
                    least = squares;
                    best = *found;
                }
            }
        if (!std::isfinite(least))
            throw UndefinedDataError(
                "no law of crack speed fits the moving contact edge: G does not rise with the speed of the "
                "edge; check E* and the zero of force");
        return best;
    }

    /// In ln a(0), ln G0, ln v0, ln n where it is free, and ln E* where `modulus_weight` > 0 ties it to the one given:
    /// residuals in units of the range, ln(E*/E*_given) times the weight at their end.
    [[nodiscard]] ResidualFunction function(double modulus_weight) const {
        const auto n = static_cast<Index>(frames_.size());
        const bool tied = modulus_weight > 0.0;
        return {.residuals = n + (tied ? 1 : 0),
                .parameters = unknowns(tied),
                .evaluate = [this, n, tied, modulus_weight](const Eigen::VectorXd& at, Eigen::VectorXd& residuals,
                                                            Eigen::MatrixXd* jacobian) {
                    const EdgeCourse found = course(parameters(at, tied));
                    residuals.head(n) = ((found.contact_radius - measured_) / unit_).matrix();
                    if (tied) residuals[n] = modulus_weight * at[at.size() - 1];
                    if (!jacobian) return;
                    jacobian->setZero();
                    const std::vector<int> kept = columns(tied);
                    for (std::size_t k = 0; k < kept.size(); ++k)
                        jacobian->col(static_cast<Index>(k)).head(n) = found.by_logarithm.col(kept[k]) / unit_;
                    if (tied) (*jacobian)(n, at.size() - 1) = modulus_weight;
                }};
    }

    [[nodiscard]] Eigen::VectorXd logarithms(const EdgeParameters& at, bool tied) const {
        Eigen::VectorXd result(unknowns(tied));
        result.head(3) << std::log(at.first_radius), std::log(at.law.threshold), std::log(at.law.reference_speed);
        if (!exponent_) result[3] = std::log(at.law.exponent);
        if (tied) result[result.size() - 1] = std::log(at.contact_modulus / given_.value);
        return result;
    }

    [[nodiscard]] EdgeParameters parameters(const Eigen::VectorXd& at, bool tied) const {
        return {.first_radius = std::exp(at[0]),
                .contact_modulus = given_.value * (tied ? std::exp(at[at.size() - 1]) : 1.0),
                .law = {.threshold = std::exp(at[1]),
                        .reference_speed = std::exp(at[2]),
                        .exponent = exponent_ ? *exponent_ : std::exp(at[3])}};
    }

private:
    [[nodiscard]] Index unknowns(bool tied) const { return 3 + (exponent_ ? 0 : 1) + (tied ? 1 : 0); }

    /// Columns of EdgeCourse's derivatives, in the order of the unknowns.
    [[nodiscard]] std::vector<int> columns(bool tied) const {
        std::vector<int> kept{0, 2, 3};
        if (!exponent_) kept.push_back(4);
        if (tied) kept.push_back(1);
        return kept;
    }

    [[nodiscard]] std::optional<EdgeParameters> with_best_scale(double threshold, double power) const {
        const auto n = static_cast<Index>(frames_.size());
        Eigen::MatrixXd design = Eigen::MatrixXd::Ones(n, 2);
        const Array1D drive = ((rates_ - threshold) / threshold).max(0.0).pow(power);
        design(0, 1) = 0.0;
        for (Index i = 1; i < n; ++i)
            design(i, 1) = design(i - 1, 1) -
                           0.5 * (drive[i] + drive[i - 1]) * (edge_.time[frames_[i]] - edge_.time[frames_[i - 1]]);
        if (!(design(n - 1, 1) < 0.0)) return std::nullopt;
        const Eigen::VectorXd linear = numerics::least_squares(design, measured_.matrix());
        if (!(linear[0] > 0.0 && linear[1] > 0.0)) return std::nullopt;
        return EdgeParameters{.first_radius = linear[0],
                              .contact_modulus = given_.value,
                              .law = {.threshold = threshold, .reference_speed = linear[1], .exponent = 1.0 / power}};
    }

    std::vector<Index> frames_;
    RetractingEdge edge_;
    double radius_;
    Estimate given_;
    std::optional<double> exponent_;
    Array1D measured_, rates_;
    double unit_ = 1.0;
};

/// Contribution of E* of another branch, with `standard_error` in ln E*, to a covariance whose last parameter is ln E*.
Eigen::MatrixXd with_modulus(const Eigen::MatrixXd& covariance, double standard_error) {
    const Eigen::VectorXd shared = covariance.col(covariance.cols() - 1);
    return covariance - shared * shared.transpose() / (standard_error * standard_error + shared[shared.size() - 1]);
}

void require_stated(const Eigen::MatrixXd& covariance, bool exponent_free) {
    const auto uncertain = [&](Index k) { return !(covariance(k, k) <= 1.0); };
    std::string unknown;
    for (const auto& [k, name] : {std::pair<Index, const char*>{1, "G0"}, {2, "v0"}, {3, "n"}})
        if ((k < 3 || exponent_free) && uncertain(k)) unknown += (unknown.empty() ? "" : ", ") + std::string(name);
    if (unknown.empty()) return;
    throw UndefinedDataError(
        fmt::format("the radii do not determine a law of crack speed: {} uncertain by more than a factor e; the "
                    "speeds, or G with them, vary too little: unload at several speeds{}",
                    unknown, exponent_free ? " or give the exponent" : ""));
}

double rms(const Array1D& values) { return std::sqrt(values.square().mean()); }

void take_speeds(CrackSpeedFit& fit, const Array1D& speed) {
    fit.slow_speed = fit.speed_ratio = undefined;
    std::vector<double> receding;
    for (const double v : speed)
        if (v > 0.0) receding.push_back(v);
    if (receding.empty()) return;
    std::sort(receding.begin(), receding.end());
    fit.slow_speed = sorted_quantile(receding, 0.05);
    fit.speed_ratio = sorted_quantile(receding, 0.95) / fit.slow_speed;
}

}  // namespace

CrackSpeedFit fit_crack_speed(const RetractingEdge& edge, double radius, const Estimate& contact_modulus,
                              const CrackSpeedOptions& options) {
    require_edge(edge, radius, contact_modulus, options);
    const Problem problem(edge, radius, contact_modulus, options);
    const Index n = problem.measured().size();

    // E* as given first: its residuals give the noise where it is unknown
    LeastSquaresSolution solution = solve_nonlinear(problem.function(0.0), problem.logarithms(problem.start(), false));
    CrackSpeedFit fit{.n = n};
    fit.iterations = solution.iterations;
    const double known = edge.contact_radius_noise;
    const double given_error = contact_modulus.standard_error / contact_modulus.value;
    const bool tied = given_error > 0.0;
    if (tied) {
        const EdgeParameters held = problem.parameters(solution.parameters, false);
        const double noise = known > 0.0 ? known / problem.unit() : rms(solution.residuals.array());
        solution = solve_nonlinear(problem.function(noise / given_error), problem.logarithms(held, true));
        fit.iterations += solution.iterations;
        const ResidualFunction alone = problem.function(noise / given_error);
        Eigen::VectorXd residuals(alone.residuals);
        Eigen::MatrixXd jacobian(alone.residuals, alone.parameters);
        alone.evaluate(solution.parameters, residuals, &jacobian);
        solution.residuals = residuals.head(n);
        solution.uncertainty = correlated_covariance(Eigen::MatrixXd(jacobian.topRows(n)), solution.residuals);
    }
    Eigen::MatrixXd covariance = solution.uncertainty.covariance;
    const Index last = covariance.cols() - 1;
    fit.modulus_deviation = undefined;
    if (tied) {
        fit.modulus_deviation = -solution.parameters[last] *
                                std::sqrt(covariance(last, last) + given_error * given_error) / covariance(last, last);
        covariance = with_modulus(covariance, given_error);
    }
    require_stated(covariance, !options.exponent);
    covariance(2, 2) += speed_error * speed_error;

    const EdgeParameters found = problem.parameters(solution.parameters, tied);
    fit.law = found.law;
    // of G0, v0, n, E* by the unknowns
    Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(4, covariance.cols());
    slopes(0, 1) = found.law.threshold;
    slopes(1, 2) = found.law.reference_speed;
    if (!options.exponent) slopes(2, 3) = found.law.exponent;
    if (tied) slopes(3, last) = found.contact_modulus;
    fit.covariance = slopes * covariance * slopes.transpose();
    const auto estimate = [&](double value, Index k) {
        return solution.estimate(value, std::sqrt(fit.covariance(k, k)));
    };
    fit.threshold = estimate(found.law.threshold, 0);
    fit.reference_speed = estimate(found.law.reference_speed, 1);
    fit.exponent = options.exponent ? Estimate{.value = *options.exponent, .standard_error = 0.0, .method = "given"}
                                    : estimate(found.law.exponent, 2);
    fit.contact_modulus = tied ? estimate(found.contact_modulus, 3) : contact_modulus;
    fit.converged = solution.converged;
    fit.residuals = -problem.unit() * solution.residuals.array();
    fit.relative_residual = rms(fit.residuals) / problem.unit();
    fit.chi2_reduced =
        known > 0.0 ? (fit.residuals / known).square().sum() / static_cast<double>(n - covariance.cols()) : undefined;
    take_speeds(fit, problem.course(found).speed);
    return fit;
}

}  // namespace setae::loops
