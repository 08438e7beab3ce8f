// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"
#include "setae/simulation/known_surface.hpp"

namespace setae::simulation {

/// C1D [m³] of lines through the isotropic surface C_iso, which ends at q_s.
///
///   C1D(q) = (q/π) ∫_0^T C_iso(q cosh t) cosh t dt,  cosh T = q_s/q
///
/// Midpoints in t, 30 a unit: 2e-4 at bends and at the end of C_iso, else better. 0 from q_s on.
[[nodiscard]] double profile_value(const spectra::SpectralDensity& C_iso, double wavevector, double short_wavevector);

/// C1D of straight lines through a surface (its Gaussian heights), tabulated once: 100 nodes per decade, ln(C1D/√(q_s²
/// − q²)) linear in ln q between them, constant below 1/1000 of the roll-off's wavevector.
///
/// Lines at an angle φ to the long direction of a surface stretched s times: C1D_φ(q) = t C1D(t q), t = s/√(s² sin²φ +
/// cos²φ). Made in 5 ms.
class LineSpectrum {
public:
    explicit LineSpectrum(const KnownSurface& surface);

    /// Along x.
    [[nodiscard]] double operator()(double wavevector) const { return along(surface_angle_, wavevector); }
    /// At an angle to the long direction [rad].
    [[nodiscard]] double along(double angle, double wavevector) const;
    /// Mean over all directions, which is the C1D of the angle-averaged C_iso.
    [[nodiscard]] double averaged(double wavevector) const;
    /// Where lines along x end [1/m].
    [[nodiscard]] double upper() const { return upper_ / contraction(surface_angle_); }

private:
    [[nodiscard]] double contraction(double angle) const;
    [[nodiscard]] double isotropic(double wavevector) const;

    double stretch_, surface_angle_, first_, upper_, spacing_ = 0.0;
    Array1D log_values_;
};

}  // namespace setae::simulation
