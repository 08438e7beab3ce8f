// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/validation/next_trials.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "setae/core/errors.hpp"
#include "setae/simulation/data_set.hpp"

namespace setae::validation::next_trials_test {
namespace {

using adhesion::Candidate;
using Kind = Candidate::Kind;

simulation::Recipe recipe() {
    const auto path =
        std::filesystem::path(testing::TempDir()) / ("setae_next_" + std::to_string(::getpid()) + ".toml");
    std::ofstream(path) << R"(
work_of_adhesion = "37 mJ/m2"
shared_tips = true
[calibrations]
force = "1 ± 0.01"
[rough_solid]
youngs_modulus = "1100 GPa"
[protocols.p]
afm = { sizes = ["5 um", "1 um"], pixels = 64, tip_radius = "10 ± 1 nm" }
tem = { lengths = ["60 nm"], step = "0.5 nm" }
[surfaces.A]
protocol = "p"
spectrum = { model = "self_affine", hurst_exponent = 0.8, rolloff_wavelength = "1 um", short_wavelength = "1 nm", rms_slope = 0.4 }
[elastomers.E07]
youngs_modulus = "0.7 ± 0.02 MPa"
tell_modulus = true
surface_energy = "25 mJ/m2"
sphere_radius = "1.2 to 1.3 mm"
[elastomers.E10]
youngs_modulus = "1 MPa"
surface_energy = "25 mJ/m2"
sphere_radius = "1.25 mm"
[loops]
force_noise = "0.1 uN"
)";
    return simulation::read_recipe(path.string());
}

TEST(RecipeWith, ABetterKnownInputHalvesItsDeviation) {
    const auto before = recipe();
    const auto after = recipe_with(before, {.kind = Kind::input, .name = "force_calibration"});
    const auto &was = *before.calibrations.force, &is = *after.calibrations.force;
    EXPECT_DOUBLE_EQ(is.stated_value.value, was.stated_value.value);
    EXPECT_DOUBLE_EQ(is.stated_value.standard_error, 0.005);
    EXPECT_NEAR(is.value - is.stated_value.value, 0.5 * (was.value - was.stated_value.value), 1e-15);
    EXPECT_NE(is.value, is.stated_value.value);
}

TEST(RecipeWith, ASharedTipChangesEveryProtocol) {
    const auto after = recipe_with(recipe(), {.kind = Kind::input, .name = "afm_tip"});
    EXPECT_DOUBLE_EQ(after.surfaces.front().afm->shared_tip_radius.value(), after.afm_tip->value);
    EXPECT_DOUBLE_EQ(after.afm_tip->stated_value.standard_error, 0.5e-9);
}

TEST(RecipeWith, AnUnnamedInputIsFoundByItsPath) {
    const auto modulus = recipe_with(recipe(), {.kind = Kind::input, .name = "elastomers.E07.youngs_modulus"});
    EXPECT_DOUBLE_EQ(modulus.elastomers.front().youngs_modulus.stated_value.standard_error, 1e4);
    const auto radius = recipe_with(recipe(), {.kind = Kind::input, .name = "elastomers.E07.sphere_radius"});
    const auto range = radius.elastomers.front().sphere_radius.stated_value.interval.value();
    EXPECT_NEAR(range.upper - range.lower, 0.05e-3, 1e-12);
    EXPECT_THROW((void)recipe_with(recipe(), {.kind = Kind::input, .name = "lens_9"}), InvalidArgument);
}

TEST(RecipeWith, ARemeasuredSurfaceHasEveryMeasurementTwice) {
    const auto after = recipe_with(recipe(), {.kind = Kind::spectrum, .name = "A"});
    const auto& rough = after.surfaces.front();
    const auto once = recipe().surfaces.front().afm->sizes;
    EXPECT_EQ(rough.afm->sizes, (std::vector<double>{once[0], once[1], once[0], once[1]}));
    EXPECT_EQ(rough.tem->lengths.size(), 2U);
    EXPECT_EQ(rough.afm->pixels.size(), 1U);
}

// The further loop has a file and noise of its own; every other loop stays what it was.
TEST(RecipeWith, AnotherLoopBelongsToTheSamePair) {
    const auto before = simulation::known_loops(recipe());
    const auto after =
        simulation::known_loops(recipe_with(recipe(), {.kind = Kind::loop, .name = "A", .elastomer = "E07"}));
    ASSERT_EQ(after.size(), before.size() + 1);
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(after[i].file, before[i].file);
    EXPECT_EQ(after.back().file, "loops/A_E07_2.csv");
    EXPECT_EQ(after.back().number, 2);
    EXPECT_EQ(after.back().specimen.work_approach, before.front().specimen.work_approach);
}

TEST(NextSummary, ComparesPredictedWithActualImprovement) {
    const std::vector<NextTrial> trials{{0, "lens", 3e-3, 1e-3, 4e-3, 2e-3, 2e-3},
                                        {1, "lens", -4e-3, 2e-3, 4e-3, 2e-3, 1e-3},
                                        {0, "A", 1e-3, 1e-3, 4e-3, 3e-3, 3e-3}};
    const auto rows = summary(trials);
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].n, 2);
    EXPECT_NEAR(rows[0].off, std::sqrt(12.5) * 1e-3, 1e-12);
    EXPECT_NEAR(rows[0].off_later, std::sqrt(2.5) * 1e-3, 1e-12);
    EXPECT_NEAR(rows[0].ratio, std::sqrt(0.2), 1e-12);
    // without one run or the other: 2/4 and 1/3
    const double squares = std::pow(0.5 - rows[0].ratio, 2) + std::pow(1.0 / 3.0 - rows[0].ratio, 2);
    EXPECT_NEAR(rows[0].ratio_error, std::sqrt(0.5 * squares), 1e-12);
    EXPECT_NEAR(rows[0].stated_later, std::sqrt(2.5) * 1e-3, 1e-12);
    EXPECT_TRUE(std::isnan(rows[1].ratio_error));
}

TEST(NextTrials, RefuseUnknownMeasurements) {
    const auto folder = std::filesystem::path(testing::TempDir()) / ("setae_next_trials_" + std::to_string(::getpid()));
    const auto path =
        std::filesystem::path(testing::TempDir()) / ("setae_next_" + std::to_string(::getpid()) + ".toml");
    (void)recipe();
    try {
        (void)next_trials(path.string(), {.runs = 5, .measured = {"lense"}, .folder = folder.string()});
        FAIL() << "measured";
    } catch (const InvalidArgument& refusal) {
        EXPECT_NE(std::string(refusal.what()).find("'lense' is nothing that could be measured next"), std::string::npos)
            << refusal.what();
    }
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace setae::validation::next_trials_test
