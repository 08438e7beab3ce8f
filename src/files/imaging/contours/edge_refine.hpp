// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "edge_band.hpp"
#include "edge_shape.hpp"
#include "setae/imaging/contour_trace.hpp"

namespace setae::imaging {

/// A curve fitted to the edge.
struct RefinedEdge {
    PlaneCurve curve;
    Array1D standard_error;  ///< of each point along the normal [px]; infinite if the edge was lost
    EdgeShape shape;
    double blur = 0;               ///< width of the shape without the contribution of the trace error [px]
    double noise_density = 0;      ///< of places before smoothing [px³]
    double smoothing_length = 0;   ///< [px]
    double contrast_to_noise = 0;  ///< step with slope and width of the edge, over the noise of a pixel on either side
    bool converged = false;
};

/// Moves a curve a few pixels away onto the edge.
///
/// Each pixel p near the curve measures the displacement δ along the normal by the shape I(d) (edge_shape.hpp) with a
/// local level and contrast; the curve X + δn minimises
///
///   Σ_p (I_p − a − b I(d_p) + b I'(d_p) δ(s_p))²/σ²(d_p) + Σ_k ι ℓ⁴ |X_{k+1} − 2X_k + X_{k−1}|²
///
/// ι: the sum of b²I'²/σ² of one point: at convergence a wave of the edge is followed by K(q) = 1/(1 + ℓ⁴ (2 − 2 cos
/// q)²), q per px. Repeated until convergence, with shape and scatter σ(d) renewed. ℓ, if not given, minimises the
/// expected error ∫ [(1 − K)² S + K² N] dq, S: spectrum of the places before smoothing minus N. The noise N is measured
/// by the same sums a few pixels from the edge on either side, which include structure of the sample and noise
/// correlated between neighbours. Convergence: 19 points in 20 move by less than 0.02 px; the last movement of a point
/// is added to its error.
[[nodiscard]] RefinedEdge refined_edge(EdgeBand& band, const PlaneCurve& start, const std::vector<Anchor>& anchors,
                                       std::optional<double> smoothing_length);

}  // namespace setae::imaging
