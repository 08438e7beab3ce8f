// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/simulation/retraction_work.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/numerics/bracketing.hpp"

namespace setae::simulation {
namespace {

struct PinningCoefficient {
    double energy_share;  ///< U_el/(A W)
    double value;         ///< k
};
constexpr std::array simulated_fronts{PinningCoefficient{0.003, 3.70}, PinningCoefficient{0.01, 3.2},
                                      PinningCoefficient{0.03, 2.7}, PinningCoefficient{0.1, 2.02},
                                      PinningCoefficient{0.3, 1.54}};

double pinning_coefficient(double energy_share) {
    const auto above = std::find_if(simulated_fronts.begin(), simulated_fronts.end(),
                                    [&](const PinningCoefficient& k) { return k.energy_share >= energy_share; });
    if (above == simulated_fronts.begin()) return above->value;
    if (above == simulated_fronts.end()) return simulated_fronts.back().value;
    const auto below = above - 1;
    const double share =
        std::log(energy_share / below->energy_share) / std::log(above->energy_share / below->energy_share);
    return below->value + share * (above->value - below->value);
}

}  // namespace

double work_retraction_by_pinning(const PinningRoughness& roughness) {
    if (!(roughness.work_approach > 0.0 && roughness.mean_work > 0.0 && roughness.stored_energy >= 0.0))
        throw InvalidArgument(
            fmt::format("pinning needs works of adhesion > 0 J/m2 and a stored energy >= 0 J/m2, got W_app {}, "
                        "W {}, U_el/A {}",
                        roughness.work_approach, roughness.mean_work, roughness.stored_energy));
    return roughness.work_approach +
           2.0 * pinning_coefficient(roughness.stored_energy / roughness.mean_work) * roughness.stored_energy;
}

double work_retraction_for_loss(LoopSpecimen specimen, const LoadingProtocol& protocol, double energy_loss) {
    specimen.work_retraction = specimen.work_approach;
    const LoopTruth least = loop_truth(specimen, protocol);
    if (!(energy_loss >= least.energy_loss() && std::isfinite(energy_loss)))
        throw InvalidArgument(
            fmt::format("a loop with W_app = {:.4g} J/m2 loses at least {:.4g} J in its jumps, got {:.4g} J; ask "
                        "for more, or press harder",
                        specimen.work_approach, least.energy_loss(), energy_loss));
    const auto excess = [&](double work) {
        specimen.work_retraction = work;
        return loop_truth(specimen, protocol).energy_loss() - energy_loss;
    };
    const double lower = specimen.work_approach;
    // the edge alone then loses all of it, and the jump apart adds
    const double upper = lower + energy_loss / least.largest_contact_area();
    return numerics::bracketed_root(excess, lower, upper, 50);
}

}  // namespace setae::simulation
