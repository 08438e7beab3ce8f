// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/self_affine_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>
#include <Eigen/Core>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"
#include "setae/numerics/bracketing.hpp"
#include "setae/numerics/dense.hpp"

namespace setae::spectra {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Indices of the four parameters: ln amplitude, H, ln λ_r, ln λ_s.
enum Place : Index { amplitude, hurst, rolloff, cutoff, places };
constexpr const char* names[] = {"ln amplitude", "H", "ln rolloff_wavelength", "ln shortest_wavelength"};

using Parameters = Eigen::Vector4d;

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr double smallest_hurst = 0.01, largest_hurst = 1.45;

/// Used values of all data in sequence, and their model.
class Problem {
public:
    Problem(std::span<const FittedValues> data, const SelfAffineFitOptions& options) : data_(data) {
        double lower = unbounded, upper = 0.0;
        for (std::size_t d = 0; d < data.size(); ++d) {
            const auto& set = data[d];
            const Index n = set.wavevector.size();
            if (set.values.size() != n || set.freedom.size() != n || !set.expected)
                throw InvalidArgument(fmt::format(
                    "{} wavevectors with {} values and {} degrees of freedom; expected one of each and their "
                    "expectation",
                    n, set.values.size(), set.freedom.size()));
            for (Index k = 0; k < n; ++k) {
                const double q = set.wavevector[k];
                if (!(set.freedom[k] > 0.0) ||
                    (options.range && (q < options.range->lower || q > options.range->upper)))
                    continue;
                if (!(q > 0.0 && std::isfinite(q) && set.values[k] > 0.0 && std::isfinite(set.values[k]) &&
                      std::isfinite(set.freedom[k])))
                    throw InvalidArgument(fmt::format(
                        "value {} of the spectrum: C1D {} m3 at {} 1/m with {} degrees of freedom; expected all positive",
                        k, set.values[k], q, set.freedom[k]));
                used_.push_back({d, k});
                lower = std::min(lower, q);
                upper = std::max(upper, q);
            }
        }
        fitted_ = {amplitude, hurst};
        if (options.rolloff) fitted_.push_back(rolloff);
        if (options.short_cutoff) fitted_.push_back(cutoff);
        if (used_.size() < fitted_.size() + 2)
            throw InvalidArgument(fmt::format(
                "{} values in the range of the fit for {} parameters; expected at least {}: enlarge the range",
                used_.size(), fitted_.size(), fitted_.size() + 2));
        std::sort(used_.begin(), used_.end(),
                  [&](const auto& a, const auto& b) { return wavevector(a) < wavevector(b); });
        range_ = {lower, upper};
        reference_ = std::sqrt(lower * upper);
        const auto n = static_cast<Index>(used_.size());
        q_ = Array1D::NullaryExpr(n, [&](Index i) { return wavevector(used_[static_cast<std::size_t>(i)]); });
        values_ = Array1D::NullaryExpr(n, [&](Index i) {
            return data_[used_[static_cast<std::size_t>(i)].set].values[used_[static_cast<std::size_t>(i)].index];
        });
        freedom_ = Array1D::NullaryExpr(n, [&](Index i) {
            return data_[used_[static_cast<std::size_t>(i)].set].freedom[used_[static_cast<std::size_t>(i)].index];
        });
    }

    [[nodiscard]] spectra::SelfAffine model(const Parameters& p) const {
        const double q_r = 2.0 * pi * std::exp(-p[rolloff]), q_s = 2.0 * pi * std::exp(-p[cutoff]);
        return {std::exp(p[amplitude]) * std::pow(q_r / reference_, -2.0 - 2.0 * p[hurst]), q_r, p[hurst], q_s};
    }

    [[nodiscard]] Array1D expected(const Parameters& p) const {
        std::vector<Array1D> sets;
        for (const auto& set : data_) sets.push_back(set.expected(model(p)));
        return Array1D::NullaryExpr(q_.size(), [&](Index i) {
            return sets[used_[static_cast<std::size_t>(i)].set][used_[static_cast<std::size_t>(i)].index];
        });
    }

