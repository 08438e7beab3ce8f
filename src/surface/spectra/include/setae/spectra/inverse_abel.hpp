// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"
#include "setae/spectra/combination.hpp"

namespace setae::spectra {

struct InverseAbelOptions {
    /// Width, in decades, of the parabola fitted to ln C1D around each wavevector, with weights from the errors that
    /// decrease with distance, and a line at both ends; 0: interpolation, with the slope of the parabola through a
    /// value and its neighbours.
    double smoothing = 0.0;
};

/// C_iso of an isotropic surface from the spectrum of lines on it: NaN if C1D rises so that no isotropic surface has
/// it. Its standard error assumes independent errors of C1D and is NaN if they are unknown.
struct IsotropicFromLines : Spectrum {
    Array1D ratio;  ///< C_iso over the approximation π C1D/q
};

/// The inverse Abel transform of C1D.
///
///   C1D(q) = (1/π) ∫_q^∞ C_iso(p) p dp/√(p² − q²)
///   C_iso(q) = −2 ∫_q^∞ C1D'(p) dp/√(p² − q²) = (2/q) ∫_0^{π/2} α C1D(q/sin θ) dθ
///
/// α = −dlnC1D/dlnp. Between wavevectors ln C1D is a cubic in ln p with the values and slopes above, beyond the last a
/// power law with its slope. If C_iso ends at q_s shortly after the last wavevector, values within a factor of two of
/// it are too large. For C1D ∝ q^−α the ratio to π C1D/q is (2/√π) Γ((α+1)/2)/Γ(α/2): 1 at α = 2, 0.94 at 1.8, 1.09 at
/// 2.3, 1.17 at 2.6. wavevector: increasing, > 0 [1/m].  C1D > 0 [m³].  standard_error: of C1D [m³], empty if unknown.
/// @throws InvalidArgument for fewer than four wavevectors, sizes that differ, or values outside the domain.
/// Source: Bracewell, The Fourier Transform and its Applications (2000), ch. 13; slopes and errors derived here. Cost:
/// n² operations and n² numbers for n wavevectors.
[[nodiscard]] IsotropicFromLines isotropic_from_lines(const ArrayView1D& wavevector, const ArrayView1D& C1D,
                                                      const ArrayView1D& standard_error = Array1D(),
                                                      const InverseAbelOptions& options = {});

/// Inverse Abel transform of a combined spectrum. Bins of one measurement have the relative error of the nearest bin of
/// several.
[[nodiscard]] IsotropicFromLines isotropic_from_lines(const CombinedSpectrum& spectrum,
                                                      const InverseAbelOptions& options = {.smoothing = 0.6});

}  // namespace setae::spectra
