// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "setae/core/arrays.hpp"
#include "setae/spectra/self_affine.hpp"

namespace setae::spectra {

/// C_iso [m⁴] of a model inside its domain.
[[nodiscard]] inline double isotropic_value(const SelfAffine& model, double wavevector) {
    if (wavevector > model.short_wavevector) return 0.0;
    if (wavevector < model.rolloff_wavevector) return model.plateau;
    return model.plateau * std::pow(wavevector / model.rolloff_wavevector, -2.0 - 2.0 * model.hurst_exponent);
}

/// C1D [m³] of lines on a self-affine surface, tabulated: 40 nodes per decade, ln(C1D/√(1 − (q/q_s)²)) linear in ln q
/// between them. Within 5e-4; 0 from q_s on.
class SelfAffineLines {
public:
    SelfAffineLines(const spectra::SelfAffine& model, double lowest, double highest);

    [[nodiscard]] double operator()(double wavevector) const;

private:
    double end_, first_, spacing_;
    Array1D log_values_;
};

}  // namespace setae::spectra