    [[nodiscard]] double loss(const Array1D& expected) const {
        if (!(expected > 0.0).all() || !expected.allFinite()) return unbounded;
        const Array1D r = values_ / expected;
        return (freedom_ * (r - 1.0 - r.log())).sum();
    }

    /// Limited to the domain of the model, with scales no farther from the data than they determine.
    [[nodiscard]] Parameters clamped(Parameters p) const {
        p[hurst] = std::clamp(p[hurst], smallest_hurst, largest_hurst);
        p[rolloff] = std::clamp(p[rolloff], shortest_rolloff(), longest_rolloff());
        p[cutoff] = std::clamp(p[cutoff], shortest_cutoff(), longest_cutoff());
        p[cutoff] = std::min(p[cutoff], p[rolloff] - 0.01);
        return p;
    }
    [[nodiscard]] double shortest_rolloff() const { return std::log(2.0 * pi / range_.upper); }
    [[nodiscard]] double longest_rolloff() const { return std::log(2.0 * pi / range_.lower * 1e3); }
    /// A thousandth beyond the last value, so differences remain inside.
    [[nodiscard]] double longest_cutoff() const { return std::log(2.0 * pi / (1.001 * range_.upper)); }
    [[nodiscard]] double shortest_cutoff() const { return std::log(2.0 * pi / range_.upper * 1e-3); }

    [[nodiscard]] const std::vector<Index>& fitted() const { return fitted_; }
    [[nodiscard]] const Band& range() const { return range_; }
    [[nodiscard]] double reference() const { return reference_; }
    [[nodiscard]] const Array1D& wavevector() const { return q_; }
    [[nodiscard]] const Array1D& values() const { return values_; }
    [[nodiscard]] const Array1D& freedom() const { return freedom_; }

private:
    struct Used {
        std::size_t set;
        Index index;
    };
    [[nodiscard]] double wavevector(const Used& u) const { return data_[u.set].wavevector[u.index]; }

