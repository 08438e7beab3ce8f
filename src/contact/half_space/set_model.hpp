// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "float_model.hpp"
#include "row_passes.hpp"
#include "setae/fourier/map_filter.hpp"
#include "setae/half_space/elastic_operator.hpp"

namespace setae::half_space {

/// Stiffness of the longest wave [Pa/m], above 0 also for a map of one point.
[[nodiscard]] double softest_stiffness(const ElasticOperator& elastic);

/// Pressures of a set of points, and the remaining gaps: conjugate gradients that close them.
///
///   lower ½ d·G d − r·d in the set,  r the residual, d the decrease of pressures,  Σ d = 0 for a fixed load
///
/// preconditioned in the set by k(q). All operations are combined with the transforms: two pairs per iteration, without
/// passes of their own. In float, which halves the memory traffic: a set reduces its residual by a small factor, and
/// the caller computes the gaps of the pressures in double.
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
        double points = 0.0, square = 0.0;  ///< number of points of the set, and Σ r²
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
    std::optional<fourier::MapFilterOf<float>> periodic_filter_;  ///< filter of the preconditioner for free edges
    fourier::MultiplierOf<float> compliance_, stiffness_;
    RowPasses rows_;
    MapOf<float> face_, residual_, change_, direction_, response_;
    double curvature_ = 0.0;  ///< curvature along the last direction
    Index pairs_ = 0;
};

}  // namespace setae::half_space
