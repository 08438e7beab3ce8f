// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/hysteresis/retraction_model_trials.hpp"

namespace setae::hysteresis {
namespace {

using roughness::SpectralParameters;

SpectralParameters parameters(double rms_slope, double energy_per_modulus) {
    SpectralParameters p;
    p.rms_height = 20e-9;
    p.rms_slope = rms_slope;
    p.elastic_energy_per_modulus = energy_per_modulus;
    return p;
}

/// Four surfaces and four elastomers, W_int 37 mJ/m², γ1 25 mJ/m², every number exact.
class Study {
public:
    Study() {
        const double slopes[] = {0.3, 0.7, 1.1, 1.5}, energies[] = {0.5e-9, 1.5e-9, 4e-9, 2.5e-9},
                     moduli[] = {0.4e6, 0.8e6, 1.2e6, 1.8e6}, factors[] = {1.5, 1.4, 1.3, 1.1};
        for (int i = 0; i < 4; ++i) surfaces_.push_back(parameters(slopes[i], energies[i]));
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j) {
                RetractionPair pair{.rough = {"S" + std::to_string(i), surfaces_[static_cast<std::size_t>(i)], none_},
                                    .soft = {"E" + std::to_string(j), moduli[j], 0.025},
                                    .work_of_adhesion = 0.037,
                                    .bands = {{0.25, 1e-8}, {0.25, 4e-8}, {0.25, 1.6e-7}, {0.25, 6.4e-7}}};
                pair.tip_factor = TracedValue(factors[j]);
                pairs_.push_back(std::move(pair));
            }
    }

    /// Both works by a model, with relative noise.
    [[nodiscard]] std::vector<RankedPair> simulated(const RetractionModel& model, double parameter, double noise,
                                                    unsigned seed) const {
        std::mt19937 random(seed);
        std::normal_distribution<double> normal;
        std::vector<RankedPair> pairs;
        for (auto pair : pairs_) {
            const FittedModel fitted{.model = model, .parameter = parameter, .scatter = {}};
            const double approach = predicted_approach(fitted, pair).value,
                         retraction = predicted_retraction(fitted, pair).value;
            const auto measured = [&](double exact) {
                return Estimate{.value = exact * (1.0 + noise * normal(random)), .standard_error = noise * exact};
            };
            const auto of_approach = measured(approach);
            pair.approach =
                TracedValue(of_approach, adhesion::own_noise_name("W_app", pair.rough.name, pair.soft.name));
            pairs.push_back({pair, {of_approach, {}}, {measured(retraction), {}}});
        }
        return pairs;
    }

    [[nodiscard]] static Ranking ranked(const std::vector<RankedPair>& pairs) {
        return rank_models(retraction_models(), pairs);
    }