    std::span<const FittedValues> data_;
    std::vector<Used> used_;
    std::vector<Index> fitted_;
    Band range_;
    double reference_ = 0.0;
    Array1D q_, values_, freedom_;
};

/// ∂ ln E/∂ p of some parameters, central differences.
MatrixXd jacobian(const Problem& problem, const Parameters& at, const std::vector<Index>& free) {
    MatrixXd result(problem.wavevector().size(), static_cast<Index>(free.size()));
    for (std::size_t c = 0; c < free.size(); ++c) {
        constexpr double step = 1e-4;
        Parameters up = at, down = at;
        up[free[c]] += step;
        down[free[c]] -= step;
        result.col(static_cast<Index>(c)) = (problem.expected(up).log() - problem.expected(down).log()) / (2.0 * step);
    }
    return result;
}

struct Optimum {
    Parameters at = Parameters::Zero();
    double loss = unbounded;
    int iterations = 0;
    bool converged = false;
};

/// Levenberg–Marquardt on the gamma likelihood, with Fisher's information as curvature.
Optimum minimised(const Problem& problem, Parameters start, const std::vector<Index>& free) {
    Optimum best{problem.clamped(start), unbounded, 0, false};
    Array1D expected = problem.expected(best.at);
    best.loss = problem.loss(expected);
    double damping = 1e-3;
    constexpr int max_iterations = 60;
    for (; best.iterations < max_iterations; ++best.iterations) {
        const MatrixXd J = jacobian(problem, best.at, free);
        const MatrixXd weighted = problem.freedom().matrix().asDiagonal() * J;
        const MatrixXd information = J.transpose() * weighted;
        const VectorXd score = weighted.transpose() * (problem.values() / expected - 1.0).matrix();
        bool moved = false;
        double gain = 0.0;
        while (damping < 1e8) {
            MatrixXd damped = information;
            damped.diagonal() += damping * information.diagonal() + VectorXd::Constant(information.rows(), 1e-9);
            const VectorXd step = numerics::solved_symmetric(damped, score);
            Parameters next = best.at;
            for (std::size_t c = 0; c < free.size(); ++c)
                next[free[c]] += std::clamp(step[static_cast<Index>(c)], -1.0, 1.0);
            next = problem.clamped(next);
            const Array1D there = problem.expected(next);
            const double loss = problem.loss(there);
            if (loss < best.loss) {
                gain = best.loss - loss;
                best.at = next;
                best.loss = loss;
                expected = there;
                damping = std::max(1e-9, 0.2 * damping);
                moved = true;
                break;
            }
            damping *= 5.0;
        }
        if (!moved || gain < 1e-7 * (1.0 + best.loss)) {
            best.converged = true;
            break;
        }
    }
    return best;
}

/// A power law through the values, least squares in logarithms.
Parameters first_guess(const Problem& problem) {
    const Array1D x = (problem.wavevector() / problem.reference()).log(), y = problem.values().log(),
                  w = problem.freedom() / problem.freedom().sum();
    const double mx = (w * x).sum(), my = (w * y).sum(),
                 slope = (w * (x - mx) * (y - my)).sum() / std::max(1e-12, (w * (x - mx).square()).sum());
    Parameters p;
    p[hurst] = std::clamp(0.5 * (-slope - 1.0), 0.1, 1.2);
    // C1D of lines is about q/3 times C_iso
    p[amplitude] = my - slope * mx + std::log(3.0 / problem.reference());
    p[rolloff] = problem.longest_rolloff();
    p[cutoff] = problem.shortest_cutoff();
    return p;
}

Optimum best_of_starts(const Problem& problem) {
    const auto& free = problem.fitted();
    const auto has = [&](Index place) { return std::find(free.begin(), free.end(), place) != free.end(); };
    const Parameters guess = first_guess(problem);
    const double low = std::log(2.0 * pi / problem.range().upper), high = std::log(2.0 * pi / problem.range().lower);
    std::vector<double> rolloffs{guess[rolloff]}, cutoffs{guess[cutoff]};
    if (has(rolloff))
        for (const double share : {0.95, 0.75, 0.5}) rolloffs.push_back(low + share * (high - low));
    if (has(cutoff)) cutoffs = {low - 0.05, low - 1.0};
    Optimum best;
    for (const double longest : rolloffs)
        for (const double shortest : cutoffs) {
            Parameters start = guess;
            start[rolloff] = longest;
            start[cutoff] = shortest;
            const auto found = minimised(problem, start, free);
            if (found.loss < best.loss) best = found;
        }
    return best;
}

/// Position where the loss with one fixed parameter has increased by `rise`, from the optimum towards `end`; infinite
/// with its sign if it never does.
double profile_end(const Problem& problem, const Optimum& best, Index place, double end, double rise) {
    std::vector<Index> free;
    for (const Index p : problem.fitted())
        if (p != place) free.push_back(p);
    const double sign = end > best.at[place] ? 1.0 : -1.0;
    Parameters near = best.at;
    const auto excess = [&](double value) {
        Parameters start = near;
        start[place] = value;
        const auto found = minimised(problem, start, free);
        if (found.loss < best.loss + rise) near = found.at;
        return found.loss - best.loss - rise;
    };
    double inside = best.at[place], step = 0.1;
    for (;;) {
        const double outside = inside + sign * step;
        if ((outside - end) * sign >= 0.0) return sign * unbounded;
        if (excess(outside) > 0.0) {
            const auto [within, beyond] =
                numerics::bisected([&](double value) { return !(excess(value) > 0.0); }, inside, outside, 12);
            return 0.5 * (within + beyond);
        }
        inside = outside;
        step *= 1.6;
    }
}

Quantity named(std::string name, std::string symbol, double value, double error, std::string unit, double level) {
    Quantity q;
    q.quantity = std::move(name);
    q.symbol = std::move(symbol);
    q.estimate = {value, error, "fit covariance"};
    const auto interval = interval_of(q.estimate, level);
    if (interval) q.estimate.interval = interval;
    q.unit = std::move(unit);
    q.source = "self-affine fit";
    return q;
}

/// exp of a normal estimate of a logarithm.
Quantity from_logarithm(std::string name, std::string symbol, double logarithm, double error, std::string unit,
                        double level) {
    auto q = named(std::move(name), std::move(symbol), std::exp(logarithm), std::exp(logarithm) * error,
                   std::move(unit), level);
    const double reach = normal_quantile(0.5 + 0.5 * level) * error;
    if (error > 0.0) q.estimate.interval = Interval{std::exp(logarithm - reach), std::exp(logarithm + reach), level};
    return q;
}

Alert not_determined(bool longest, const Interval& interval) {
    if (longest)
        return {
            "ROLLOFF_NOT_SEEN", "self-affine fit",
            fmt::format("the spectrum does not show its roll-off: rolloff_wavelength is above {:.3g} m, and no upper "
                        "end is known",
                        interval.lower),
            "measure larger scans, or fit without a roll-off; the rms height then depends on the scan size"};
    return {"CUTOFF_NOT_SEEN", "self-affine fit",
            fmt::format("the spectrum does not show its short cutoff: shortest_wavelength is below {:.3g} m, and no "
                        "lower end is known",
                        interval.upper),
            "measure with a sharper instrument, or fit without a short cutoff"};
}

/// Warns of parameters at their bounds. Scales at the far ends are not determined: see not_determined().
void add_bound_alerts(SelfAffineFit& fit, const Problem& problem, const Parameters& at) {
    constexpr double near = 1e-6;
    const auto add = [&](double value, double bound, std::string what) {
        if (!(std::abs(value - bound) < near)) return;
        fit.alerts.push_back(
            {"FIT_AT_BOUND", "self-affine fit", std::move(what),
             "the model does not fit these values; choose a range in which C1D is one power law, or one "
             "power law with a roll-off"});
    };
    add(at[hurst], smallest_hurst,
        fmt::format("hurst_exponent ended at the smallest value allowed, {}", smallest_hurst));
    add(at[hurst], largest_hurst, fmt::format("hurst_exponent ended at the largest value allowed, {}", largest_hurst));
    if (fit.rolloff != ScaleStatus::not_asked)
        add(at[rolloff], problem.shortest_rolloff(),
            fmt::format("rolloff_wavelength ended at the shortest wavelength fitted, {:.3g} m: the values contain no "
                        "power law",
                        2.0 * pi / fit.range.upper));
    if (fit.short_cutoff != ScaleStatus::not_asked)
        add(at[cutoff], problem.longest_cutoff(),
            fmt::format("shortest_wavelength ended at the shortest wavelength fitted, {:.3g} m",
                        2.0 * pi / fit.range.upper));
}

}  // namespace

