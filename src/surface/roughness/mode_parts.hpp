// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "setae/roughness/spectral_moments.hpp"

namespace setae::roughness {

/// Contribution of a part of a spectrum to the squares of the parameters, and to the energy: factor · ∫ q^order C dq.
struct Contribution {
    double height2 = 0.0, slope2 = 0.0, curvature2 = 0.0, energy = 0.0;

    Contribution& operator+=(const Contribution& other) {
        height2 += other.height2;
        slope2 += other.slope2;
        curvature2 += other.curvature2;
        energy += other.energy;
        return *this;
    }
    friend Contribution operator*(double factor, const Contribution& of) {
        return {factor * of.height2, factor * of.slope2, factor * of.curvature2, factor * of.energy};
    }
    [[nodiscard]] SpectralParameters parameters() const {
        return {std::sqrt(height2), std::sqrt(slope2), std::sqrt(curvature2), energy};
    }
};

/// A mode and the cell around it inside the band.
struct ModePart {
    double wavevector, density;
    double left, right;  ///< of the cell [1/m]
    Contribution adds;   ///< to the parameters; proportional to the density
};

/// The modes in integrals over a curve of modes, in order. @throws UndefinedDataError for fewer than two.
[[nodiscard]] std::vector<ModePart> mode_parts(const spectra::Spectrum& modes, Conversion conversion);

}  // namespace setae::roughness
