// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/hysteresis_output.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "setae/contact/jkr.hpp"
#include "setae/core/errors.hpp"
#include "setae/study/study.hpp"
#include "setae/study/study_result.hpp"

namespace setae::output::hysteresis_output_test {
namespace {

const study::StudyResult& published() {
    static const auto result = study::run_study(study::read_study("examples/nanodiamond/published.toml"));
    return result;
}

/// As run_study() ranks it.
const study::Hysteresis& published_hysteresis() { return *published().hysteresis; }

const study::PairHysteresis& pair_of(const study::Hysteresis& h, const std::string& surface,
                                     const std::string& elastomer) {
    return *std::find_if(h.pairs.begin(), h.pairs.end(),
                         [&](const auto& pair) { return pair.surface == surface && pair.elastomer == elastomer; });
}

TEST(StudyHysteresis, RanksByPairsInFullContactAndPredictsOthersSeparately) {
    const auto& h = published_hysteresis();
    EXPECT_EQ(h.measured_pairs, 16);
    EXPECT_EQ(h.conforming_pairs, 10);
    EXPECT_EQ(pair_of(h, "UNCD", "E0.7").choice, study::ModelChoice::conforming_pairs);
    EXPECT_EQ(pair_of(h, "NCD", "E10").choice, study::ModelChoice::all_pairs);
    // W_x r of [D19]'s slopes, W_x by least squares of the nine pairs: within its own ±
    // a work per true area times the tip's factor of the smooth reference on E0.7
    const auto& best = *h.conforming.best();
    EXPECT_EQ(best.fitted.model.name(), "crack_tip_opening_work");
    ASSERT_TRUE(pair_of(h, "UNCD", "E0.7").likelier);
    EXPECT_NEAR(pair_of(h, "UNCD", "E0.7").likelier->work_retraction.value / 1.68822 / (59.3 / 39.6),
                best.fitted.parameter.value, 0.02 * best.fitted.parameter.value);
    // r 1.47496, U_el/(A E*) 9.57 nm of the reconstructed spectrum
    const double gain = published().work_of_adhesion->value * 1.47496 - 25e-3 * 0.47496;
    EXPECT_NEAR(pair_of(h, "NCD", "E0.7").energy_share, 9.57e-9 * 0.91999923e6 / gain, 1e-3);
    EXPECT_NEAR(pair_of(h, "PUNCD", "E1.0").tip_factor->value, 52.5 / 36.8, 1e-12);
}

// W_ret of sixteen pairs against r α, α of docs/validation/conformity.md at their U_el/AW, by least squares in Python:
// 85.2 mJ/m², 13.6 mJ/m² rms off; against r alone 70.3 and 36.6. With the crack tip's factor or without cannot be
// distinguished; every model that depends less on the true area is clearly worse.
TEST(StudyHysteresis, OneWorkPerTrueAreaInContactFitsAllPairs) {
    const auto& h = published_hysteresis();
    const auto opening = std::ranges::find_if(
        h.all.models, [](const auto& score) { return score.fitted.model.name() == "opening_work"; });
    ASSERT_NE(opening, h.all.models.end());
    EXPECT_NEAR(opening->fitted.parameter.value, 85.2e-3, opening->fitted.parameter.standard_error());
    EXPECT_NEAR(opening->rms_residual, 13.6e-3, 0.5e-3);
    EXPECT_LT(opening->surface_left_out, 18e-3);
    std::vector<std::string> likely;
    for (const auto* score : h.all.possible())
        if (score->odds_against.distinction() == hysteresis::Distinction::cannot_be_distinguished)
            likely.push_back(score->fitted.model.name());
    EXPECT_EQ(likely, (std::vector<std::string>{"crack_tip_opening_work", "opening_work"}));
    for (const auto& score : h.all.models)
        if (score.fitted.model.name() == "reversible") {
            EXPECT_GT(score.odds_against.lower, 1e4);
        }
    // 1 + k: what pins an edge on its way in is not in the approach
    ASSERT_TRUE(h.all.approach_against_pinning);
    EXPECT_GT(h.all.approach_against_pinning->value, 20.0);
    EXPECT_NEAR(pair_of(h, "UNCD", "E10").contact_fraction, 0.46, 0.01);
    EXPECT_TRUE(h.deciding);
    // a pair has no loop only where what pins its edge takes all of W_app
    int loops = 0;
    for (const auto& pair : h.pairs) {
        EXPECT_EQ(static_cast<bool>(pair.loop), pair.work_approach.value > 0.0) << pair.surface << pair.elastomer;
        loops += pair.loop ? 1 : 0;
    }
    EXPECT_EQ(loops, 11);
}

TEST(StudyHysteresis, EnergySharesOfALoopAddUp) {
    const auto& h = published_hysteresis();
    for (const auto& pair : h.pairs) {
        if (!pair.loop) continue;
        const auto& s = pair.loop->shares;
        const double sum = s.jump_in.value + s.jump_out.value + s.crack_tip.value + s.roughness.value + s.bulk.value;
        EXPECT_NEAR(sum / pair.loop->energy_loss.value, 1.0, 1e-12) << pair.surface << pair.elastomer;
        EXPECT_NEAR(pair.pull_off_force->value, 1.5 * std::numbers::pi * 1.25e-3 * pair.work_retraction.value, 1e-12);
        ASSERT_TRUE(pair.decomposition) << pair.decomposition.reason;
        const auto& d = *pair.decomposition;
        EXPECT_TRUE(d.of_works);
        EXPECT_NEAR(d.unexplained.value + d.shares.jump_in.value + d.shares.jump_out.value + d.shares.crack_tip.value +
                        d.shares.roughness.value,
                    d.measured.value, 1e-12 * d.measured.value);
    }
}

// A contact as wide as JKR's under 1 mN, of the measured W_app, implies this preload. Its edge is as long
// as that contact, which moves the pinned W_app by less than 1 %, where the stated preload takes the predicted
// contact's.
TEST(StudyHysteresis, WithoutPreloadUsesTheForceOfMeasuredContacts) {
    auto result = published();
    const auto& stated = published_hysteresis();
    for (auto& elastomer : result.elastomers) elastomer.input.preload.reset();
    EXPECT_EQ(study::hysteresis_of(result).pairs.front().loop.reason, "elastomer E0.7 has no preload");
    for (auto& pair : result.pairs) {
        const double modulus = result.elastomer(pair.elastomer).soft_side().contact_modulus.value,
                     radius = contact::jkr::contact_radius_at_force(1e-3, {1.25e-3, modulus, pair.approach->value});
        pair.contact_area = std::numbers::pi * radius * radius;
    }
    const auto found = study::hysteresis_of(result);
    for (std::size_t i = 0; i < found.pairs.size(); ++i) {
        ASSERT_EQ(static_cast<bool>(found.pairs[i].loop), static_cast<bool>(stated.pairs[i].loop))
            << found.pairs[i].loop.reason;
        if (!found.pairs[i].loop) continue;
        EXPECT_NEAR(found.pairs[i].loop->pressing.maximum_force, 1e-3, 1e-9);
        EXPECT_NEAR(found.pairs[i].loop->contact_radius.value / stated.pairs[i].loop->contact_radius.value, 1.0, 1e-3);
    }
}

TEST(StudyHysteresis, WithoutReferencesHasNoCrackTips) {
    auto result = published();
    result.references.clear();
    const auto h = study::hysteresis_of(result);
    for (const auto& score : h.all.models) EXPECT_EQ(score.fitted.model.tip, hysteresis::Tip::none);
    ASSERT_FALSE(h.all.unranked.empty());
    EXPECT_EQ(h.all.unranked.front().reason, "no smooth reference on E0.7");
}

TEST(StudyHysteresis, OfFewPairsUsesTheTrueAreaLoss) {
    auto result = published();
    for (auto& pair : result.pairs)
        if (pair.surface != "UNCD") pair.retraction = pair.pull_off = std::nullopt;
    const auto h = study::hysteresis_of(result);
    EXPECT_EQ(h.measured_pairs, 4);
    EXPECT_FALSE(h.all.best());
    EXPECT_EQ(h.pairs.front().choice, study::ModelChoice::assumed);
    EXPECT_EQ(h.pairs.front().model.name(), "reversible");
    EXPECT_NE(hysteresis_answer(h, 200).find("needs at least 6 pairs on 4 surfaces"), std::string::npos)
        << hysteresis_answer(h, 200);
}

TEST(StudyHysteresis, OneImpossiblePairDoesNotAffectOthers) {
    auto result = published();
    result.elastomers.front().input.surface_energy.value = 1.0;  // more than W_int pays for, where areas differ
    const auto h = study::hysteresis_of(result);
    EXPECT_EQ(h.skipped.size(), 4U);
    EXPECT_EQ(h.pairs.size(), 12U);
    EXPECT_NE(h.skipped.front().reason.find("stretching"), std::string::npos);
}

TEST(StudyHysteresis, WithoutAWorkOfAdhesionIsRefused) {
    auto result = published();
    result.work_of_adhesion = study::Outcome<Estimate>::missing("nothing was measured");
    EXPECT_THROW((void)study::hysteresis_of(result), UndefinedDataError);
}

TEST(HysteresisText, StartsWithTheAnswer) {
    const auto& h = published_hysteresis();
    const auto text = hysteresis_text(h, 1000);
    EXPECT_EQ(text.find("For 10 pairs"), 0U) << text;
    for (const auto& line :
         {"in spontaneous full contact, the model crack_tip_opening_work fits W_ret at pull-off best",
          "models of W_ret at pull-off, all 16 pairs", "predicted from roughness only, by crack_tip_pinning",
          "; last column: W_ret by the more likely crack_tip_opening_work",
          "energy budget of the loops, by crack_tip_opening_work",
          "Predictions use the model crack_tip_pinning, because crack_tip_opening_work misses the smooth reference by"})
        EXPECT_NE(text.find(line), std::string::npos) << line;
}

// docs/validation/crack-front.md: from the maximum load of 1 mN to pull-off
TEST(StudyHysteresis, CountsLarkinLengthsOfPublishedContacts) {
    const auto& h = published_hysteresis();
    struct Published {
        const char *surface, *elastomer;
        double loaded, at_pull_off, k_approach, k_retraction;
    };
    for (const auto& [surface, elastomer, loaded, at_pull_off, k_approach, k_retraction] :
         {Published{"PUNCD", "E0.7", 4.4, 8.8, 2.27, 2.63}, Published{"PUNCD", "E1.0", 5.7, 11.5, 2.36, 2.68},
          Published{"UNCD", "E0.7", 84, 166, 2.24, 2.30}, Published{"MCD", "E0.7", 17, 34, 1.38, 1.55}}) {
        const auto& pinning = pair_of(h, surface, elastomer).pinning;
        ASSERT_TRUE(pinning);
        EXPECT_NEAR(pinning->approach.larkin_lengths / loaded, 1.0, 0.03) << surface << elastomer;
        EXPECT_NEAR(pinning->retraction.larkin_lengths / at_pull_off, 1.0, 0.03) << surface << elastomer;
        EXPECT_NEAR(pinning->approach.coefficient.value, k_approach, 0.03) << surface << elastomer;
        EXPECT_NEAR(pinning->retraction.coefficient.value, k_retraction, 0.03) << surface << elastomer;
    }
    ASSERT_EQ(h.alerts.size(), 1U);
    EXPECT_EQ(h.alerts.front().code, "PINNING_EXTRAPOLATED");
    EXPECT_NE(h.alerts.front().subject.find("PUNCD × E0.7"), std::string::npos) << "N 8.8 at U_el/AW 0.0043";
    EXPECT_EQ(std::ranges::count(published().alerts, "PINNING_EXTRAPOLATED", &Alert::code), 1);
    EXPECT_NE(hysteresis_text(h, 200).find(", N "), std::string::npos);
}

TEST(HysteresisTables, HaveOneRowPerPairAndModel) {
    const auto& h = published_hysteresis();
    EXPECT_EQ(hysteresis_table(h).rows.size(), 16U);
    EXPECT_EQ(model_table(h).rows.size(), 28U);
    EXPECT_EQ(model_work_table(h).rows.size(), 16U * 14U);
    EXPECT_EQ(decomposition_table(h).rows.size(), 16U);
    for (const auto& table : {hysteresis_table(h), model_table(h), model_work_table(h), decomposition_table(h)})
        for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
}

}  // namespace
}  // namespace setae::output::hysteresis_output_test