SelfAffineFit fit_self_affine(std::span<const FittedValues> data, const SelfAffineFitOptions& options) {
    if (!(options.level > 0.0 && options.level < 1.0))
        throw InvalidArgument(fmt::format("level {}; expected above 0 and below 1", options.level));
    if (options.range && !(options.range->lower > 0.0 && options.range->upper > options.range->lower))
        throw InvalidArgument(fmt::format("fit range {} … {} 1/m; expected 0 < lower < upper", options.range->lower,
                                          options.range->upper));
    const Problem problem(data, options);
    const auto best = best_of_starts(problem);
    SelfAffineFit fit;
    fit.model = problem.model(best.at);
    fit.range = problem.range();
    fit.reference_wavevector = problem.reference();
    fit.wavevector = problem.wavevector();
    fit.values = problem.values();
    fit.expected = problem.expected(best.at);
    const Array1D r = fit.values / fit.expected, nu = problem.freedom();
    const Array1D deviance = 2.0 * nu * (r - 1.0 - r.log()).max(0.0) / (1.0 + 1.0 / (6.0 * nu));
    fit.residual = (r > 1.0).select(deviance.sqrt(), -deviance.sqrt());
    fit.chi_squared = deviance.sum();
    fit.degrees_of_freedom = static_cast<double>(r.size() - static_cast<Index>(problem.fitted().size()));
    fit.probability = chi_squared_exceedance(fit.chi_squared, fit.degrees_of_freedom);
    fit.iterations = best.iterations;
    fit.status = best.converged ? FitStatus::converged : FitStatus::not_converged;
    const double dispersion = std::max(1.0, fit.chi_squared / fit.degrees_of_freedom);

    // scales with an open interval are not part of the covariance
    const double quantile = normal_quantile(0.5 + 0.5 * options.level), rise = 0.5 * quantile * quantile * dispersion;
    std::vector<Index> known{amplitude, hurst};
    const auto scale = [&](Index place, const char* name, const char* symbol, ScaleStatus& status) {
        Interval interval{
            std::exp(profile_end(problem, best, place,
                                 place == rolloff ? problem.shortest_rolloff() : problem.shortest_cutoff(), rise)),
            std::exp(profile_end(problem, best, place,
                                 place == rolloff ? problem.longest_rolloff() : problem.longest_cutoff(), rise)),
            options.level};
        // a spectrum cannot end before the last of its values
        if (place == cutoff && std::isinf(interval.upper)) interval.upper = 2.0 * pi / fit.range.upper;
        const bool open = place == rolloff ? std::isinf(interval.upper) : interval.lower == 0.0;
        status = open ? ScaleStatus::bounded : ScaleStatus::found;
        if (open) fit.alerts.push_back(not_determined(place == rolloff, interval));
        else known.push_back(place);
        auto q = named(name, symbol, std::exp(best.at[place]), undefined, "m", options.level);
        q.estimate.interval = interval;
        q.estimate.method = "profile likelihood";
        return q;
    };
    fit.plateau = named("plateau", "C_0", undefined, undefined, "m4", options.level);
    fit.rolloff_wavelength = named("rolloff_wavelength", "lambda_r", undefined, undefined, "m", options.level);
    fit.shortest_wavelength = named("shortest_wavelength", "lambda_s", undefined, undefined, "m", options.level);
    if (options.rolloff) fit.rolloff_wavelength = scale(rolloff, "rolloff_wavelength", "lambda_r", fit.rolloff);
    if (options.short_cutoff)
        fit.shortest_wavelength = scale(cutoff, "shortest_wavelength", "lambda_s", fit.short_cutoff);

    const MatrixXd J = jacobian(problem, best.at, known);
    const MatrixXd information = J.transpose() * nu.matrix().asDiagonal() * J;
    fit.covariance =
        dispersion *
        numerics::solved_symmetric(information, MatrixXd(MatrixXd::Identity(information.rows(), information.cols())));
    const VectorXd errors = fit.covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
    fit.correlation = errors.cwiseInverse().asDiagonal() * fit.covariance * errors.cwiseInverse().asDiagonal();
    for (const Index place : known) fit.parameters.emplace_back(names[place]);
    fit.hurst_exponent = named("hurst_exponent", "H", best.at[hurst], errors[1], "1", options.level);
    fit.amplitude = from_logarithm("amplitude", "C_ref", best.at[amplitude], errors[0], "m4", options.level);
    for (std::size_t k = 2; k < known.size(); ++k) {
        auto& q = known[k] == rolloff ? fit.rolloff_wavelength : fit.shortest_wavelength;
        q.estimate.standard_error = q.estimate.value * errors[static_cast<Index>(k)];
    }
    if (options.rolloff) {
        // ln C_0 = ln amplitude − (2 + 2H) ln(q_r/q_ref), with ln q_r = −ln λ_r + const
        VectorXd gradient = VectorXd::Zero(static_cast<Index>(known.size()));
        gradient[0] = 1.0;
        gradient[1] = -2.0 * std::log(fit.model.rolloff_wavevector / fit.reference_wavevector);
        if (fit.rolloff == ScaleStatus::found) gradient[2] = 2.0 + 2.0 * best.at[hurst];
        fit.plateau = from_logarithm(
            "plateau", "C_0", std::log(fit.model.plateau),
            fit.rolloff == ScaleStatus::found ? std::sqrt(gradient.dot(fit.covariance * gradient)) : undefined, "m4",
            options.level);
    }
    for (auto* q :
         {&fit.hurst_exponent, &fit.amplitude, &fit.plateau, &fit.rolloff_wavelength, &fit.shortest_wavelength}) {
        q->band = fit.range;
        q->n = static_cast<int>(r.size());
    }
    if (fit.status == FitStatus::not_converged)
        fit.alerts.push_back({"NOT_CONVERGED", "self-affine fit",
                              fmt::format("the fit stopped after {} steps before reaching its optimum", fit.iterations),
                              "narrow the range, or fit fewer parameters"});
    add_bound_alerts(fit, problem, best.at);
    constexpr double improbable = 1e-3;
    if (fit.probability < improbable)
        fit.alerts.push_back(
            {"MODEL_MISSES", "self-affine fit",
             fmt::format("the values scatter about the model {:.2g} times as much as their errors allow (chi2 = {:.4g} "
                         "for {:.0f} degrees of freedom); the standard errors are multiplied by this factor",
                         std::sqrt(dispersion), fit.chi_squared, fit.degrees_of_freedom),
             "look at the residuals; narrow the range to where one power law holds"});
    return fit;
}

