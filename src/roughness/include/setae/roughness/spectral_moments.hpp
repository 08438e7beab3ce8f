// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/core/arrays.hpp"
#include "setae/core/quantity.hpp"

namespace setae::roughness {

/// A one-dimensional power spectral density as a curve, piecewise a power law between its nodes.
struct SpectrumCurve {
    Array1D wavevector;  ///< q [1/m], increasing, > 0
    Array1D C1D;         ///< two-sided density averaged over ±q [m³], >= 0; nodes that are NaN are passed over
    Band band;           ///< [1/m] what the curve stands for; may reach past the outer nodes by one node distance
};

/// A radially averaged power spectral density of a map as a curve, piecewise a power law between its nodes.
struct IsotropicCurve {
    Array1D wavevector;  ///< q [1/m], increasing, > 0
    Array1D C_iso;       ///< [m⁴], >= 0; nodes that are NaN are passed over
    Band band;           ///< as in SpectrumCurve
};

/// Wavelengths between which integrals run; absent ends leave the curve's own band.
struct WavelengthLimits {
    std::optional<double> longest;   ///< [m]: q >= 2π/longest
    std::optional<double> shortest;  ///< [m]: q <= 2π/shortest
};

/// The curve with its band cut to the limits.
/// @throws InvalidArgument where nothing is left, or longest <= shortest.
[[nodiscard]] SpectrumCurve limited(SpectrumCurve curve, const WavelengthLimits& limits);

/// How two-dimensional parameters follow from C1D.
enum class Conversion {
    exact,  ///< moment identities of isotropic surfaces: ∫ q^{n+1} C_iso dq = π k_n ∫ q^n C1D dq
    eq11,   ///< C_iso ≈ π C1D/(q √(1 − (q/q_s)²)), q_s the upper end of the band: the way of [D19]
};

/// Integral ∫ q^order w(q) C1D dq [m^(3 − order − 1)] over the band; w = 1 (exact) or 1/√(1 − (q/q_s)²) (eq11).
/// Between nodes C1D is a power law; beyond the outer nodes the outermost one continues.
/// @throws UndefinedDataError for fewer than two usable nodes in the curve.
[[nodiscard]] double spectral_integral(const SpectrumCurve& curve, double order, Conversion conversion = Conversion::exact);

/// Parameters of an isotropic surface from C1D.
///
///   h_rms² = (1/π) ∫ C1D dq,   h'² = (2/π) ∫ q² C1D dq,   h''² = (2/3π) ∫ q⁴ C1D dq,   U_el/(A_app E*) = (1/8) ∫ q C1D dq
///
/// with eq11: h_rms² = ½ ∫ w C1D dq, h'² = ½ ∫ q² w C1D dq, h''² = (1/8) ∫ q⁴ w C1D dq, U_el/(A_app E*) = (1/8) ∫ q w C1D dq.
/// h' = sqrt⟨|∇h|²⟩, h'' = sqrt⟨(½∇²h)²⟩.  Source: THEORY §4.1; [D19] (8), (11).
struct SpectralParameters {
    double rms_height = 0.0;                  ///< [m]
    double rms_slope = 0.0;                   ///< [1]
    double rms_curvature = 0.0;               ///< [1/m]
    double elastic_energy_per_modulus = 0.0;  ///< U_el/(A_app E*) [m]
};

[[nodiscard]] SpectralParameters spectral_parameters(const SpectrumCurve& curve, Conversion conversion = Conversion::exact);

/// The same from C_iso: h_rms² = (1/2π) ∫ q C dq, h'² = (1/2π) ∫ q³ C dq, h''² = (1/8π) ∫ q⁵ C dq,
/// U_el/(A_app E*) = (1/8π) ∫ q² C dq.  Source: THEORY §4, [D19] (8).
[[nodiscard]] SpectralParameters spectral_parameters(const IsotropicCurve& curve);

/// Parameters of the part of the surface with wavevectors below (or above) each of the given ones.
struct CumulativeParameters {
    Array1D wavevector;                  ///< [1/m]
    Array1D rms_height;                  ///< of wavevectors below q [m]
    Array1D rms_slope;                   ///< of wavevectors below q
    Array1D rms_curvature;               ///< of wavevectors below q [1/m]
    Array1D elastic_energy_per_modulus;  ///< of wavevectors below q [m]
};

/// At the nodes inside the band and its two ends. The last entry equals spectral_parameters.
[[nodiscard]] CumulativeParameters cumulative_parameters(const SpectrumCurve& curve);

}  // namespace setae::roughness
