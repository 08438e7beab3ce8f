// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "setae/simulation/known_surface.hpp"

namespace setae::validation {

/// A parameter of a surface.
struct SurfaceQuantity {
    std::string name, unit;
    std::function<double(const roughness::SpectralParameters&)> value;
    double least = 0.0;  ///< lower limit of the values
};

/// Heights, slopes, curvatures, energy, true area, C1D by decade.
[[nodiscard]] std::vector<SurfaceQuantity> surface_quantities();

/// NaN without a true value: C1D of surfaces that are not Gaussian.
[[nodiscard]] double true_value_of(const SurfaceQuantity& quantity, const simulation::TrueSurfaceValues& truth);

}  // namespace setae::validation
