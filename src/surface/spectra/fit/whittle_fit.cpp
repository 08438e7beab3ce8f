// SPDX-License-Identifier: GPL-3.0-or-later
#include "whittle_fit.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <Eigen/QR>
#include <Eigen/SparseCore>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/dense.hpp"
#include "setae/spectral_fit/hat_node.hpp"

namespace setae::spectral_fit {
namespace {

/// Prior of ln σ².
struct NoisePrior {
    double centre, deviation;
    double bound;        ///< ln of the smallest P/N of any mode: an upper bound of the noise
    bool seen = false;   ///< visible as the floor of the periodogram
    bool known = false;  ///< known before the fit
};

/// If a periodogram has decreased by a large factor and is almost constant over the two octaves below Nyquist, r =
/// lower over upper octave, noise is the rest of the upper one after subtraction of a surface that decreases sixfold
/// per octave, (6 − r)/5 of it: a surface alone decreases at least threefold there, aliases included. Otherwise only
/// the bound is known; far below it noise is irrelevant, and data that need more noise show it at little cost.
NoisePrior noise_prior(const PeriodogramClass& data) {
    constexpr double hardly = 2.5, sixfold = 6.0, far = 100.0, error_if_seen = 0.3, error_if_unseen = 3.0,
                     weakest = 1e-60;
    const double share_of_bound = std::log(1e-3);
    const Array1D level = (data.periodogram / data.noise_response).max(weakest);
    const double nyquist = data.wavevector[data.wavevector.size() - 1], bound = std::log(level.minCoeff());
    double sums[2] = {0.0, 0.0};
    Index counts[2] = {0, 0};
    for (Index k = 0; k < level.size(); ++k) {
        if (data.wavevector[k] < 0.25 * nyquist) continue;
        const int octave = data.wavevector[k] < 0.5 * nyquist ? 0 : 1;
        sums[octave] += level[k];
        ++counts[octave];
    }
    const double lower = sums[0] / static_cast<double>(counts[0]), upper = sums[1] / static_cast<double>(counts[1]);
    if (lower > hardly * upper || level.maxCoeff() < far * upper)
        return {bound + share_of_bound, error_if_unseen, bound};
    const double left = (sixfold - std::max(1.0, lower / upper)) / (sixfold - 1.0);
    return {std::log(left * upper), error_if_seen, bound, true};
}

/// One per class with noise. The noise of one class of an instrument is the prior for its others, to a factor of e in
/// σ².
std::vector<NoisePrior> noise_priors(const std::vector<PeriodogramClass>& classes) {
    constexpr double like_others = 1.0;
    std::vector<NoisePrior> priors(classes.size());
    std::map<std::string, std::pair<double, int>> seen;
    for (std::size_t c = 0; c < classes.size(); ++c) {
        if (classes[c].noise_response.size() == 0) continue;
        if (classes[c].noise_prior_deviation > 0.0) {
            priors[c] = {0.0, classes[c].noise_prior_deviation, 0.0, false, true};
            continue;
        }
        priors[c] = noise_prior(classes[c]);
        if (!priors[c].seen) continue;
        auto& [sum, count] = seen[classes[c].instrument];
        sum += priors[c].centre;
        ++count;
    }
    for (std::size_t c = 0; c < classes.size(); ++c) {
        const auto found = seen.find(classes[c].instrument);
        if (found == seen.end() || priors[c].seen || priors[c].known) continue;
        priors[c].centre = std::min(found->second.first / found->second.second, priors[c].bound);
        priors[c].deviation = like_others;
    }
    return priors;
}

/// Parameters: theta, then one ln σ² for each class with noise, one for all classes of an instrument with known noise,
/// and some η for each tip.
class Problem {
public:
    Problem(const std::vector<PeriodogramClass>& classes, const LogSpline& spline, const Smoothness& smoothness)
        : classes_(classes), spline_(spline), parameters_(spline.coefficients()) {
        for (const auto& c : classes) {
            designs_.push_back(spline.design(surface_wavevectors(c).min(spline.shortest())).sparseView());
            factors_.push_back(surface_factors(c));
            noise_index_.push_back(index_of_noise(c));
            added_index_.push_back(index_of_added(c));
            responds_ = responds_ || c.reference_amplitude > 0.0;
        }
        prior_centre_ = Eigen::VectorXd::Zero(parameters_);
        precision_ = Eigen::MatrixXd::Zero(parameters_, parameters_);
        add_smoothness(smoothness);
        add_noise_priors();
        for (std::size_t c = 0; c < classes.size(); ++c)
            if (const Index at = added_index_[c]; at >= 0)
                precision_.diagonal().segment(at, classes[c].added_errors.rows()).setOnes();
    }

