// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/synthesis/height_transform.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/bracketing.hpp"

namespace setae::synthesis {
namespace {

constexpr double end_of_normal = 12.0;

/// ∫ f(z) exp(−z²/2)/√(2π) dz by equal steps, which for smooth f converges faster than any power.
template <class Function>
double normal_mean(const Function& function, double step) {
    const int steps = static_cast<int>(end_of_normal / step);
    double sum = 0.0;
    for (int i = -steps; i <= steps; ++i) {
        const double z = step * i;
        sum += function(z) * std::exp(-0.5 * z * z);
    }
    return sum * step / std::sqrt(2.0 * pi);
}

struct Moments {
    double mean, variance, skewness, kurtosis;
};

/// Johnson's families with γ = −shift · δ, shift >= 0: skewness >= 0.
struct Unbounded {
    static double value(double z, double shift, double delta) { return std::sinh(z / delta + shift); }

    /// In closed form; all divided by powers of exp(shift), which may be large.
    static Moments moments(double shift, double delta) {
        const double less = std::expm1(1.0 / (delta * delta)), w = 1.0 + less;
        const double variance = 0.5 * less * (w * std::cosh(2.0 * shift) + 1.0);
        const double third =
            0.25 * std::sqrt(w) * less * less * (w * (w + 2.0) * std::sinh(3.0 * shift) + 3.0 * std::sinh(shift));
        const double fourth = 0.125 * less * less *
                              (w * w * (w * w * w * w + 2.0 * w * w * w + 3.0 * w * w - 3.0) * std::cosh(4.0 * shift) +
                               4.0 * w * w * (w + 2.0) * std::cosh(2.0 * shift) + 3.0 * (2.0 * w + 1.0));
        return {std::sqrt(w) * std::sinh(shift), variance, third / std::pow(variance, 1.5),
                fourth / (variance * variance)};
    }
};

struct Bounded {
    static double value(double z, double shift, double delta) { return 1.0 / (1.0 + std::exp(shift - z / delta)); }

