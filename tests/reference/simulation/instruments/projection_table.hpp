// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "setae/core/constants.hpp"
#include "setae/simulation/projection_bias.hpp"

namespace setae::tests {

/// One row of the table in docs/concepts/tem-projection.md: a self-affine surface, waves down to 4 Å, seen through a
/// foil.
struct ProjectionCase {
    double hurst_exponent = 0.8;
    double rolloff_wavelength = 100e-9;  ///< [m]
    double thickness = 0.0;              ///< [m]
};

inline std::vector<ProjectionCase> projection_cases() {
    std::vector<ProjectionCase> cases;
    for (const double thickness : {0.4e-9, 1e-9, 2e-9, 5e-9, 10e-9, 20e-9, 50e-9, 100e-9})
        cases.push_back({0.8, 100e-9, thickness});
    for (const double hurst_exponent : {0.6, 0.7, 0.9}) cases.push_back({hurst_exponent, 100e-9, 20e-9});
    for (const double rolloff : {25e-9, 50e-9, 200e-9}) cases.push_back({0.8, rolloff, 20e-9});
    return cases;
}

/// Simulated on 0.4 by 0.2 µm with points every 1 Å, two bins a decade.
inline simulation::ProjectionBias simulated(const ProjectionCase& row, int surfaces, std::uint64_t seed,
                                            double extent = 409.6e-9) {
    const spectra::SelfAffine model{1e-30, 2.0 * pi / row.rolloff_wavelength, row.hurst_exponent, 2.0 * pi / 4e-10};
    const auto points = static_cast<Index>(std::llround(extent / 1e-10));
    simulation::ProjectionOptions options;
    options.thickness = row.thickness;
    options.grid = {points, points / 2, extent, 0.5 * extent};
    options.surfaces = surfaces;
    options.bins_per_decade = 2;
    options.key = {seed, 0};
    return projection_bias(spectra::density(model), options);
}

}  // namespace setae::tests
