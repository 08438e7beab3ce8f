// SPDX-License-Identifier: GPL-3.0-or-later
#include "pinning_survey.hpp"

#include <cmath>

#include "setae/core/constants.hpp"
#include "setae/crack_front/pinning.hpp"
#include "setae/crack_front/stress_intensity.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace pinning_survey {

using namespace setae;

namespace {

constexpr double shortest = 8.0;

topography::HeightMap map_of(const Case& which) {
    const auto spectrum = spectra::density(
        spectra::SelfAffine{1.0, 2.0 * pi / (shortest * which.band), which.hurst_exponent, 2.0 * pi / shortest});
    const auto way = static_cast<double>(which.way), width = static_cast<double>(which.width);
    return synthesis::random_surface(spectrum, {which.way, which.width, way, width}, {.key = {which.seed}});
}

crack_front::StressIntensity intensity_of(const topography::HeightMap& map, double shortest_wavelength) {
    return crack_front::stress_intensity_on_parallels(
        map, {.contact_modulus = 1.0, .shortest_wavelength = shortest_wavelength});
}

double spring_length(const Case& which) {
    return which.spring_length > 0.0 ? which.spring_length : static_cast<double>(which.width);
}

/// Of a front in K_R(x, z) with a mean work.
crack_front::FrontWorks works_of(const Array2D& K, const crack_front::StressIntensity& intensity, const Case& which,
                                 double work, double step) {
    const auto field = crack_front::equivalent_work(K, intensity.points, work, 1.0);
    return crack_front::straight_front_works(
        field, {.width = static_cast<double>(which.width), .restoring = pi / spring_length(which)}, step);
}

Result result_of(double approach, double retraction, bool converged, const Case& which,
                 const crack_front::StressIntensity& intensity) {
    return {.pinning_coefficient = 0.5 * (retraction - approach) / which.energy_share,
            .approach = (approach - 1.0) / which.energy_share,
            .retraction = (retraction - 1.0) / which.energy_share,
            .larkin_lengths =
                spring_length(which) / crack_front::larkin_length(intensity.mean_wavelength, which.energy_share),
            .converged = converged};
}

}  // namespace

Result run(const Case& which, double step) {
    const auto intensity = intensity_of(map_of(which), shortest);
    const double scale = std::sqrt(which.energy_share / intensity.stored_energy);
    const auto works = works_of(intensity.values * scale, intensity, which, 1.0, step);
    return result_of(works.approach, works.retraction, works.converged, which, intensity);
}

BandsResult run_in_bands(const Case& which, double step) {
    const auto map = map_of(which);
    const auto all = intensity_of(map, shortest), coarse = intensity_of(map, shortest * std::sqrt(which.band));
    const double scale = std::sqrt(which.energy_share / all.stored_energy);
    const Array2D coarse_K = coarse.values * scale, fine_K = all.values * scale - coarse_K;
    const auto together = works_of(all.values * scale, all, which, 1.0, step),
               fine = works_of(fine_K, all, which, 1.0, step),
               closing = works_of(coarse_K, all, which, fine.approach, step),
               opening = works_of(coarse_K, all, which, fine.retraction, step);
    const bool converged = fine.converged && closing.converged && opening.converged;
    return {.together = result_of(together.approach, together.retraction, together.converged, which, all),
            .apart = result_of(closing.approach, opening.retraction, converged, which, all),
            .fine_share = 1.0 - coarse.stored_energy / all.stored_energy};
}

}  // namespace pinning_survey
