// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/validation/law_recovery.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"

namespace setae::validation::law_recovery_test {
namespace {

using hysteresis::Law;
using hysteresis::RetractionModel;

simulation::Recipe recipe() {
    simulation::Recipe recipe;
    recipe.work_of_adhesion = 0.037;
    recipe.elastomers.resize(3);
    recipe.loops.emplace();
    recipe.loops->reference_work = 0.04;
    return recipe;
}

TEST(ModelRecovery, ListsTheModelsThatRecipesCanSimulate) {
    EXPECT_EQ(simulated_models().size(), 12U);
    const auto named = simulated_models({"crack_tip_pinning", "opening_work"});
    ASSERT_EQ(named.size(), 2U);
    EXPECT_EQ(named[0], (RetractionModel{Law::pinning, hysteresis::Tip::reference}));
    EXPECT_EQ(named[1], (RetractionModel{Law::opening_work, hysteresis::Tip::none}));
    EXPECT_EQ(simulated_models({"all"}), simulated_models());
    EXPECT_THROW((void)simulated_models({"opening"}), InvalidArgument);
}

TEST(ModelRecovery, SetsTheSpeedOfTheCrackTip) {
    using hysteresis::Tip;
    const auto made = with_model(recipe(), {Law::opening_work, Tip::speed});
    ASSERT_TRUE(made.elastomers[0].body.edge && made.elastomers[2].body.edge);
    EXPECT_DOUBLE_EQ(made.elastomers[2].body.edge->reference_speed, 4e-6);
    EXPECT_EQ(made.elastomers[0].tip_factor, 1.0);
    auto stated_value = recipe();
    stated_value.elastomers[1].body.edge = hysteresis::EdgeSpeed{.reference_speed = 7e-6, .exponent = 0.5};
    EXPECT_FALSE(with_model(stated_value, {Law::pinning, Tip::speed}).elastomers[0].body.edge) << "the recipe's own";
    EXPECT_DOUBLE_EQ(with_model(stated_value, {Law::pinning, Tip::speed}).elastomers[1].body.edge->reference_speed,
                     7e-6);
    EXPECT_FALSE(with_model(stated_value, {Law::pinning, Tip::reference}).elastomers[1].body.edge);
}

TEST(ModelRecovery, SetsOneRetractionModelOnly) {
    auto stated_value = recipe();
    stated_value.elastomers[1].tip_factor = 1.7;
    const auto opening = with_model(stated_value, {Law::opening_work, hysteresis::Tip::none});
    EXPECT_EQ(opening.loops->law, simulation::RetractionChoice::opening);
    EXPECT_DOUBLE_EQ(opening.loops->opening_work, 0.074);
    EXPECT_EQ(opening.elastomers[1].tip_factor, 1.0) << "the crack tip is another mechanism";
    EXPECT_EQ(with_model(stated_value, {Law::pinning, hysteresis::Tip::reference}).elastomers[1].tip_factor, 1.7);
    const auto tip = with_model(recipe(), {Law::reversible, hysteresis::Tip::reference});
    EXPECT_DOUBLE_EQ(tip.elastomers[0].tip_factor, 1.5);
    EXPECT_DOUBLE_EQ(tip.elastomers[2].tip_factor, 1.3);
}

TEST(ModelRecovery, RefusesModelsTheRecipeLacksDataFor) {
    auto smooth = recipe();
    smooth.loops->reference_work.reset();
    EXPECT_THROW((void)with_model(smooth, {Law::reversible, hysteresis::Tip::reference}), InvalidArgument);
    smooth.loops.reset();
    EXPECT_THROW((void)with_model(smooth, {Law::reversible, hysteresis::Tip::none}), InvalidArgument);
}

TEST(ModelRecovery, CountsOutcomesPerModel) {
    std::vector<ModelRecovery> list(4);
    for (auto& one : list) one.true_model = "pinning";
    list[0].found = "pinning";
    list[1].found = list[2].found = "reversible";
    list[1].possible = true;
    list[3].true_model = list[3].found = "reversible";
    const auto rows = summary(list);
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].runs, 3);
    EXPECT_EQ(rows[0].found, 1);
    EXPECT_EQ(rows[0].possible, 1);
    EXPECT_EQ(rows[0].excluded, 1);
    EXPECT_EQ(rows[0].most_taken, "reversible");
    EXPECT_TRUE(std::isnan(rows[0].parameter));
    EXPECT_EQ(rows[1].excluded, 0);
}

}  // namespace
}  // namespace setae::validation::law_recovery_test