    [[nodiscard]] Index parameters() const { return parameters_; }
    [[nodiscard]] Index noise_index(std::size_t c) const { return noise_index_[c]; }
    [[nodiscard]] const Eigen::VectorXd& prior_centre() const { return prior_centre_; }
    [[nodiscard]] const Eigen::MatrixXd& precision() const { return precision_; }

    struct State {
        double objective = 0.0;
        Eigen::VectorXd score;          // J₀ᵀνr − Q(x − centre)
        Eigen::MatrixXd information;    // J₀ᵀνJ₀
        Eigen::MatrixXd with_response;  // J₀ᵀν(J₀ + J_T)
        std::vector<Eigen::MatrixXd> jacobian;
        std::vector<Array1D> expected;
    };

    [[nodiscard]] State state(const Eigen::VectorXd& x) const {
        State s;
        const Eigen::VectorXd away = x - prior_centre_;
        s.score = -(precision_ * away);
        s.objective = -0.5 * away.dot(precision_ * away);
        s.information = Eigen::MatrixXd::Zero(parameters_, parameters_);
        s.with_response = s.information;
        for (std::size_t c = 0; c < classes_.size(); ++c) add_class(c, x, s);
        return s;
    }

    /// −∂score/∂x of the observed data, including the response of the tip.
    [[nodiscard]] Eigen::MatrixXd observed(const Eigen::VectorXd& x) const {
        Eigen::MatrixXd result = precision_;
        for (std::size_t c = 0; c < classes_.size(); ++c) add_observed(c, x, result);
        return result;
    }

    /// Without a responding tip, the higher objective. With one, the root of the score is needed, which may not raise
    /// the objective: the smaller score, in the metric of the information.
    [[nodiscard]] bool better(const State& next, const State& now) const {
        constexpr double rounding = 1e-13;
        if (!responds_) return next.objective > now.objective - rounding * std::abs(now.objective);
        const Eigen::MatrixXd metric = now.information + precision_;
        const auto length = [&](const Eigen::VectorXd& score) {
            return score.dot(numerics::solved_symmetric(metric, score));
        };
        return length(next.score) < length(now.score);
    }

    /// A quadratic through ln(P/response) against ln q, by least squares with the degrees of freedom as weights.
    [[nodiscard]] Eigen::VectorXd start() const {
        Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
        Eigen::Vector3d right = Eigen::Vector3d::Zero();
        for (const auto& c : classes_)
            for (Index k = 0; k < c.wavevector.size(); ++k) {
                if (!(c.freedom[k] > 0.0) || !(c.periodogram[k] > 0.0)) continue;
                const double u = std::log(c.wavevector[k]);
                const Eigen::Vector3d row(1.0, u, u * u);
                const double weight = std::min(c.freedom[k], 10.0);
                normal += weight * row * row.transpose();
                right += weight * row * std::log(c.periodogram[k] * pi / c.wavevector[k]);
            }
        if (!(normal(0, 0) > 0.0))
            throw InvalidArgument(
                "no periodogram has a value inside its reliable band, so that no spectrum can be fitted");
        const Eigen::Vector3d fit = normal.colPivHouseholderQr().solve(right);
        Eigen::VectorXd x = prior_centre_;
        for (Index m = 0; m < spline_.coefficients(); ++m) {
            const double u = spline_.position(m);
            x[m] = fit[0] + fit[1] * u + fit[2] * u * u;
        }
        return x;
    }

private:
    /// Index of ln σ² of a class among the parameters; −1 without.
    [[nodiscard]] Index index_of_noise(const PeriodogramClass& c) {
        if (c.noise_response.size() == 0) return -1;
        if (!(c.noise_prior_deviation > 0.0)) return parameters_++;
        const auto [place, is_new] = known_noise_.emplace(c.instrument, parameters_);
        if (is_new) ++parameters_;
        return place->second;
    }

