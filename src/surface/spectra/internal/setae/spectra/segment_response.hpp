// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::spectra {

/// Effect of linear interpolation between sampled points on a spectrum: C1D of the segments over C1D of the curve.
///
/// A wave e^{ipx} sampled at the ends of a segment of length d and joined by a line has over that segment the part
///   κ(q, p) = cos(pd/2) sinc(qd/2) + sin(pd/2) j(qd/2),  sinc x = sin x/x,  j x = (sinc x − cos x)/x
/// along e^{iqx}; κ(q, q) = sinc². For steps d_k in random order a curve of spectrum C(p) gives on average
///
///   R(q) = m(q)² + ∫_{−Q}^{Q} V(q, p) C(p)/C(q) dp/2π,   m = ⟨d sinc²(qd/2)⟩/⟨d⟩,
///   V(q, p) = ⟨|d κ(q, p) − M d sinc(δd/2)|²⟩/⟨d⟩,   δ = p − q,   M = iδ ⟨d κ e^{iδd/2}⟩/(⟨e^{iδd}⟩ − 1):
///
/// the power remaining at q, and the power scattered into q by irregular steps. Equal steps scatter nothing: R = sinc⁴.
/// ⟨⟩ is the mean over the actual steps (in 32 groups of similar steps), Q = π/⟨d⟩ the end of the band: power of the
/// curve beyond it is unknown and not corrected (aliasing). C(p) ∝ |p|^−n near q, n from the data. Derived from the
/// transform of the polyline, steps independent of each other; checked against sampled random lines.
class SegmentResponse {
public:
    /// positions: increasing [m], at least two.
    explicit SegmentResponse(const ArrayView1D& positions);

    /// R at q >= 0 for C ∝ |p|^−n. @throws InvalidArgument for n outside 0 … 4.9.
    [[nodiscard]] Array1D at(const ArrayView1D& wavevectors, double exponent) const;

    /// n of the curve whose segments have the given spectrum, from a line through ln(C/R) over ln q between 0.1 Q and
    /// Q, limited to 0 … 4.9; 2 for fewer than three wavevectors.
    [[nodiscard]] double fitted_exponent(const ArrayView1D& wavevectors, const ArrayView1D& segment_spectrum) const;

    [[nodiscard]] double band_end() const { return band_end_; }  ///< Q [1/m]

private:
    [[nodiscard]] double kept(double wavevector) const;
    [[nodiscard]] Array1D scattered(double exponent) const;

    double band_end_ = 0.0;
    Array1D steps_;    ///< representative steps, each for the same number of steps
    Array1D nodes_q_;  ///< wavevectors of the table of V
    Array1D nodes_p_;  ///< points of the integral over p
    Array1D weights_p_;
    Array2D scattering_;  ///< V(q, p)
};

}  // namespace setae::spectra
