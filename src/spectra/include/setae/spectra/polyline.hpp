// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/spectra/window.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::spectra {

/// |∫_0^L w h exp(−iqx) dx|²/L [m³] of a polyline: window times straight segments integrated exactly.
///
/// A window is a sum of cosines, so its product with h has the transform of h at q and at q ± 2πm/L. Two forms of the
/// integral are used, each where it loses no digits:
///   q > q*: −Σ_k Δs_k Σ_m a_m e^{−i(q−mκ)x_k}/(q−mκ)² + end terms, Δs_k the change of slope at point k, κ = 2π/L;
///   q < q*: Gauss points on the segments (6 on pieces with qd <= 1: exact to rounding), as a sum of w h dx e^{−iqx};
/// q*² = Σ|Δs|/∫|h|dx, where both lose the same. Sums by fourier::nonuniform_transform: O(n + n_q + qL log qL).
/// Nothing is subtracted: remove the mean first. Inserting collinear points or shifting x changes nothing (1e-10).
/// profile: increasing x. wavevectors [1/m], any order.
/// @throws InvalidArgument for a re-entrant profile or radial_hann, UndefinedDataError for undefined heights.
[[nodiscard]] Array1D polyline_power_spectrum(const topography::Profile& profile, const ArrayView1D& wavevectors,
                                              Window window = Window::hann, parallel::Threads threads = {});

/// The part of C1D(q) that straight segments between sampled points keep.
///
/// For equal steps d it is sinc⁴(qd/2), sinc x = sin x/x. For steps d_k of any length a wave e^{iqx} sampled at the
/// points and joined by segments has the component Σ d_k sinc²(qd_k/2)/L at q itself; the rest scatters to other
/// wavevectors, and what scatters into q from a spectrum that is flat nearby restores the variance of the segments:
///   see polyline.cpp for the derivation; result between 0 and 1 for q <= π/(mean step).
[[nodiscard]] Array1D segment_response(const ArrayView1D& positions, const ArrayView1D& wavevectors);

}  // namespace setae::spectra
