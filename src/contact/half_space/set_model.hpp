// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "float_model.hpp"
#include "row_passes.hpp"
#include "setae/fourier/map_filter.hpp"
#include "setae/half_space/elastic_operator.hpp"

namespace setae::half_space {

/// Of the longest wave [Pa/m], above 0 for a map of one point, too.
[[nodiscard]] double softest_stiffness(const ElasticOperator& elastic);

/// Pressures of a set of points, and what is left of their gaps: conjugate gradients that close them.
///
///   lower ½ d·G d − r·d in the set,  r the residual, d what the pressures lose,  Σ d = 0 where the load is held
///
/// preconditioned in the set by k(q). Everything rides along with the transforms: two pairs an iteration, no pass of
/// its own. In float, which halves the traffic: sets reduce their residual by little, and the caller finds the gaps of
/// the pressures anew in double.
class SetModel {
public:
    /// compliance: G, a multiplier of `response`. `preconditioner`: of periodic edges; may be the same.
    SetModel(const ElasticOperator& response, const fourier::Multiplier& compliance,
             const ElasticOperator& preconditioner, const ModelUnits& units, const Array2D& shape,
             parallel::Threads threads);

    /// 1 in the set, else 0, and the residual, 0 outside the set, in units of length; the caller writes both before
    /// reduce().
    [[nodiscard]] RowOf<float> face(Index i) { return row(face_, i); }
    [[nodiscard]] RowOf<float> residual(Index i) { return row(residual_, i); }
    /// d, in units of pressure; the caller may add to it.
    [[nodiscard]] RowOf<float> change(Index i) { return row(change_, i); }

    struct Aim {
        double points = 0.0, square = 0.0;  ///< of the set: how many, and Σ r²
        bool load_held = true;
        double reduction = 0.25;  ///< of √Σ r², that ends it
        Index max_iterations = 16;
        bool remembers = false;  ///< the first direction is conjugate to the last one of the set before
    };
    /// @returns how many iterations it took.
    Index reduce(const Aim& aim);
    /// The next set's first direction is its own.
    void forget() { curvature_ = 0.0; }

    /// Pairs of transforms so far.
    [[nodiscard]] Index transform_pairs() const { return pairs_; }

private:
    struct Preconditioned {
        double sum = 0.0;       ///< Σ z
        double coupling = 0.0;  ///< Σ z w, w the response to the last direction
        double response = 0.0;  ///< Σ w in the set
    };
    struct Response {
        double work = 0.0;       ///< Σ t w
        double sum = 0.0;        ///< Σ w in the set, as the next two
        double square = 0.0;     ///< Σ w²
        double product = 0.0;    ///< Σ r w
        double direction = 0.0;  ///< Σ t
        double slope = 0.0;      ///< Σ r t
    };
    Preconditioned precondition(float step, float mean_response);
    Response respond(float mean, float memory);
    void move(float step);

    fourier::MapFilterOf<float> filter_;
    std::optional<fourier::MapFilterOf<float>> periodic_filter_;  ///< of the preconditioner where edges are free
    fourier::MultiplierOf<float> compliance_, stiffness_;
    RowPasses rows_;
    MapOf<float> face_, residual_, change_, direction_, response_;
    double curvature_ = 0.0;  ///< of the last direction
    Index pairs_ = 0;
};

}  // namespace setae::half_space