    /// Index of the first η of a tip among the parameters; −1 without.
    [[nodiscard]] Index index_of_added(const PeriodogramClass& c) {
        if (c.added.size() == 0 || c.added_errors.rows() == 0) return -1;
        const auto [place, is_new] = tips_.emplace(c.probe, parameters_);
        if (is_new) parameters_ += c.added_errors.rows();
        return place->second;
    }

    void add_smoothness(const Smoothness& smoothness) {
        const Index n = spline_.coefficients();
        const double bend = 1.0 / (smoothness.bend * smoothness.bend),
                     slope = 1.0 / (smoothness.slope * smoothness.slope);
        for (Index m = 0; m + 2 < n; ++m) {
            Eigen::Vector3d row(1.0, -2.0, 1.0);
            precision_.block(m, m, 3, 3) += bend * row * row.transpose();
        }
        for (Index m = 0; m + 1 < n; ++m) {
            if (std::exp(spline_.position(m + 1)) > smoothness.slope_end) break;
            Eigen::Vector2d row(1.0, -1.0);
            precision_.block(m, m, 2, 2) += slope * row * row.transpose();
        }
    }

    void add_noise_priors() {
        const auto priors = noise_priors(classes_);
        for (std::size_t c = 0; c < classes_.size(); ++c) {
            const Index at = noise_index_[c];
            if (at < 0) continue;
            prior_centre_[at] = priors[c].centre;
            precision_(at, at) = 1.0 / (priors[c].deviation * priors[c].deviation);
        }
    }

    /// E of a class and its parts.
    struct Expectation {
        Array1D followed;                 // C_iso with the tip, at the nodes
        Array1D added;                    // by the tip; empty without
        Array1D expected;                 // E
        Eigen::MatrixXd derivative;       // ∂ ln E/∂x at fixed tip
        Eigen::MatrixXd total;            // including the response of the tip
        Eigen::VectorXd amplitude_slope;  // ∂ ln A/∂theta; empty if no tip responds
    };

    [[nodiscard]] Expectation expectation(std::size_t index, const Eigen::VectorXd& x) const {
        const auto& c = classes_[index];
        Expectation e;
        const Eigen::VectorXd theta = x.head(spline_.coefficients());
        const Array1D f = factors_[index] * (designs_[index] * theta).array().exp();
        double change = 0.0;  // of ln A
        if (c.reference_amplitude > 0.0) {
            const auto amplitude = spline_moment(spline_, theta, c.amplitude_order, c.amplitude_end);
            change = std::clamp(std::log(amplitude.value / c.reference_amplitude), -0.7, 0.7);
            e.amplitude_slope = amplitude.gradient / amplitude.value;
        }
        e.followed = f;
        if (c.log_followed.size() > 0) e.followed *= (c.log_followed + c.followed_response * change).exp();
        const Eigen::MatrixXd scaled = c.response.matrix() * e.followed.matrix().asDiagonal();
        const Array1D surface = scaled.rowwise().sum().array();
        e.expected = surface;
        if (c.added.size() > 0) {
            Array1D raised = c.added_response * change;
            if (const Index at = added_index_[index]; at >= 0)
                raised += (c.added_errors.matrix().transpose() * x.segment(at, c.added_errors.rows())).array();
            e.added = c.added * raised.exp();
            e.expected += e.added;
        }
        e.derivative = Eigen::MatrixXd::Zero(c.wavevector.size(), parameters_);
        e.derivative.leftCols(spline_.coefficients()) = scaled * designs_[index];
        if (const Index at = noise_index_[index]; at >= 0) {
            e.derivative.col(at) = (c.noise_response * std::exp(x[at])).matrix();
            e.expected += e.derivative.col(at).array();
        }
        if (const Index at = added_index_[index]; at >= 0)
            e.derivative.middleCols(at, c.added_errors.rows()) =
                (c.added_errors.rowwise() * e.added.transpose()).transpose().matrix();
        e.expected = e.expected.max(1e-300);
        e.derivative = e.expected.inverse().matrix().asDiagonal() * e.derivative;
        e.total = e.derivative;
        if (e.amplitude_slope.size() > 0) {
            Array1D answer = (scaled * c.followed_response.matrix()).array();
            if (e.added.size() > 0) answer += c.added_response * e.added;
            e.total.leftCols(spline_.coefficients()) += (answer / e.expected).matrix() * e.amplitude_slope.transpose();
        }
        return e;
    }

