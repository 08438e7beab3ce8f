// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/roughness/spectral_moments.hpp"
#include "setae/spectra/spectral_density.hpp"

namespace setae::simulation {

/// A surface whose every property follows from what is written here.
///
/// Heights are h = h_rms g(z), z the Gaussian surface of unit variance with spectrum C_iso/h_rms². g is the identity
/// without skewness, else the log-normal function of that skewness.
struct KnownSurface {
    std::string name;
    std::string description;
    spectra::SpectralDensity C_iso;   ///< of the Gaussian surface h_rms z [m⁴]
    double rolloff_wavelength = 0.0;  ///< beyond it C_iso is flat [m]
    double short_wavelength = 0.0;    ///< below it C_iso is zero [m]
    double skewness = 0.0;            ///< of the heights
    spectra::Anisotropy anisotropy;   ///< stretch >= 1; of Gaussian heights alone

    [[nodiscard]] bool gaussian() const { return skewness == 0.0; }
    [[nodiscard]] bool isotropic() const { return anisotropy.stretch == 1.0; }
    [[nodiscard]] Band band() const;  ///< 2π over the two wavelengths [1/m]
};

/// What measurements of a surface should find.
struct SurfaceTruth {
    roughness::SpectralParameters parameters;
    double area_ratio = 1.0;  ///< A_true/A_app
    spectra::Spectrum C1D;    ///< of lines, mean over directions; 20 nodes a decade from 1/100 of the roll-off
                              ///< wavevector to the short cutoff
    std::string source;       ///< how the numbers came about
};

/// Moments and true area of a surface.
///
/// Gaussian: integrals of C_iso (exact to 1e-6) and [D19] (9).
/// Otherwise, with z and ∇z independent of each other at a point, s = h'_z/h_rms and ⟨(∇²z)²⟩ = v + s⁴,
///
///   h'² = ⟨g'²⟩ h'_z²,   A_true/A_app = ⟨r(|g'(z)| h'_z)⟩ with r of (9),
///   h''² = ¼ h_rms² ⟨g'² (v + s⁴z²) − 2 g'g'' s⁴ z + 2 g''² s⁴⟩,   U_el/(A E*) = ¼ ∫ [R(0) − R(r)]/r² dr,
///
/// A stretched surface has the moments of its angle-averaged spectrum, and the true area of Gaussian slopes that differ
/// along and across. R(r) = h_rms² Σ_n c_n² ρ(r)^n the autocorrelation of the heights
/// (synthesis::TransformCorrelation), ρ that of z; the energy to 1e-3, the rest as above. C1D is then left empty. Cost:
/// 10 to 20 ms, C1D most of it.
/// @throws InvalidArgument for wavelengths that contradict each other or a spectrum that is not positive and finite.
/// Source: cov(z, ∇²z) = −s², ∫ (1 − J0(qr))/r² dr = q.
[[nodiscard]] SurfaceTruth surface_truth(const KnownSurface& surface);

/// The same of the waves in a band [1/m] alone, such as those not longer than the longest scan; C1D stays the whole
/// curve. Of transformed heights the band must hold all waves shorter than the roll-off, and only the rms height
/// changes.
/// @throws InvalidArgument as above and for such a band.
[[nodiscard]] SurfaceTruth surface_truth(const KnownSurface& surface, const Band& band);

}  // namespace setae::simulation
