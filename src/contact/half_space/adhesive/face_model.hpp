// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "float_model.hpp"
#include "row_passes.hpp"
#include "setae/fourier/map_filter.hpp"
#include "setae/half_space/elastic_operator.hpp"

namespace setae::half_space {

/// The quadratic model of a cell's energy about a state, in the free points.
///
///   q(d) = G·d + ½ d·H d,  H d = K d + V'' d + c ⟨d⟩,  d = 0 outside the face, ⟨d⟩ = 0 for a fixed mean
struct FaceProblem {
    const Array2D& gradient;     ///< G [Pa] …
    double level = 0.0;          ///< … from here; of the face's mean for a fixed mean gap
    const MapOf<float>& slopes;  ///< V'' in the model's units
    const MapOf<float>& face;    ///< 1 where free, else 0
    double points = 0.0;         ///< number of points of the face
    bool mean_held = true;
    double control_stiffness = 0.0;  ///< stiffness c [Pa/m] of the control of the mean
    double radius = 0.0;             ///< |d| <= radius [m]
    double tolerance = 0.0;          ///< rms of the remainder G + H d in the face [Pa]
    int max_iterations = 200;
};

/// Result of minimise().
struct FaceOutcome {
    bool curves_down = false;  ///< along a direction, which was followed to the radius
    bool at_radius = false;
};

/// Minimises the model by conjugate gradients (Steihaug), preconditioned in the face by 1/(k + k(q_min)). All
/// operations are combined with the transforms: two pairs per iteration, without passes of their own. In float, which
/// halves the memory traffic: the result is a direction, whose energy the caller computes in double.
class FaceModel {
public:
    FaceModel(const Array2D& shape, const ElasticOperator& elastic, const ModelUnits& units, parallel::Threads threads);

    FaceOutcome minimise(const FaceProblem& problem);
    /// d and K d of the last minimum, a row [m], [Pa].
    [[nodiscard]] auto step(Index i) const { return units_.length * row(step_, i).cast<double>(); }
    [[nodiscard]] auto stiff_step(Index i) const { return units_.pressure * row(stiff_step_, i).cast<double>(); }

    /// Pairs of transforms so far.
    [[nodiscard]] std::int64_t transforms() const { return transforms_; }

private:
    using Real = float;

    /// In the model's units.
    struct Scaled {
        const MapOf<Real>&face, &slopes;
        bool mean_held;
        double control_stiffness;
        Real radius;
        double tolerance;
    };
    void load(const FaceProblem& problem);
    FaceOutcome descend(const Scaled& problem, int max_iterations);
    void precondition(const Scaled& problem, Real length, Real hold);
    void apply_hessian(const Scaled& problem, Real along_last);
    /// Distance along the direction at which |d| reaches the radius.
    [[nodiscard]] Real reach(Real radius);
    void move(Real length);

    fourier::MapFilterOf<Real> filter_;
    fourier::MultiplierOf<Real> stiffness_, preconditioner_;
    ModelUnits units_;
    RowPasses rows_;
    MapOf<Real> step_, stiff_step_, residual_, preconditioned_, direction_, stiff_direction_;
    std::int64_t transforms_ = 0;
    // of the last preconditioning and of the last Hessian
    double mean_preconditioned_ = 0.0, product_ = 0.0, residual_power_ = 0.0, largest_ = 0.0;
    double curvature_ = 0.0, hold_ = 0.0, count_ = 0.0;
};

/// k(q) of every mode, 0 for the mean.
[[nodiscard]] fourier::Multiplier stiffness_of_waves(const ElasticOperator& elastic);

}  // namespace setae::half_space
