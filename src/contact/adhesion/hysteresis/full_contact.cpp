// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/hysteresis/full_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Core>

#include "setae/adhesion/traced_function.hpp"
#include "setae/core/component_rows.hpp"
#include "setae/hysteresis/pinning_law.hpp"
#include "setae/numerics/random_numbers.hpp"

namespace setae::hysteresis {
namespace {

/// ln U_el/(A W) with its inputs; infinite where full contact gains nothing.
TracedValue log_share(const RetractionPair& pair) {
    return adhesion::traced_function(
        pair.rough, {pair.soft.contact_modulus, pair.soft.surface_energy, pair.work_of_adhesion},
        [](const roughness::SpectralParameters& p, const std::vector<double>& in) {
            const PairState full{.area_ratio = p.area_ratio(),
                                 .stored_energy = in[0] * p.elastic_energy_per_modulus,
                                 .work_of_adhesion = in[2],
                                 .surface_energy = in[1]};
            return full.full_contact_gain() > 0.0 ? std::log(full.energy_share())
                                                  : std::numeric_limits<double>::infinity();
        });
}

}  // namespace

CountRange pairs_in_full_contact(const std::vector<RetractionPair>& pairs, std::uint64_t seed) {
    std::vector<TracedValue> shares;
    for (const auto& pair : pairs)
        if (auto share = log_share(pair); share.value < std::numeric_limits<double>::infinity())
            shares.push_back(std::move(share));
    if (shares.empty()) return {};
    std::vector<const Components*> inputs;
    for (const auto& share : shares) inputs.push_back(&share.components);
    const Eigen::MatrixXd rows = component_rows(inputs);
    constexpr Eigen::Index draws = 4000;
    constexpr double tail = 0.025;
    std::vector<int> counts;
    for (Eigen::Index d = 0; d < draws; ++d) {
        const Array1D moved =
            (rows * numerics::normal_numbers({seed, static_cast<std::uint64_t>(d)}, 0, rows.cols()).matrix()).array();
        int count = 0;
        for (std::size_t i = 0; i < shares.size(); ++i)
            count +=
                shares[i].value + moved[static_cast<Eigen::Index>(i)] <= std::log(full_contact_energy_share) ? 1 : 0;
        counts.push_back(count);
    }
    std::ranges::sort(counts);
    const auto at = [&](double p) { return counts[static_cast<std::size_t>(p * (draws - 1))]; };
    return {at(tail), at(1.0 - tail)};
}

}  // namespace setae::hysteresis
