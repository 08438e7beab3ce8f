// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/roughness/spectral_moments.hpp"
#include "setae/spectra/spectral_density.hpp"

namespace setae::simulation {

/// A surface whose properties all follow from its spectrum and skewness.
///
/// Heights are h = h_rms g(z), z the Gaussian surface of unit variance with spectrum C_iso/h_rms². g is the identity
/// without skewness, else the log-normal function of that skewness.
struct KnownSurface {
    std::string name;
    std::string description;
    spectra::SpectralDensity C_iso;   ///< spectrum of the Gaussian surface h_rms z [m⁴]
    double rolloff_wavelength = 0.0;  ///< wavelength above which C_iso is flat [m]
    double short_wavelength = 0.0;    ///< wavelength below which C_iso is zero [m]
    double skewness = 0.0;            ///< skewness of the heights
    spectra::Anisotropy anisotropy;   ///< stretch >= 1; for Gaussian heights only

    [[nodiscard]] bool gaussian() const { return skewness == 0.0; }
    [[nodiscard]] bool isotropic() const { return anisotropy.stretch == 1.0; }
    [[nodiscard]] Band band() const;  ///< 2π divided by the two wavelengths [1/m]
};

/// True values for measurements of a surface.
struct TrueSurfaceValues {
    roughness::SpectralParameters parameters;
    double area_ratio = 1.0;  ///< A_true/A_app
    /// spectrum of lines, mean over directions; 20 nodes per decade from 1/100 of the roll-off wavevector to the short
    /// cutoff
    spectra::Spectrum C1D;
    std::string source;  ///< method of the computation
};

/// Moments and true area of a surface.
///
/// Gaussian: integrals of C_iso (exact to 1e-6) and [D19], Eq. 9.
/// Otherwise, with z and ∇z independent of each other at a point, s = h'_z/h_rms and ⟨(∇²z)²⟩ = v + s⁴,
///
///   h'² = ⟨g'²⟩ h'_z²,   A_true/A_app = ⟨r(|g'(z)| h'_z)⟩ with r of Eq. 9,
///   h''² = ¼ h_rms² ⟨g'² (v + s⁴z²) − 2 g'g'' s⁴ z + 2 g''² s⁴⟩,   U_el/(A E*) = ¼ ∫ [R(0) − R(r)]/r² dr,
///
/// A stretched surface has the moments of its angle-averaged spectrum, and the true area of Gaussian slopes that differ
/// along and across. R(r) = h_rms² Σ_n c_n² ρ(r)^n the autocorrelation of the heights
/// (synthesis::TransformCorrelation), ρ that of z; the energy to 1e-3, the rest as above. C1D is empty then. Cost: 10
/// to 20 ms, mostly for C1D.
/// @throws InvalidArgument for wavelengths that contradict each other or a spectrum that is not positive and finite.
/// Source: cov(z, ∇²z) = −s², ∫ (1 − J0(qr))/r² dr = q.
[[nodiscard]] TrueSurfaceValues true_surface_values(const KnownSurface& surface);

/// True values of only the waves in a band [1/m], such as those not longer than the longest scan; C1D stays the whole
/// curve. For transformed heights the band must contain all waves shorter than the roll-off, and only the rms height
/// changes.
/// @throws InvalidArgument as above and for such a band.
[[nodiscard]] TrueSurfaceValues true_surface_values(const KnownSurface& surface, const Band& band);

}  // namespace setae::simulation
