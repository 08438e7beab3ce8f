// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"
#include "setae/spectra/combination.hpp"

namespace setae::spectra {

/// C_iso of an isotropic surface from the spectrum of lines through it.
struct IsotropicFromLines {
    Array1D wavevector;      ///< [1/m]
    Array1D C_iso;           ///< [m⁴]; NaN where the lines' spectrum does not fall, so that no surface has it
    Array1D standard_error;  ///< [m⁴], from the errors of C1D taken as independent; NaN where they are unknown
    Array1D ratio;           ///< C_iso over the approximation π C1D/q
};

/// The inverse Abel transform of C1D.
///
///   C1D(q) = (1/π) ∫_q^∞ C_iso(p) p dp/√(p² − q²)   ⇔   C_iso(q) = −2 ∫_q^∞ C1D'(p) dp/√(p² − q²)
///
/// C1D is a power law between wavevectors and goes on beyond the last with the last one's exponent (of the upper third of the
/// decade), or ends there, `ends`: C1D ∝ √(q_s² − q²) close to q_s = last wavevector. Where C1D is noisy its slope is taken from power laws through bins `smoothing`
/// decades wide (least squares in the logarithm, weighted with the errors); 0 uses neighbouring wavevectors, exact for smooth curves.
/// wavevector: increasing, > 0 [1/m].  C1D > 0 [m³].  standard_error: of C1D [m³], empty where unknown.
/// @throws InvalidArgument for fewer than four wavevectors or arguments outside the domain.
/// Source: Bracewell, The Fourier Transform and its Applications (2000), ch. 13; error propagation derived here.
struct InverseAbelOptions {
    double smoothing = 0.0;  ///< width of a local power law in decades, >= 0
};
[[nodiscard]] IsotropicFromLines isotropic_from_lines(const ArrayView1D& wavevector, const ArrayView1D& C1D, const ArrayView1D& standard_error,
                                                      const InverseAbelOptions& options = {});

/// Of a combined spectrum: local power laws over a third of a decade.
[[nodiscard]] IsotropicFromLines isotropic_from_lines(const CombinedSpectrum& spectrum, const InverseAbelOptions& options = {.smoothing = 1.0 / 3.0});

}  // namespace setae::spectra
