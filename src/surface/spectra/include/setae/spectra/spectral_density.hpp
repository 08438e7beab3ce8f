// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "setae/core/arrays.hpp"
#include "setae/core/quantity.hpp"
#include "setae/spectra/self_affine.hpp"

namespace setae::spectra {

/// A power spectrum as a function of the wavevector q >= 0 [1/m]: C_iso [m⁴] for surfaces, C1D [m³] for lines. Finite,
/// >= 0; may be called from several threads simultaneously.
using SpectralDensity = std::function<double(double)>;

/// Stretched isotropy: features `stretch` times longer along the direction `angle` than across it.
///
///   C2D(q) = s C_iso(√((s q_∥)² + q_⊥²)),  s = stretch, q_∥ along (cos angle, sin angle)
///
/// Keeps the rms height of C_iso.
struct Anisotropy {
    double stretch = 1.0;  ///< s > 0; 1 is isotropic
    double angle = 0.0;    ///< of the long direction against x [rad]
};

/// C_iso of a self-affine model. Surfaces are generated only for 0 < H <= 1: a self-affine fractal has no other H.
/// @throws InvalidArgument for H outside (0, 1], q_s <= q_r (λ_s >= λ_r), or a plateau that is not positive.
[[nodiscard]] SpectralDensity density(const SelfAffine& model);

/// A measured spectrum: power laws between the nodes, constant below the first, zero above the last.
///
/// wavevector: increasing, > 0 [1/m].  spectrum: >= 0 and finite; if one of two neighbours is 0 the curve between them
/// is linear.
/// @throws InvalidArgument for sizes that differ, fewer than two nodes, or values outside the domain, by row.
[[nodiscard]] SpectralDensity tabulated_density(const ArrayView1D& wavevector, const ArrayView1D& spectrum);

/// C_iso of the isotropic surface whose lines have a tabulated C1D: isotropic_from_profile() up to the cutoff of the
/// surface at the next wavevector after the table, q_n²/q_{n−1}; the last power law continues to it.
///
/// wavevector: increasing, > 0 [1/m].  C1D > 0 [m³].
/// @throws InvalidArgument as isotropic_from_profile().
[[nodiscard]] SpectralDensity surface_density(const ArrayView1D& wavevector, const ArrayView1D& C1D);

/// C1D of lines through an isotropic surface.
///
///   C1D(q_x) = (1/π) ∫_{q_x}^{q_s} C_iso(q) q dq/√(q² − q_x²)
///
/// band [1/m]: C_iso is tabulated over it, up to 1280 nodes per decade where it is curved, power laws between, with its
/// bends and jumps located; it is constant below the band and zero above it (and above its first zero). C1D is not
/// constant below the band: it still rises there by up to two thirds. Relative error below 3e-5 up to the cutoff, 1e-4
/// close to jumps; if C_iso falls to zero without a jump 1e-2 within the last per cent. Cost: 0.5 ms for five decades
/// of power laws, 10 ms of other curves.
/// @throws InvalidArgument unless 0 < lower < upper and C_iso > 0 from lower on.
[[nodiscard]] SpectralDensity profile_density(const SpectralDensity& C_iso, const Band& band);

/// ∫ q^(n+1) C dq over the band [m^(2−n) for C_iso]: h_rms² = moment 0/2π, h'_rms² = moment 2/2π.
///
/// Gauss points in ln q, twenty in each twentieth of a decade; a jump of C inside the band causes an error of up to a
/// few per cent of one such piece.  order: n.  @throws InvalidArgument unless 0 < lower < upper.
[[nodiscard]] double moment(const SpectralDensity& density, double order, const Band& band);

}  // namespace setae::spectra
