// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "setae/core/arrays.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/quantity.hpp"
#include "setae/spectra/spectrum.hpp"

namespace setae::roughness {

/// Wavelength limits of integrals; without limits the band of the curve applies.
struct WavelengthLimits {
    std::optional<double> longest;   ///< [m]: q >= 2π/longest
    std::optional<double> shortest;  ///< [m]: q <= 2π/shortest
};

/// The curve with its band restricted to the limits.
/// @throws InvalidArgument if nothing remains, or longest <= shortest.
[[nodiscard]] spectra::Spectrum limited(spectra::Spectrum curve, const WavelengthLimits& limits);

/// Values of the curve at wavevectors inside its band, NaN outside; for modes the value of the nearest mode.
[[nodiscard]] Array1D values_at(const spectra::Spectrum& curve, const ArrayView1D& wavevector);

/// Calculation of two-dimensional parameters from C1D.
enum class Conversion {
    exact,  ///< inverse Abel integral, then the cut; for modes the identities ∫ q^{n+1} C_iso dq = π k_n ∫ q^n C1D dq
    eq11,  ///< C_iso ≈ π C1D/(q √(1 − (q/q_s)²)), q_s the upper end of the band, as in [D19]
};

/// C1D by decade: element d is the geometric mean over ln q between 10^(4+d) and 10^(5+d) 1/m [m³], NaN if the curve
/// does not span that decade.
using DecadeMeans = std::array<double, 6>;
inline constexpr int first_decade = 4;
inline constexpr DecadeMeans no_decades{undefined, undefined, undefined, undefined, undefined, undefined};

/// @throws UndefinedDataError for fewer than two usable nodes in the curve.
[[nodiscard]] DecadeMeans decade_means(const spectra::Spectrum& C1D);

/// Parameters of an isotropic surface.
///
///   h_rms² = (1/2π) ∫ q C_iso dq,   h'² = (1/2π) ∫ q³ C_iso dq,   h''² = (1/8π) ∫ q⁵ C_iso dq,
///   U_el/(A_app E*) = (1/8π) ∫ q² C_iso dq
///
/// For C1D: C_iso by the inverse Abel integral of the whole curve, extrapolated from its last node to waves_end, then
/// only the waves of the band (cut_moments.hpp). For modes, whose powers are summed individually: h_rms² = (1/π) ∫ C
/// dq, h'² = (2/π) ∫ q² C dq, h''² = (2/3π) ∫ q⁴ C dq, U_el/(A_app E*) = (1/8) ∫ q C dq, exact over 0 … ∞.
///
/// h' = sqrt⟨|∇h|²⟩, h'' = sqrt⟨(½∇²h)²⟩.  Source: THEORY §4, §4.1; [D19] Eqs. (8), (11).
struct SpectralParameters {
    double rms_height = 0.0;                  ///< [m]
    double rms_slope = 0.0;                   ///< [1]
    double rms_curvature = 0.0;               ///< [1/m]
    double elastic_energy_per_modulus = 0.0;  ///< U_el/(A_app E*) [m]
    DecadeMeans decade_C1D = no_decades;      ///< for C1D curves; for C_iso curves only after the Abel integral
    double area_shape = 1.0;                  ///< A_true/A_app − 1 over that for Gaussian isotropic slopes

    /// A_true/A_app: Eq. (9) for Gaussian isotropic slopes, otherwise for the slope distribution of maps.
    [[nodiscard]] double area_ratio() const;
};

/// Integrals over the band. Eq. (11) approximates a C_iso curve, so the conversion affects only C1D curves.
/// @throws UndefinedDataError for fewer than two usable nodes in the curve.
[[nodiscard]] SpectralParameters spectral_parameters(const spectra::Spectrum& curve,
                                                     Conversion conversion = Conversion::exact);

/// Parameters of the part of the surface with wavevectors below each of the given ones.
struct CumulativeParameters {
    Array1D wavevector;                  ///< [1/m]
    Array1D rms_height;                  ///< [m]
    Array1D rms_slope;                   ///< [1]
    Array1D rms_curvature;               ///< [1/m]
    Array1D elastic_energy_per_modulus;  ///< [m]
};

/// At the nodes inside the band and its two ends; the first entry is 0, the last equals spectral_parameters (exact).
[[nodiscard]] CumulativeParameters cumulative_parameters(const spectra::Spectrum& curve);

}  // namespace setae::roughness