    [[nodiscard]] const std::vector<RetractionPair>& pairs() const { return pairs_; }

private:
    roughness::ParameterSpread none_;
    std::vector<SpectralParameters> surfaces_;
    std::vector<RetractionPair> pairs_;
};

TEST(Ranking, TrueModelIsPossibleWithItsParameter) {
    const Study study;
    for (const auto& model : retraction_models()) {
        const double parameter = model.law == Law::fitted_pinning ? 0.9 : 0.06;
        const auto ranking = study.ranked(study.simulated(model, parameter, 0.01, 7));
        ASSERT_EQ(ranking.models.size(), retraction_models().size()) << model.name();
        const auto possible = ranking.possible();
        const auto own =
            std::ranges::find_if(possible, [&](const ModelScore* score) { return score->fitted.model == model; });
        ASSERT_NE(own, possible.end()) << model.name() << " excluded, " << ranking.best()->fitted.model.name();
        if (model.fitted()) {
            EXPECT_NEAR((*own)->fitted.parameter.value / parameter, 1.0, 0.05) << model.name();
        }
        // what carries over from approach: W_int that went in
        EXPECT_NEAR((*own)->work_of_adhesion.value, 0.037, 3.0 * (*own)->work_of_adhesion.standard_error + 0.0004)
            << model.name();
        double sum = 0.0;
        for (const auto& score : ranking.models) sum += score.weight;
        EXPECT_NEAR(sum, 1.0, 1e-12);
    }
}

TEST(Ranking, RejectsAModelWithAConstantBias) {
    const Study study;
    auto pairs = study.simulated({Law::reversible, Tip::none}, 0.0, 0.03, 9);
    for (auto& pair : pairs) pair.retraction.value.value += 0.06;
    const auto ranking = rank_models({{Law::reversible, Tip::none}}, pairs);
    ASSERT_EQ(ranking.models.size(), 1U);
    EXPECT_TRUE(ranking.models[0].bias.refuses_model);
    EXPECT_NEAR(ranking.models[0].bias.value.value, 0.06, 3.0 * ranking.models[0].bias.value.standard_error);
    EXPECT_TRUE(ranking.all_refused());
}

TEST(Ranking, SeveralModelsCannotBeDistinguishedInStrongNoise) {
    const Study study;
    const auto ranking = study.ranked(study.simulated({Law::opening_work, Tip::none}, 0.06, 0.4, 3));
    EXPECT_GT(ranking.possible().size(), 1U);
}

TEST(Ranking, IsTheSameForAnyNumberOfThreads) {
    const Study study;
    const auto pairs = study.simulated({Law::opening_work, Tip::none}, 0.06, 0.05, 3);
    const auto one = rank_models(retraction_models(), pairs, {}, {1}),
               two = rank_models(retraction_models(), pairs, {}, {2});
    for (std::size_t i = 0; i < one.models.size(); ++i) {
        EXPECT_EQ(one.models[i].fitted.model.name(), two.models[i].fitted.model.name());
        EXPECT_EQ(one.models[i].odds_against.lower, two.models[i].odds_against.lower);
    }
}

TEST(Odds, AreClassifiedByTheirFivePercentQuantile) {
    EXPECT_EQ((Odds{1000.0, 21.0, 1e6}.distinction()), Distinction::clearly_better);
    EXPECT_EQ((Odds{1000.0, 19.0, 1e6}.distinction()), Distinction::better);
    EXPECT_EQ((Odds{1000.0, 2.0, 1e6}.distinction()), Distinction::cannot_be_distinguished);
    EXPECT_EQ((Odds{15.0, 21.0, 1e6}.distinction()), Distinction::better);
    EXPECT_STREQ(name_of(Distinction::clearly_better), "clearly better");
}

TEST(ModelTrials, FindTrueModelsOrKeepThemPossible) {
    const Study study;
    const auto pairs = study.simulated({Law::opening_work, Tip::none}, 0.06, 0.03, 3);
    const std::vector<RetractionModel> models{{Law::reversible, Tip::none},
                                              {Law::pinning, Tip::none},
                                              {Law::conformal_loss, Tip::none},
                                              {Law::opening_work, Tip::none}};
    const auto ranking = rank_models(models, pairs);
    const auto trials = model_trials(pairs, ranking, {}, {.runs = 2, .seed = 5, .threads = {1}, .cancelled = nullptr});
    ASSERT_FALSE(trials.empty());
    int runs = 0, excluded = 0;
    for (const auto& trial : trials) {
        EXPECT_EQ(trial.runs, 2);
        EXPECT_EQ(trial.found + trial.possible + trial.excluded, trial.runs) << trial.true_model.name();
        runs += trial.runs;
        excluded += trial.excluded;
    }
    EXPECT_LE(excluded, runs / 10);
    const auto again = model_trials(pairs, ranking, {}, {.runs = 2, .seed = 5, .threads = {2}, .cancelled = nullptr});
    for (std::size_t i = 0; i < trials.size(); ++i) EXPECT_EQ(trials[i].found, again[i].found);
}

TEST(Ranking, OfTooFewPairsReportsTheReason) {
    const Study study;
    auto pairs = study.simulated({Law::reversible, Tip::none}, 0.0, 0.01, 1);
    while (pairs.size() > 12) pairs.pop_back();  // of three surfaces
    const auto ranking = rank_models({{Law::reversible, Tip::none}}, pairs);
    EXPECT_EQ(ranking.best(), nullptr);
    ASSERT_EQ(ranking.unranked.size(), 1U);
    EXPECT_NE(ranking.unranked[0].reason.find("12 pairs on 3 surfaces"), std::string::npos)
        << ranking.unranked[0].reason;
}

TEST(RetractionPair, ConformalLossIncludesTheJumps) {
    const Study study;
    auto pair = study.pairs()[1];
    pair.radius = TracedValue(1.25e-3);
    pair.pressing = Pressing{.maximum_force = 1e-3};
    const FittedModel conformal{.model = {Law::conformal_loss, Tip::none}, .parameter = {}, .scatter = {}};
    const auto loop = predicted_retraction_loop(conformal, pair);
    ASSERT_TRUE(loop);
    const double area = pi * loop->contact_radius.value * loop->contact_radius.value;
    EXPECT_NEAR(loop->energy_loss.value / (0.037 * pair.rough.parameters.area_ratio() * area), 1.0, 1e-8);
    const auto& shares = loop->shares;
    EXPECT_NEAR((shares.jump_in.value + shares.jump_out.value + shares.crack_tip.value + shares.roughness.value) /
                    loop->energy_loss.value,
                1.0, 1e-12);
    EXPECT_EQ(shares.crack_tip.value, 0.0);
}

// the true-area loss (Eq. 10) gives the total; on a soft machine jumps are larger and the edge loses less
TEST(RetractionPair, SoftMachineIncreasesTheShareOfJumps) {
    const Study study;
    auto pair = study.pairs()[1];
    pair.radius = TracedValue(1.25e-3);
    pair.pressing = Pressing{.maximum_force = 1e-3};
    const FittedModel conformal{.model = {Law::conformal_loss, Tip::none}, .parameter = {}, .scatter = {}};
    const auto stiff = predicted_retraction_loop(conformal, pair);
    pair.machine_stiffness = TracedValue({.value = 50.0, .standard_error = 5.0}, "k_m");
    const auto soft = predicted_retraction_loop(conformal, pair);
    ASSERT_TRUE(stiff && soft);
    EXPECT_NEAR(soft->energy_loss.value / stiff->energy_loss.value, 1.0, 1e-8);
    const double jumps_of_soft = soft->shares.jump_in.value + soft->shares.jump_out.value;
    EXPECT_GT(jumps_of_soft, 1.05 * (stiff->shares.jump_in.value + stiff->shares.jump_out.value));
    EXPECT_LT(soft->work_retraction.value, stiff->work_retraction.value);
    const auto loop = sphere_loop(soft->sphere, {.maximum_force = 1e-3, .machine_stiffness = 50.0});
    EXPECT_NEAR(jumps_of_soft / (loop.jump_in_loss + loop.jump_out_loss), 1.0, 1e-9);
    EXPECT_EQ(soft->pressing.machine_stiffness, 50.0);
    EXPECT_TRUE(soft->shares.jump_in.components.contains("k_m"));
    EXPECT_FALSE(stiff->shares.jump_in.components.contains("k_m"));
}

TEST(RetractionPair, ErrorsFollowFromItsInputs) {
    const Study study;
    auto pair = study.pairs()[1];
    pair.work_of_adhesion = TracedValue({.value = 0.037, .standard_error = 0.001}, "W_int");
    pair.soft.contact_modulus = TracedValue({.value = 0.8e6, .standard_error = 0.02e6}, "E*");
    // W_ret = φ (W_int r − γ1 (r − 1) − E*u)
    const auto found =
        predicted_retraction({.model = {Law::reversible, Tip::reference}, .parameter = {}, .scatter = {}}, pair);
    const double r = pair.rough.parameters.area_ratio(), u = pair.rough.parameters.elastic_energy_per_modulus;
    const double expected = 1.4 * std::hypot(r * 0.001, u * 0.02e6);
    EXPECT_NEAR(found.standard_error() / expected, 1.0, 1e-9);
}

/// A pair that stores `share` of what conforming gains.
RetractionPair with_energy_share(double share) {
    static const Study study;  // pairs hold references to it
    auto pair = study.pairs()[12];
    const auto& p = pair.rough.parameters;
    const double r = p.area_ratio(), gain = 0.037 * r - 0.025 * (r - 1.0);
    pair.soft.contact_modulus = TracedValue(share * gain / p.elastic_energy_per_modulus);
    return pair;
}

double retraction_by(Law law, double parameter, const RetractionPair& pair) {
    return predicted_retraction({.model = {law, Tip::none}, .parameter = parameter, .scatter = {}}, pair).value;
}

// At U_el = AW simulated patches touch on 0.56 of their area and gain 0.1985 W (docs/validation/conformity.md): the
// contact stores the difference.
TEST(RetractionPair, OfPartialContactUsesTheAreaInContact) {
    const auto pair = with_energy_share(1.0);
    const double r = pair.rough.parameters.area_ratio(), gain = 0.037 * r - 0.025 * (r - 1.0);
    EXPECT_NEAR(retraction_by(Law::reversible, 0.0, pair) / gain, 0.1985, 1e-9);
    EXPECT_NEAR(retraction_by(Law::opening_work, 0.08, pair), 0.08 * 0.56 * r, 1e-9);
    EXPECT_NEAR(retraction_by(Law::conformal_loss, 0.0, pair), 0.1985 * gain + 0.037 * 0.56 * r, 1e-9);
    EXPECT_NEAR(retraction_by(Law::fitted_pinning, 0.25, pair), (0.1985 + 0.25 * (0.56 - 0.1985)) * gain, 1e-9);
    // of patches the area is known to 0.0255: W_ret by the opening work to that share of it
    const auto opening =
        predicted_retraction({.model = {Law::opening_work, Tip::none}, .parameter = 0.08, .scatter = {}}, pair);
    EXPECT_NEAR(opening.standard_error() / opening.value, 0.0255 / 0.56, 1e-3);
}

TEST(RetractionPair, OfFullContactUsesTheWholeSurface) {
    for (const double share : {0.02, 0.1, 0.15}) {
        const auto pair = with_energy_share(share);
        const double r = pair.rough.parameters.area_ratio(), gain = 0.037 * r - 0.025 * (r - 1.0);
        EXPECT_NEAR(retraction_by(Law::reversible, 0.0, pair), (1.0 - share) * gain, 1e-12) << share;
        EXPECT_NEAR(retraction_by(Law::opening_work, 0.08, pair), 0.08 * r, 1e-12) << share;
        EXPECT_NEAR(retraction_by(Law::fitted_pinning, 0.7, pair), (1.0 - share + 0.7 * share) * gain, 1e-12) << share;
    }
}

TEST(RetractionPair, CrackTipHasItsShareOfTheEdgeLoss) {
    const Study study;
    auto pair = study.pairs()[5];
    pair.radius = TracedValue(1.25e-3);
    pair.pressing = Pressing{.maximum_force = 1e-3};
    const auto loop =
        predicted_retraction_loop({.model = {Law::pinning, Tip::reference}, .parameter = {}, .scatter = {}}, pair);
    ASSERT_TRUE(loop);
    const double area = pi * loop->contact_radius.value * loop->contact_radius.value;
    EXPECT_NEAR(loop->shares.crack_tip.value / ((1.0 - 1.0 / 1.4) * loop->work_retraction.value * area), 1.0, 1e-9);
}

double pinned_loss(const RetractionPair& pair) {
    return retraction_by(Law::pinning, 0.0, pair) -
           predicted_approach({.model = {Law::pinning, Tip::none}}, pair).value;
}

/// A pair that stores 0.1 of its gain, pressed by 1 mN on a sphere.
RetractionPair on_sphere(double radius) {
    auto pair = with_energy_share(0.1);
    pair.radius = TracedValue(radius);
    pair.pressing = Pressing{.maximum_force = 1e-3};
    return pair;
}

// s = 0.1, λ̄ = π h²/2u, L_c = λ̄/4s; radii and lengths by the closed forms of JKR's contact of W
TEST(PairPinning, CountsLarkinLengthsOfTheEdge) {
    const auto pair = on_sphere(1.25e-3);
    const auto& p = pair.rough.parameters;
    const double r = p.area_ratio(), W = 0.037 * r - 0.025 * (r - 1.0), E = pair.soft.contact_modulus.value,
                 R = 1.25e-3;
    const double larkin = 0.5 * pi * 20e-9 * 20e-9 / p.elastic_energy_per_modulus / 0.4;
    const double at_pull_off = std::cbrt(9.0 * pi * W * R * R / (8.0 * E));
    const auto pinning = pinning_of(pair);
    EXPECT_NEAR(pinning.energy_share, 0.1, 1e-12);
    EXPECT_NEAR(*pinning.retraction.contact_radius / at_pull_off, 1.0, 1e-9);
    EXPECT_NEAR(pinning.retraction.larkin_lengths / (0.5 * pi * at_pull_off / larkin), 1.0, 1e-9);
    const double F = 1e-3, a = std::cbrt(0.75 * R / E *
                                         (F + 3.0 * pi * R * W +
                                          std::sqrt(6.0 * pi * R * W * F + std::pow(3.0 * pi * R * W, 2))));
    const double restoring = 4.0 * a / (R * std::sqrt(2.0 * pi * a * W / E)) - 1.0 / a;
    EXPECT_NEAR(*pinning.approach.contact_radius / a, 1.0, 1e-9);
    EXPECT_NEAR(pinning.approach.larkin_lengths / (pi / restoring / larkin), 1.0, 1e-9);
    const double stored = 0.1 * W, k_in = pinning_constant(0.1, pinning.approach.larkin_lengths),
                 k_out = pinning_constant(0.1, pinning.retraction.larkin_lengths);
    EXPECT_NEAR(pinned_loss(pair), (k_in + k_out) * stored, 1e-12);
    EXPECT_NEAR(predicted_approach({.model = {Law::pinning, Tip::none}}, pair).value, 0.9 * W - k_in * stored, 1e-12);
    auto measured = pair;
    measured.contact_area = TracedValue(pi * 4e-10);
    EXPECT_DOUBLE_EQ(*pinning_of(measured).approach.contact_radius, 2e-5) << "the measured radius, not JKR's";
    EXPECT_TRUE(pinning_of(measured).measured_radius);
}

TEST(PairPinning, TendsToTheInfiniteFrontOnALargeSphere) {
    auto endless = on_sphere(1.0);
    endless.radius.reset();
    const double most = pinned_loss(endless);
    EXPECT_TRUE(std::isinf(pinning_of(endless).approach.larkin_lengths));
    EXPECT_FALSE(pinning_of(endless).approach.measured);
    double last = 0.0;
    for (double radius = 1e-7; radius < 1e6; radius *= 10.0) {
        const double loss = pinned_loss(on_sphere(radius));
        EXPECT_GT(loss, last) << radius;
        EXPECT_LT(loss, most) << radius;
        last = loss;
    }
    EXPECT_NEAR(last / most, 1.0, 1e-2);
}

TEST(PairPinning, HasNoLossWithoutStoredEnergy) {
    const roughness::ParameterSpread none;
    for (const double share : {1e-3, 1e-5, 1e-8, 0.0}) {
        auto pair = on_sphere(1.25e-3);
        auto flat = pair.rough.parameters;
        flat.elastic_energy_per_modulus *= share;
        flat.rms_height *= std::sqrt(share);
        RetractionPair smooth{.rough = {"flat", flat, none},
                              .soft = pair.soft,
                              .work_of_adhesion = pair.work_of_adhesion,
                              .radius = pair.radius,
                              .pressing = pair.pressing,
                              .bands = pair.bands};
        const double gain = 0.037 * flat.area_ratio() - 0.025 * (flat.area_ratio() - 1.0);
        for (const Law law : {Law::pinning, Law::pinning_by_bands})
            EXPECT_NEAR(retraction_by(law, 0.0, smooth) / gain, 1.0, share) << share;
    }
}

TEST(RetractionModel, RefusesInvalidPairs) {
    EXPECT_THROW((void)retraction_line({Law::pinning, Tip::none}, {.area_ratio = 0.9, .work_of_adhesion = 0.04}, {}),
                 InvalidArgument);
    EXPECT_THROW((void)retraction_line({Law::pinning, Tip::none}, {.work_of_adhesion = 0.0}, {}), InvalidArgument);
}

}  // namespace
}  // namespace setae::hysteresis
