// SPDX-License-Identifier: GPL-3.0-or-later
#include "pinning_survey.hpp"

#include <cmath>

#include "setae/core/constants.hpp"
#include "setae/crack_front/pinning.hpp"
#include "setae/crack_front/stress_intensity.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace pinning_survey {

using namespace setae;

Result run(const Case& which, double step) {
    constexpr double shortest = 8.0;
    const auto spectrum = spectra::density(
        spectra::SelfAffine{1.0, 2.0 * pi / (shortest * which.band), which.hurst_exponent, 2.0 * pi / shortest});
    const auto way = static_cast<double>(which.way), width = static_cast<double>(which.width);
    const auto map = synthesis::random_surface(spectrum, {which.way, which.width, way, width}, {.key = {which.seed}});
    auto intensity =
        crack_front::stress_intensity_on_parallels(map, {.contact_modulus = 1.0, .shortest_wavelength = shortest});
    intensity.values *= std::sqrt(which.energy_share / intensity.stored_energy);
    const auto field = crack_front::equivalent_work(intensity.values, intensity.points, 1.0, 1.0);
    const auto works = crack_front::straight_front_works(field, {.width = width}, step);
    return {.pinning_coefficient = works.pinning_coefficient(which.energy_share),
            .approach = (works.approach - 1.0) / which.energy_share,
            .retraction = (works.retraction - 1.0) / which.energy_share,
            .larkin_lengths = width / crack_front::larkin_length(intensity.mean_wavelength, which.energy_share),
            .converged = works.converged};
}

}  // namespace pinning_survey
