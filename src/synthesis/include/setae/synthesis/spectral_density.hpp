// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "setae/core/arrays.hpp"
#include "setae/core/quantity.hpp"
#include "setae/synthesis/model_spectra.hpp"
#include "setae/synthesis/self_affine.hpp"

namespace setae::synthesis {

/// A power spectrum as a function of the wavevector [1/m]: C_iso [m⁴] of surfaces, C1D [m³] of lines; finite, >= 0.
/// Called from several threads at once.
using SpectralDensity = std::function<double(double)>;

/// C_iso of a model. @throws InvalidArgument that says which parameters contradict each other: q_s <= q_r (λ_s >= λ_r),
/// H outside (0, 1], a crossover outside (q_r, q_s), values that are negative, zero or not finite.
[[nodiscard]] SpectralDensity density(const SelfAffine& model);
[[nodiscard]] SpectralDensity density(const SoftCutoff& model);
[[nodiscard]] SpectralDensity density(const TwoSlopes& model);
[[nodiscard]] SpectralDensity density(const Bump& model);

/// The power law between neighbouring nodes, constant below the first, zero above the last.
/// wavevector: increasing, > 0 [1/m]. power_spectrum: C_iso [m⁴] or C1D [m³], >= 0; zero on both sides of a node with 0.
/// @throws InvalidArgument for fewer than two nodes, sizes that differ, or a node that breaks the domain, with its index.
[[nodiscard]] SpectralDensity tabulated_density(const ArrayView1D& wavevector, const ArrayView1D& power_spectrum);

/// C1D of straight lines on an isotropic surface, by the Abel integral of C_iso over the band, tabulated once.
///
///   C1D(q_x) = (1/π) ∫_{q_x}^{q_s} C_iso(q) q dq/√(q² − q_x²)
///
/// band: lower [1/m]: C_iso is constant below; upper q_s [1/m]: zero above, C_iso > 0 up to there.
/// Relative error below 1e-4 (where C_iso has kinks; 1e-6 elsewhere).
/// @throws InvalidArgument for an empty band or a C_iso that is not positive and finite in it.
[[nodiscard]] SpectralDensity profile_density(const SpectralDensity& C_iso, const Band& band);
[[nodiscard]] SpectralDensity profile_density(const SelfAffine& model);

/// ∫ q^(n+1) C dq over the band [m^(2−n) for C_iso], by Gauss points in ln q; h_rms² = moment 0/2π, slope² = moment 2/2π.
/// A jump of C inside the band costs up to 1/400 of the integrand there. @throws InvalidArgument for an empty band.
[[nodiscard]] double moment(const SpectralDensity& density, double order, const Band& band);

/// Stretches a surface without changing its rms height.
///
///   C2D(q) = C_iso(√((s q_∥)² + (q_⊥/s)²))
///
/// stretch: s > 0, features are s times longer along the direction and s times shorter across. angle: of that direction
/// to the x axis [rad].
struct Anisotropy {
    double stretch = 1.0;
    double angle = 0.0;
};

}  // namespace setae::synthesis