    void add_class(std::size_t index, const Eigen::VectorXd& x, State& s) const {
        const auto& c = classes_[index];
        const auto e = expectation(index, x);
        const Array1D ratio = c.periodogram / e.expected;
        for (Index k = 0; k < ratio.size(); ++k)
            if (c.freedom[k] > 0.0) s.objective -= c.freedom[k] * (std::log(e.expected[k]) + ratio[k]);
        const Eigen::MatrixXd weighted = c.freedom.matrix().asDiagonal() * e.derivative;
        s.score += weighted.transpose() * (ratio - 1.0).matrix();
        s.information += numerics::transposed_product(weighted, e.derivative);
        s.with_response += numerics::transposed_product(weighted, e.total);
        s.jacobian.push_back(e.derivative.leftCols(spline_.coefficients()));
        s.expected.push_back(e.expected);
    }

    /// −∂score/∂x, J = E_a/E: Σ ν (2r − 1) J_a J_b − Σ ν (r − 1) E_ab/E, b including the response of the tip.
    void add_observed(std::size_t index, const Eigen::VectorXd& x, Eigen::MatrixXd& observed) const {
        const auto& c = classes_[index];
        const auto e = expectation(index, x);
        const Index n = spline_.coefficients();
        const Array1D used = (c.freedom > 0.0).select(c.periodogram / e.expected, 1.0);
        const Eigen::MatrixXd weighted = (c.freedom * (2.0 * used - 1.0)).matrix().asDiagonal() * e.derivative;
        observed += numerics::transposed_product(weighted, e.total);
        const Array1D left = c.freedom * (used - 1.0) / e.expected;
        const Array1D at_nodes = e.followed * (c.response.matrix().transpose() * left.matrix()).array();
        const Eigen::MatrixXd turned = (designs_[index].transpose() * at_nodes.matrix().asDiagonal()).eval();
        observed.topLeftCorner(n, n) -= turned * designs_[index];
        if (e.amplitude_slope.size() > 0)
            observed.topLeftCorner(n, n) -= (turned * c.followed_response.matrix()) * e.amplitude_slope.transpose();
        if (const Index at = noise_index_[index]; at >= 0)
            observed(at, at) -= (c.freedom * (used - 1.0) * e.derivative.col(at).array()).sum();
        const Index at = added_index_[index];
        if (at < 0) return;
        const Index count = c.added_errors.rows();
        const Eigen::MatrixXd errors = c.added_errors.matrix() * (left * e.added).matrix().asDiagonal();
        observed.block(at, at, count, count) -= errors * c.added_errors.matrix().transpose();
        if (e.amplitude_slope.size() > 0)
            observed.block(at, 0, count, n) -= (errors * c.added_response.matrix()) * e.amplitude_slope.transpose();
    }

