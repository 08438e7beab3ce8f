// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_quantities.hpp"

#include <fmt/format.h>

#include "setae/roughness/true_area.hpp"

namespace setae::validation {

using roughness::SpectralParameters;

namespace {

/// True parameters with the decades of the true C1D.
SpectralParameters true_parameters(const simulation::TrueSurfaceValues& truth) {
    auto parameters = truth.parameters;
    if (truth.C1D.wavevector.size() > 1) parameters.decade_C1D = roughness::decade_means(truth.C1D);
    return parameters;
}

}  // namespace

std::vector<SurfaceQuantity> surface_quantities() {
    std::vector<SurfaceQuantity> quantities{
        {"rms_height", "m", [](const SpectralParameters& p) { return p.rms_height; }},
        {"rms_slope", "1", [](const SpectralParameters& p) { return p.rms_slope; }},
        {"rms_curvature", "1/m", [](const SpectralParameters& p) { return p.rms_curvature; }},
        {"elastic_energy_per_modulus", "m", [](const SpectralParameters& p) { return p.elastic_energy_per_modulus; }},
        {"true_area_ratio", "1", [](const SpectralParameters& p) { return p.area_ratio(); }, 1.0},
    };
    for (std::size_t d = 0; d < roughness::no_decades.size(); ++d)
        quantities.push_back({fmt::format("C1D 1e{}", roughness::first_decade + static_cast<int>(d)), "m3",
                              [d](const SpectralParameters& p) { return p.decade_C1D[d]; }});
    return quantities;
}

double true_value_of(const SurfaceQuantity& quantity, const simulation::TrueSurfaceValues& truth) {
    return quantity.name == "true_area_ratio" ? truth.area_ratio : quantity.value(true_parameters(truth));
}

}  // namespace setae::validation
