// SPDX-License-Identifier: GPL-3.0-or-later
#include "balances.hpp"

#include "setae/roughness/true_area.hpp"

namespace setae::study {

using roughness::SpectralParameters;

bool predictable(const SurfaceResult& surface, const ElastomerResult& elastomer) {
    return !surface.failed() && elastomer.contact_modulus.value > 0.0;
}

adhesion::PairPoint Balances::modified() const {
    return point(roughness::gaussian_area_ratio, elastomer_.input.surface_energy);
}
adhesion::PairPoint Balances::persson_tosatti() const { return point(roughness::small_slope_area_ratio, {}); }
adhesion::PairPoint Balances::without_area_change() const { return point(roughness::gaussian_area_ratio, {}); }

adhesion::PairPoint Balances::point(AreaRatio area_ratio, const Estimate& surface_energy) const {
    const double r = area_ratio(parameters_.rms_slope), u = parameters_.elastic_energy_per_modulus;
    const auto& modulus = elastomer_.contact_modulus;
    const auto ratio = [area_ratio](const SpectralParameters& p) { return area_ratio(p.rms_slope); };
    const auto energy = [&modulus](const SpectralParameters& p) {
        return modulus.value * p.elastic_energy_per_modulus;
    };
    adhesion::PairPoint pair;
    pair.surface = surface_.name;
    pair.elastomer = elastomer_.input.name;
    pair.slope = r;
    pair.offset = surface_energy.value * (r - 1.0) + modulus.value * u;
    pair.slope_centre = surface_energy.value;
    pair.slope_variance = surface_.used().spread.covariance(ratio, ratio);
    pair.slope_offset_covariance = surface_.used().spread.covariance(ratio, energy);
    pair.offset_variance = surface_.used().spread.covariance(energy, energy) + u * u * modulus.variance() +
                           (r - 1.0) * (r - 1.0) * surface_energy.variance();
    return pair;
}

}  // namespace setae::study