Spectrum model_spectrum(const SelfAffineFit& fit, const ArrayView1D& wavevector) {
    Spectrum spectrum{.wavevector = wavevector,
                      .density = Array1D(wavevector.size()),
                      .band = fit.range,
                      .standard_error = Array1D(wavevector.size())};
    const auto value = [&](const spectra::SelfAffine& model, double q) {
        return q < model.short_wavevector ? spectra::profile_power_spectrum(model, Array1D::Constant(1, q))[0] : 0.0;
    };
    // the model with one parameter of the covariance changed
    const auto moved = [&](Index parameter, double step) {
        auto model = fit.model;
        const auto& name = fit.parameters[static_cast<std::size_t>(parameter)];
        double H = model.hurst_exponent,
               strength = std::log(model.plateau) +
                          (2.0 + 2.0 * H) * std::log(model.rolloff_wavevector / fit.reference_wavevector);
        if (name == names[amplitude]) strength += step;
        if (name == names[hurst]) H += step;
        if (name == names[rolloff]) model.rolloff_wavevector *= std::exp(-step);
        if (name == names[cutoff]) model.short_wavevector *= std::exp(-step);
        model.hurst_exponent = H;
        model.plateau =
            std::exp(strength - (2.0 + 2.0 * H) * std::log(model.rolloff_wavevector / fit.reference_wavevector));
        return model;
    };
    const auto count = static_cast<Index>(fit.parameters.size());
    constexpr double step = 1e-4;
    std::vector<spectra::SelfAffine> up, down;
    for (Index p = 0; p < count; ++p) {
        up.push_back(moved(p, step));
        down.push_back(moved(p, -step));
    }
    for (Index k = 0; k < wavevector.size(); ++k) {
        const double q = wavevector[k];
        spectrum.density[k] = value(fit.model, q);
        VectorXd gradient(count);
        for (Index p = 0; p < count; ++p)
            gradient[p] = (value(up[static_cast<std::size_t>(p)], q) - value(down[static_cast<std::size_t>(p)], q)) /
                          (2.0 * step);
        spectrum.standard_error[k] = std::sqrt(std::max(0.0, gradient.dot(fit.covariance * gradient)));
    }
    return spectrum;
}

}  // namespace setae::spectra
