// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/stored_energy.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/summation.hpp"
#include "setae/spectra/isotropic.hpp"
#include "setae/topography/detrend.hpp"

namespace setae::adhesion {
namespace {

void require_modulus(double contact_modulus) {
    if (!(contact_modulus > 0.0))
        throw InvalidArgument(fmt::format("contact modulus is {} Pa; expected > 0", contact_modulus));
}

}  // namespace

double stored_energy(double contact_modulus, const spectra::Spectrum& curve, roughness::Conversion conversion) {
    require_modulus(contact_modulus);
    return contact_modulus * roughness::spectral_parameters(curve, conversion).elastic_energy_per_modulus;
}

double stored_energy(double contact_modulus, const topography::HeightMap& map, parallel::Threads threads) {
    require_modulus(contact_modulus);
    spectra::SpectrumOptions options;
    options.trend = map.periodic ? topography::Trend::mean : topography::Trend::tilt;
    options.threads = threads;
    const auto C2D = spectra::power_spectrum_map(map, options);
    const auto nx = C2D.rows(), ny = C2D.cols();
    const auto folded = [](Index k, Index n, double size) {
        return 2.0 * pi * static_cast<double>(k <= n / 2 ? k : k - n) / size;
    };
    Array1D of_rows(nx);
    for (Index k = 0; k < nx; ++k) {
        const double q_x = folded(k, nx, map.size[0]);
        double sum = 0.0;
        for (Index m = 0; m < ny; ++m) sum += std::hypot(q_x, folded(m, ny, map.size[1])) * C2D(k, m);
        of_rows[k] = sum;
    }
    // |h_q|² = C2D/A
    return 0.25 * contact_modulus * pairwise_sum(of_rows) / (map.size[0] * map.size[1]);
}

double stored_energy_bound(double contact_modulus, double rms_height, double rms_slope) {
    require_modulus(contact_modulus);
    return 0.25 * contact_modulus * rms_height * rms_slope;
}

}  // namespace setae::adhesion
