// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "setae/spectra/self_affine.hpp"
#include "setae/spectra/spectrum.hpp"

namespace setae::persson {

/// H = 0.8 between 2 µm and 50 nm, rms height 19 nm, flat up to 8 µm.
inline spectra::SelfAffine model() {
    return {.plateau = 1.3e-28, .rolloff_wavevector = 3.14e6, .hurst_exponent = 0.8, .short_wavevector = 1.256e8};
}

/// Its C_iso, nodes from 8 µm to its end, one at the roll-off.
inline spectra::Spectrum self_affine_curve() {
    const auto spectrum = model();
    constexpr Index below = 10, above = 60;
    Array1D q(below + above + 1);
    const double from = spectrum.rolloff_wavevector / 4.0;
    for (Index i = 0; i <= below; ++i) q[i] = from * std::pow(4.0, static_cast<double>(i) / below);
    q[below] = spectrum.rolloff_wavevector;
    const double ratio = spectrum.short_wavevector / spectrum.rolloff_wavevector;
    for (Index i = 1; i <= above; ++i)
        q[below + i] = spectrum.rolloff_wavevector * std::pow(ratio, static_cast<double>(i) / above);
    q[below + above] = spectrum.short_wavevector;
    return {.wavevector = q,
            .density = spectra::isotropic_power_spectrum(spectrum, q),
            .band = {from, spectrum.short_wavevector},
            .kind = spectra::Density::C_iso};
}

}  // namespace setae::persson
