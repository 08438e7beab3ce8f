// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/scales/function_of_scale.hpp"
#include "setae/spectra/options.hpp"

namespace setae::scales {

/// What a line is a line of.
enum class SurfaceKind {
    isotropic,  ///< a surface with the same statistics in every direction
    grating,    ///< a surface that does not change across the line
};

/// Variance of the half derivative, ⟨|∇^½ h|²⟩ = Σ |q| ⟨|h_q|²⟩ [m], and the energy that flattens the surface.
struct HalfDerivative {
    double variance = 0.0;   ///< [m]
    std::string assumption;  ///< "none" for maps, else "isotropic" or "grating"
    std::vector<Alert> alerts;

    /// Elastic energy of conformal contact per apparent area, U_el/A = E*/4 ⟨|∇^½ h|²⟩ [J/m²]. contact_modulus: E*
    /// [Pa]. A cosine of amplitude h0 and wavevector q: E* q h0²/8.  Source: [P01] Persson, J. Chem. Phys. 115 (2001)
    /// 3840.
    [[nodiscard]] double energy_per_area(double contact_modulus) const { return 0.25 * contact_modulus * variance; }
};

/// Of a map from its transform: Σ |q| C2D/A over all modes. Any surface kind.
///
/// Periodic maps: mean removed, no window. Others: tilt removed, window by `options.window`, so that neither offset nor
/// tilt counts.
/// @throws UndefinedDataError if a height is undefined.
[[nodiscard]] HalfDerivative half_derivative_variance(const topography::HeightMap& map,
                                                      spectra::Window window = spectra::Window::automatic,
                                                      parallel::Threads threads = {});

/// Of a line scan: isotropic ½ ∫ q C1D dq, grating (1/π) ∫ q C1D dq, π/2 less. The line alone cannot tell them apart.
[[nodiscard]] HalfDerivative half_derivative_variance(const topography::LineScan& scan, SurfaceKind kind,
                                                      spectra::Window window = spectra::Window::automatic);

/// From an autocorrelation.
///
///   ∫_0^∞ A(r)/r² dr
///
/// of lines: isotropic as it stands, grating 2/π of it. Of the area (kind ignored): any surface. Between nodes A is a
/// power law; below the first node r0 it is taken to grow as r², which adds A(r0)/r0; beyond the last it is h_rms²,
/// which adds h_rms²/r_last. rms_height: h_rms of the same data [m].
/// @throws InvalidArgument for an empty function or another quantity.
/// Source: Wang, Müser, Tribol. Int. 123 (2018) 224.
[[nodiscard]] HalfDerivative half_derivative_from_autocorrelation(const FunctionOfScale& autocorrelation,
                                                                  double rms_height, SurfaceKind kind);

}  // namespace setae::scales
