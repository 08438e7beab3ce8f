// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/spectra/window.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::spectra {

/// |∫_0^L w h exp(−iqx) dx|²/L [m³] of a polyline: window times straight segments integrated exactly.
///
/// A window is a sum of cosines, w = Σ_s b_s e^{isκx}, s = −M … M, κ = 2π/L, so w h has the transform of h at the
/// wavevectors p_s = q − sκ. Two forms of the integral are used, each where it loses no digits:
///   q > q*:  i E_1 [h e^{−iqx}]_0^L + E_2 [h' e^{−iqx}]_0^L − Σ_k Δs_k Σ_s b_s e^{−ip_s x_k}/p_s²,
///            E_n = Σ_s b_s/p_s^n, Δs_k: change of slope at the inner point k;
///   q < q*:  Gauss points on the segments (6 on pieces with qd <= 1: exact to rounding), a sum of w h dx e^{−iqx};
/// q*² = Σ|Δs|/∫|h|dx, where both lose the same number of digits. Sums by fourier::nonuniform_transform: O(n + n_q + qL
/// log qL). Nothing is subtracted: remove the mean first. Inserting collinear points or shifting x changes nothing
/// (1e-10 of the mean level nearby; like any sum in doubles it cannot show levels 1e-20 below the highest).
/// profile: increasing x. wavevectors [1/m], any order and sign.
/// @throws InvalidArgument for a re-entrant profile, radial_hann or wavevectors that are not finite; UndefinedDataError
/// for undefined heights.
[[nodiscard]] Array1D polyline_power_spectrum(const topography::Profile& profile, const ArrayView1D& wavevectors,
                                              Window window = Window::hann, parallel::Threads threads = {});

}  // namespace setae::spectra
