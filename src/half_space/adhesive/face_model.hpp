// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "row_passes.hpp"
#include "setae/half_space/elastic_operator.hpp"

namespace setae::half_space {

/// The quadratic model of a cell's energy about a state, in the points that are free to move.
///
///   q(d) = G·d + ½ d·H d,  H d = K d + V'' d + c ⟨d⟩,  d = 0 outside the face, ⟨d⟩ = 0 where the mean is held
struct FaceProblem {
    const Array2D& gradient;  ///< G [Pa]
    const Array2D& slopes;    ///< V'' [Pa/m]
    const Array2D& face;      ///< 1 where free, else 0
    bool mean_held = true;
    double control_stiffness = 0.0;  ///< c [Pa/m] of what holds the mean
    double radius = 0.0;             ///< |d| <= radius [m]
    double tolerance = 0.0;          ///< rms of what is left of G + H d in the face [Pa]
    int most_iterations = 200;
};

/// How minimise() ended.
struct FaceOutcome {
    bool curves_down = false;  ///< along a direction, which was followed to the radius
    bool at_radius = false;
    double first_residual = 0.0;  ///< rms of G in the face, its mean taken off where held [Pa]
};

/// Minimises the model by conjugate gradients (Steihaug), preconditioned in the face by 1/(k + k(q_min)). Everything
/// rides along with the transforms: two pairs an iteration, no pass of its own.
class FaceModel {
public:
    FaceModel(const Array2D& shape, ElasticOperator& elastic, parallel::Threads threads);

    /// d and K d.
    FaceOutcome minimise(const FaceProblem& problem, Array2D& step, Array2D& stiff_step);

    /// K: k(q), 0 for the mean.
    [[nodiscard]] const fourier::Multiplier& stiffness() const { return stiffness_; }
    /// Pairs of transforms so far, with those of the owner.
    std::int64_t transforms = 0;

private:
    void precondition(const FaceProblem& problem, Array2D& step, Array2D& stiff_step, double length, double hold);
    void apply_hessian(const FaceProblem& problem, double along_last);
    /// How far along the direction |d| reaches the radius.
    [[nodiscard]] double reach(const Array2D& step, double radius);
    void move(Array2D& step, Array2D& stiff_step, double length);

    ElasticOperator* elastic_;
    fourier::Multiplier stiffness_, preconditioner_;
    RowPasses rows_;
    Array2D residual_, preconditioned_, direction_, stiff_direction_;
    // of the last preconditioning and of the last Hessian
    double mean_preconditioned_ = 0.0, product_ = 0.0, residual_power_ = 0.0, largest_ = 0.0;
    double curvature_ = 0.0, hold_ = 0.0, count_ = 0.0;
};

}  // namespace setae::half_space
