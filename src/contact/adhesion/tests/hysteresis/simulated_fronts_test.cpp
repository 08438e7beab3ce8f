// SPDX-License-Identifier: GPL-3.0-or-later
// W that went into simulated loops of round contacts, found by fits and ranking of both branches. The loops are those
// of the program's own solver of fronts (tests/support/round_contacts.hpp), not of the formula that the fits have.
#include <algorithm>
#include <cmath>
#include <deque>
#include <string>

#include <gtest/gtest.h>

#include "round_contacts.hpp"
#include "setae/core/constants.hpp"
#include "setae/hysteresis/ranking.hpp"

namespace setae::hysteresis::simulated_fronts_test {
namespace {

constexpr double W = round_contacts::work_of_adhesion, modulus = round_contacts::contact_modulus;
constexpr double scatter_of_loops = 0.3e-3;  ///< of the six loops about their means [J/m²]

const roughness::ParameterSpread no_spread;

/// A flat surface of the moments of a simulated one: u = U_el/(A E*), λ̄ = 4 L_c s, h² = 2uλ̄/π.
const roughness::SpectralParameters& parameters_of(const round_contacts::FittedWorks& loop) {
    static std::deque<roughness::SpectralParameters> kept;  // pairs refer to them
    auto& p = kept.emplace_back();
    p.elastic_energy_per_modulus = loop.energy_share * W / modulus;
    p.rms_height = std::sqrt(8.0 * p.elastic_energy_per_modulus * loop.energy_share * loop.larkin_length / pi);
    return p;
}

/// A front is known to first order: differences from W are its, the mean is that of the energy balance, W − U_el/A.
RankedPair pair_of(const round_contacts::FittedWorks& loop) {
    const double stored = loop.energy_share * W;
    const auto measured = [&](double work) {
        return Estimate{.value = work - stored, .standard_error = scatter_of_loops};
    };
    RetractionPair pair{
        .rough = {"share " + std::to_string(loop.energy_share) + ", surface " + std::to_string(loop.seed),
                  parameters_of(loop), no_spread},
        .soft = {"cast " + std::to_string(loop.seed), TracedValue(modulus), TracedValue(0.0)},
        .work_of_adhesion = TracedValue(0.8 * W),
        .radius = TracedValue(round_contacts::radius),
        .pressing = Pressing{.maximum_force = 1e-4}};
    const auto approach = measured(loop.known_approach);
    pair.approach = TracedValue(approach, adhesion::own_noise_name("W_app", pair.rough.name, pair.soft.name));
    return {std::move(pair), {approach, {}}, {measured(loop.known_retraction), {}}};
}

std::vector<RankedPair> all_pairs() {
    std::vector<RankedPair> pairs;
    for (const auto& loop : round_contacts::fitted_works) pairs.push_back(pair_of(loop));
    return pairs;
}

const ModelScore& score_of(const Ranking& ranking, Law law) {
    return *std::ranges::find(ranking.models, RetractionModel{law, Tip::none},
                              [](const ModelScore& score) { return score.fitted.model; });
}

TEST(SimulatedFronts, HaveTheLarkinLengthsOfTheSolver) {
    for (const auto& loop : round_contacts::fitted_works) {
        auto pair = pair_of(loop).pair;
        pair.work_of_adhesion = TracedValue(W);
        const auto pinning = pinning_of(pair);
        EXPECT_NEAR(pinning.energy_share / loop.energy_share, 1.0, 1e-9);
        EXPECT_TRUE(pinning.approach.measured && pinning.retraction.measured);
        for (const auto& edge : round_contacts::edge_works) {
            if (edge.seed != loop.seed || edge.energy_share != loop.energy_share || !edge.approach) continue;
            if (std::abs(edge.contact_radius - *pinning.approach.contact_radius) < 6e-6) {
                EXPECT_NEAR(pinning.approach.larkin_lengths / edge.larkin_lengths, 1.0, 0.1);
            }
        }
    }
}

// the mechanism of the loops is found, with the work that went in; a constant work per true area is not
TEST(SimulatedFronts, FitRecoversTheTrueWorkWithinItsError) {
    const auto ranking = rank_models(retraction_models({Tip::none}), all_pairs());
    ASSERT_TRUE(ranking.best());
    EXPECT_EQ(ranking.best()->fitted.model.name(), "pinning");
    for (const Law law : {Law::pinning, Law::fitted_pinning}) {
        const auto& found = score_of(ranking, law).work_of_adhesion;
        EXPECT_NEAR(found.value, W, 2.0 * found.standard_error) << found.value << " ± " << found.standard_error;
        EXPECT_LT(found.standard_error, 0.01 * W);
    }
    const auto& without = score_of(ranking, Law::reversible);
    EXPECT_TRUE(without.bias.refuses_model);
    EXPECT_LT(without.work_of_adhesion.value, 0.92 * W) << "without what pins it W comes out too low";
    for (const Law law : {Law::reversible, Law::conformal_loss, Law::opening_work})
        EXPECT_EQ(score_of(ranking, law).odds_against.distinction(), Distinction::clearly_better);
}

}  // namespace
}  // namespace setae::hysteresis::simulated_fronts_test