    const std::vector<PeriodogramClass>& classes_;
    const LogSpline& spline_;
    std::vector<Eigen::SparseMatrix<double>> designs_;  ///< four coefficients per node
    std::vector<Array1D> factors_;
    std::vector<Index> noise_index_, added_index_;
    std::map<std::string, Index> tips_;         ///< η by probe
    std::map<std::string, Index> known_noise_;  ///< of instruments with known noise
    Index parameters_;
    bool responds_ = false;  ///< T of a tip responds to the fit
    Eigen::VectorXd prior_centre_;
    Eigen::MatrixXd precision_;
};

}  // namespace

Array1D surface_wavevectors(const PeriodogramClass& c) {
    return c.lengths.size() > 0 ? Array1D(c.nodes / c.lengths) : c.nodes;
}

double share_below(double wavevector, double end) {
    return std::clamp(std::log(end / wavevector) / node_spacing + 0.5, 0.0, 1.0);
}

Array1D surface_factors(const PeriodogramClass& c) {
    if (c.lengths.size() == 0) return Array1D::Ones(c.nodes.size());
    return (c.nodes / c.lengths).unaryExpr([&](double q) { return share_below(q, c.surface_end); }) /
           c.lengths.square();
}

WhittleFit fit_whittle(const std::vector<PeriodogramClass>& classes, const LogSpline& spline,
                       const Smoothness& smoothness, const Eigen::VectorXd& start) {
    constexpr int max_iterations = 60;
    constexpr double longest_step = 3.0, small_decrement = 1e-4;
    const Problem problem(classes, spline, smoothness);
    Eigen::VectorXd x = problem.start();
    if (start.size() > 0) x.head(spline.coefficients()) = start;
    WhittleFit fit;
    auto state = problem.state(x);
    double damping = 1e-3;
    while (fit.iterations < max_iterations && !fit.converged) {
        ++fit.iterations;
        Eigen::MatrixXd matrix = state.with_response + problem.precision();
        matrix.diagonal() += damping * (state.information + problem.precision()).diagonal();
        Eigen::VectorXd step = numerics::solved(matrix, state.score);
        const double largest = step.cwiseAbs().maxCoeff();
        if (largest > longest_step) step *= longest_step / largest;
        auto next = problem.state(x + step);
        if (std::isfinite(next.objective) && problem.better(next, state)) {
            fit.converged = std::abs(step.dot(state.score)) < small_decrement;
            x += step;
            state = std::move(next);
            damping = std::max(damping / 10.0, 1e-9);
        } else {
            damping *= 10.0;
            if (damping > 1e8) break;
        }
    }
    const Eigen::MatrixXd gain = numerics::inverse(state.with_response + problem.precision());
    const Index n = spline.coefficients();
    fit.covariance =
        numerics::product(numerics::product(gain, state.information + problem.precision()), gain.transpose())
            .topLeftCorner(n, n);
    fit.gain = gain.topLeftCorner(n, n);
    fit.theta = x.head(n);
    fit.parameters = x;
    fit.log_noise = Array1D::Constant(static_cast<Index>(classes.size()), undefined);
    for (std::size_t c = 0; c < classes.size(); ++c)
        if (problem.noise_index(c) >= 0) fit.log_noise[static_cast<Index>(c)] = x[problem.noise_index(c)];
    fit.jacobian = std::move(state.jacobian);
    fit.expected = std::move(state.expected);
    fit.log_likelihood = state.objective;
    return fit;
}

Eigen::VectorXd theta_moved(const WhittleFit& fit, const std::vector<PeriodogramClass>& classes,
                            const MovedClasses& moved, const LogSpline& spline, const Smoothness& smoothness) {
    const auto score = [&](const std::vector<PeriodogramClass>& of) -> Eigen::VectorXd {
        return Problem(of, spline, smoothness).state(fit.parameters).score;
    };
    const Eigen::VectorXd change = 0.5 * (score(moved.plus) - score(moved.minus));
    const Eigen::MatrixXd observed = Problem(classes, spline, smoothness).observed(fit.parameters);
    return numerics::solved(observed, change).head(spline.coefficients());
}

SplineMoment spline_moment(const LogSpline& spline, const Eigen::VectorXd& theta, double order, double end) {
    // ∫ q^{order+1} C d(ln q) by the midpoint rule, 40 per decade, and the closed form of the constant part
    const double lowest = std::exp(spline.position(1)), upper = std::min(end, spline.shortest());
    const double below = std::pow(std::min(lowest, upper), order + 1.0) / (order + 1.0);
    const Index pieces =
        upper > lowest ? std::max<Index>(1, static_cast<Index>(std::ceil(40.0 * std::log10(upper / lowest)))) : 0;
    const double width = pieces > 0 ? std::log(upper / lowest) / static_cast<double>(pieces) : 0.0;
    Array1D q(pieces + 1), weight(pieces + 1);
    q[0] = lowest;
    weight[0] = below;
    for (Index i = 0; i < pieces; ++i) {
        q[i + 1] = lowest * std::exp(width * (static_cast<double>(i) + 0.5));
        weight[i + 1] = width * std::pow(q[i + 1], order + 1.0);
    }
    const Eigen::MatrixXd design = spline.design(q);
    const Array1D part = weight * (design * theta).array().exp();
    return {part.sum(), design.transpose() * part.matrix()};
}

}  // namespace setae::spectral_fit