    static Moments moments(double shift, double delta) {
        constexpr double step = 0.05;
        const auto y = [&](double z) { return value(z, shift, delta); };
        const double mean = normal_mean(y, step);
        const auto central = [&](int power) {
            return normal_mean([&](double z) { return std::pow(y(z) - mean, power); }, step);
        };
        const double variance = central(2);
        return {mean, variance, central(3) / std::pow(variance, 1.5), central(4) / (variance * variance)};
    }
};

constexpr double smallest_delta = 0.5, largest_delta = 1e5, largest_shift = 40.0;

/// The shift that gives a skewness at this δ; beyond the largest the curve is practically log-normal.
template <class Family>
double shift_for(double skewness, double delta) {
    const auto excess = [&](double shift) { return Family::moments(shift, delta).skewness - skewness; };
    if (skewness == 0.0) return 0.0;
    return excess(largest_shift) <= 0.0 ? largest_shift : numerics::bracketed_root(excess, 0.0, largest_shift, 50);
}

template <class Family>
double kurtosis_at(double skewness, double delta) {
    return Family::moments(shift_for<Family>(skewness, delta), delta).kurtosis;
}

template <class Family>
HeightTransform curve(const HeightShape& shape, double longest_delta) {
    const double limit = kurtosis_at<Family>(shape.skewness, smallest_delta);
    const bool above = Family::moments(0.0, 1.0).kurtosis > 3.0;
    if (above ? shape.kurtosis > limit : shape.kurtosis < limit)
        throw InvalidArgument(
            fmt::format("kurtosis {} with skewness {}; expected {} {:.4g}, where Johnson's curves with δ >= ½ end",
                        shape.kurtosis, shape.skewness, above ? "at most" : "at least", limit));
    const auto excess = [&](double log_delta) {
        return kurtosis_at<Family>(shape.skewness, std::exp(log_delta)) - shape.kurtosis;
    };
    const double delta =
        std::exp(numerics::bracketed_root(excess, std::log(smallest_delta), std::log(longest_delta), 50));
    const double shift = shift_for<Family>(shape.skewness, delta);
    const auto moments = Family::moments(shift, delta);
    const double mean = moments.mean, deviation = std::sqrt(moments.variance);
    return [=](double z) { return (Family::value(z, shift, delta) - mean) / deviation; };
}

HeightTransform mirrored(HeightTransform transform) {
    return [transform = std::move(transform)](double z) { return -transform(-z); };
}

/// √(w − 1) of the log-normal curve: t³ + 3t = skewness.
double lognormal_root(double skewness) { return 2.0 * std::sinh(std::asinh(0.5 * skewness) / 3.0); }

double lognormal_kurtosis(double skewness) {
    const double t = lognormal_root(skewness), w = 1.0 + t * t;
    return ((w + 2.0) * w + 3.0) * w * w - 3.0;
}

HeightTransform positive_lognormal(double skewness) {
    const double t = lognormal_root(skewness), sigma = std::sqrt(std::log1p(t * t));
    return [=](double z) { return std::expm1(sigma * z - 0.5 * sigma * sigma) / t; };
}

}  // namespace

HeightTransform johnson_heights(const HeightShape& shape) {
    constexpr double largest_skewness = 4.0, tolerance = 1e-6;
    if (!(std::abs(shape.skewness) <= largest_skewness) || !std::isfinite(shape.kurtosis))
        throw InvalidArgument(
            fmt::format("heights of skewness {} and kurtosis {}; expected |skewness| <= {} and a finite kurtosis",
                        shape.skewness, shape.kurtosis, largest_skewness));
    if (shape.skewness < 0.0) return mirrored(johnson_heights({-shape.skewness, shape.kurtosis}));
    const double between = lognormal_kurtosis(shape.skewness);
    if (std::abs(shape.kurtosis - between) <= tolerance * between) return lognormal_heights(shape.skewness);
    // skewness limits δ: no curve exceeds the log-normal one of the same δ
    const double t = lognormal_root(shape.skewness);
    const double longest = std::min(largest_delta, 1.0 / std::sqrt(std::log1p(t * t)));
    return shape.kurtosis > between ? curve<Unbounded>(shape, longest) : curve<Bounded>(shape, longest);
}

HeightTransform lognormal_heights(double skewness) {
    if (!std::isfinite(skewness))
        throw InvalidArgument(fmt::format("heights of skewness {}; expected a finite number", skewness));
    if (std::abs(skewness) < 1e-9) return [](double z) { return z; };
    return skewness > 0.0 ? positive_lognormal(skewness) : mirrored(positive_lognormal(-skewness));
}

HeightShape shape_of(const HeightTransform& transform) {
    constexpr double step = 0.01;
    const double mean = normal_mean(transform, step);
    const auto central = [&](int power) {
        return normal_mean([&](double z) { return std::pow(transform(z) - mean, power); }, step);
    };
    const double variance = central(2);
    return {central(3) / std::pow(variance, 1.5), central(4) / (variance * variance)};
}

TransformCorrelation::TransformCorrelation(const HeightTransform& transform) : weights_(Array1D::Zero(60)) {
    constexpr double step = 0.02;
    const int steps = static_cast<int>(end_of_normal / step);
    const Index terms = weights_.size();
    for (int i = -steps; i <= steps; ++i) {
        // He_n/√n! by its recurrence
        const double z = step * i;
        const double share = transform(z) * std::exp(-0.5 * z * z) * step / std::sqrt(2.0 * pi);
        double before = 0.0, here = 1.0;
        for (Index n = 0; n < terms; ++n) {
            const double next =
                (z * here - std::sqrt(static_cast<double>(n)) * before) / std::sqrt(static_cast<double>(n + 1));
            before = here;
            here = next;
            weights_[n] += share * here;
        }
    }
    if (!weights_.isFinite().all() || !(weights_[0] > 0.0))
        throw InvalidArgument(
            fmt::format("a transform of heights with ⟨g(z) z⟩ = {}; expected one that increases and is finite for |z| "
                        "<= {}",
                        weights_[0], end_of_normal));
    weights_ = weights_.square();
    weights_ /= weights_.sum();
}

double TransformCorrelation::transformed(double correlation) const {
    double sum = 0.0;
    for (Index n = weights_.size(); n-- > 0;) sum = (sum + weights_[n]) * correlation;
    return sum;
}

double TransformCorrelation::slope(double correlation) const {
    double sum = 0.0;
    for (Index n = weights_.size(); n-- > 0;) sum = sum * correlation + static_cast<double>(n + 1) * weights_[n];
    return sum;
}

double TransformCorrelation::parent(double transformed_correlation) const {
    if (!(transformed_correlation > transformed(-1.0))) return -1.0;
    if (!(transformed_correlation < 1.0)) return 1.0;
    return numerics::bracketed_root(
        [&](double correlation) { return transformed(correlation) - transformed_correlation; }, -1.0, 1.0, 50);
}

}  // namespace setae::synthesis
