// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace setae::loops {

/// Sums for a least-squares problem of few parameters: JᵀJ, Jᵀr and Σ r², J that of the model.
template <int parameters>
struct NormalEquations {
    Eigen::Matrix<double, parameters, parameters> normal = Eigen::Matrix<double, parameters, parameters>::Zero();
    Eigen::Matrix<double, parameters, 1> gradient = Eigen::Matrix<double, parameters, 1>::Zero();
    double squares = 0.0;
};

template <int parameters>
struct SmallMinimum {
    Eigen::Matrix<double, parameters, 1> parameters_found;
    bool converged = false;
    int iterations = 0;
};

/// Whether a step is far below the standard errors, squares/freedom the variance; the step is still applied, and the
/// remainder after it is smaller.
template <class Step, class Normal>
[[nodiscard]] bool far_below_errors(const Step& step, const Normal& normal, double squares, double freedom) {
    constexpr double of_standard_error = 1e-4;
    return step.dot(normal * step) <= of_standard_error * of_standard_error * squares / freedom;
}

/// Solution of the normal equations, damped after Marquardt: (N + λ diag N) s = g in columns of unit length. Not finite
/// where a diagonal element is 0.
template <class Normal, class Gradient>
[[nodiscard]] Gradient damped_step(const Normal& normal, const Gradient& gradient, double damping) {
    const Gradient scale = normal.diagonal().cwiseSqrt().cwiseInverse();
    Normal scaled = scale.asDiagonal() * normal * scale.asDiagonal();
    scaled.diagonal().array() += damping;
    return scale.cwiseProduct(scaled.ldlt().solve(scale.cwiseProduct(gradient)));
}

/// Levenberg and Marquardt's method on normal equations of columns of unit length, undamped while the sum falls as they
/// foresee: across a kink of the curve, where it falls by far less, steps are shortened until nothing is left.
/// evaluate(at) gives NormalEquations. Sums of noise-free data end in rounding, where the sum no longer falls:
/// converged if the step was small.
template <int parameters, class Evaluate>
[[nodiscard]] SmallMinimum<parameters> minimise_small(const Evaluate& evaluate,
                                                      const Eigen::Matrix<double, parameters, 1>& start,
                                                      double freedom) {
    using Vector = Eigen::Matrix<double, parameters, 1>;
    constexpr int max_rounds = 200;
    constexpr double rounding = 1e-15, small = 1e-12, max_damping = 1e12, min_share = 0.1;
    SmallMinimum<parameters> found{.parameters_found = start};
    NormalEquations<parameters> here = evaluate(start);
    double damping = 0.0;
    while (found.iterations < max_rounds && damping < max_damping) {
        ++found.iterations;
        const Vector step = damped_step(here.normal, here.gradient, damping);
        if (!step.allFinite()) return found;
        const Vector next = found.parameters_found + step;
        // of the curve: a parameter may be 0
        const double change =
            std::sqrt(step.dot(here.normal * step) / found.parameters_found.dot(here.normal * found.parameters_found));
        const NormalEquations<parameters> there = evaluate(next);
        if (!(there.squares <= here.squares)) {
            if (change <= small) {
                found.converged = true;
                return found;
            }
            damping = std::max(10.0 * damping, 1e-4);
            continue;
        }
        const bool done =
            change <= rounding || (damping == 0.0 && far_below_errors(step, here.normal, there.squares, freedom));
        const double foreseen = 2.0 * step.dot(here.gradient) - step.dot(here.normal * step);
        const bool as_foreseen = here.squares - there.squares >= min_share * foreseen;
        found.parameters_found = next;
        here = there;
        if (!as_foreseen) damping = std::max(10.0 * damping, 1e-4);
        else damping = damping > 1e-6 ? 0.1 * damping : 0.0;
        if (!done) continue;
        found.converged = true;
        return found;
    }
    return found;
}

}  // namespace setae::loops
