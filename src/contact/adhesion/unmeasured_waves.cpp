// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/unmeasured_waves.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace setae::adhesion {
namespace {

/// Contribution of one end to the sums over waves.
struct Added {
    double squared_slope = 0.0, energy = 0.0;
};

struct End {
    Added middle, least, most;
};

End added_by(const std::optional<roughness::BeyondData>& beyond, const roughness::SpectralParameters& within) {
    if (!beyond) return {};
    const auto added = [&within](double slope, double energy) {
        return Added{slope * slope - within.rms_slope * within.rms_slope, energy - within.elastic_energy_per_modulus};
    };
    const auto &slope = beyond->rms_slope, &energy = beyond->elastic_energy_per_modulus;
    return {added(slope.value, energy.value), added(slope.interval->lower, energy.interval->lower),
            added(slope.interval->upper, energy.interval->upper)};
}

}  // namespace

std::optional<Estimate> work_with_unmeasured_waves(const RoughSide& rough, const SoftSide& soft,
                                                   double work_of_adhesion, const UnmeasuredWaves& waves) {
    if (!waves.shorter && !waves.longer) return std::nullopt;
    const auto fine = added_by(waves.shorter, waves.within), coarse = added_by(waves.longer, waves.within);
    const auto work = [&](const Added& a, const Added& b) {
        auto whole = rough.parameters;
        whole.rms_slope = std::sqrt(whole.rms_slope * whole.rms_slope + a.squared_slope + b.squared_slope);
        whole.elastic_energy_per_modulus += a.energy + b.energy;
        const double energy = soft.contact_modulus.value * whole.elastic_energy_per_modulus;
        return modified_balance(work_of_adhesion, soft.surface_energy.value, {whole.area_ratio(), energy}).raw;
    };
    std::vector<double> corners;
    for (const auto& a : {fine.least, fine.most})
        for (const auto& b : {coarse.least, coarse.most}) corners.push_back(work(a, b));
    const auto [least, most] = std::ranges::minmax(corners);
    return Estimate{.value = work(fine.middle, coarse.middle),
                    .method = "power law continued",
                    .interval = Interval{least, most, 0.95}};
}

}  // namespace setae::adhesion
