// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/simulation/recipe.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include <unistd.h>

#include "setae/bytes/whole_file.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/simulation/data_set.hpp"

namespace setae::simulation::recipe_test {
namespace {

constexpr const char* head = R"(
seed = 3
work_of_adhesion = ["30 mJ/m2", "40 mJ/m2"]
[rough_solid]
youngs_modulus = "1100 GPa"
[protocols.p]
stylus = { lengths = ["20 um", "10 um"], step = ["0.2 um", "0.1 um"], tip_radius = "5 um" }
afm = { sizes = ["100 nm"], pixels = [32] }
tem = { lengths = ["20 nm"], steps = "uniform" }
[elastomers.soft]
youngs_modulus = ["0.1 MPa", "10 MPa"]
surface_energy = "25 mJ/m2"
sphere_radius = "1 mm"
)";

constexpr const char* drawn_surface = R"(
protocol = "p"
skewness = [0.2, 0.8]
spectrum = { model = "self_affine", hurst_exponent = [0.7, 0.95], rolloff_wavelength = ["0.3 um", "4 um"], short_wavelength = "1 nm", rms_slope = [0.3, 1.5] }
)";

std::string surface(const std::string& name) { return "[surfaces." + name + "]" + drawn_surface; }

/// A file of this process alone: tests run beside each other.
struct RecipeFile {
    explicit RecipeFile(const std::string& text) { bytes::write_whole_file(path, text); }
    ~RecipeFile() { std::filesystem::remove(path); }
    std::string path =
        (std::filesystem::path(testing::TempDir()) / ("setae_recipe_" + std::to_string(::getpid()) + ".toml")).string();
};

Recipe recipe_of(const std::string& text, std::optional<std::uint64_t> seed = {}) {
    const RecipeFile file(text);
    return read_recipe(file.path, seed);
}

double parameter(const SurfaceRecipe& rough, const std::string& key) {
    for (const auto& p : rough.parameters)
        if (p.key == key) return p.value;
    return undefined;
}

/// The error of a recipe in which `from` reads `to`.
std::string refusal(const std::string& from, const std::string& to) {
    std::string text = head + surface("A");
    text.replace(text.find(from), from.size(), to);
    try {
        (void)recipe_of(text);
    } catch (const FormatError& error) {
        return error.what();
    }
    return "";
}

TEST(RecipeRanges, AreDrawnFromTheSeedWithinTheirLimits) {
    const std::string text = head + surface("A");
    const Recipe first = recipe_of(text), again = recipe_of(text), other = recipe_of(text, 4);
    EXPECT_EQ(other.seed, 4u);
    EXPECT_EQ(recipe_of(text, 3).work_of_adhesion, first.work_of_adhesion);
    for (const char* key : {"hurst_exponent", "rolloff_wavelength", "rms_slope", "skewness"}) {
        EXPECT_EQ(parameter(first.surfaces[0], key), parameter(again.surfaces[0], key)) << key;
        EXPECT_NE(parameter(first.surfaces[0], key), parameter(other.surfaces[0], key)) << key;
    }
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Recipe drawn = recipe_of(text, seed);
        const double slope = parameter(drawn.surfaces[0], "rms_slope"),
                     modulus = drawn.elastomers[0].youngs_modulus.value;
        EXPECT_TRUE(slope > 0.3 && slope < 1.5) << slope;
        EXPECT_TRUE(modulus > 1e5 && modulus < 1e7) << modulus;
        EXPECT_TRUE(drawn.work_of_adhesion > 0.030 && drawn.work_of_adhesion < 0.040);
        EXPECT_EQ(drawn.surfaces[0].surface.skewness, parameter(drawn.surfaces[0], "skewness"));
    }
}

TEST(RecipeRanges, AreDrawnUniformlyInTheLogarithm) {
    double sum = 0.0, squares = 0.0;
    constexpr int seeds = 300;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        const double place =
            std::log(recipe_of(head + surface("A"), seed).elastomers[0].youngs_modulus.value / 1e5) / std::log(100.0);
        sum += place;
        squares += place * place;
    }
    // standard errors of the mean and mean square of uniform numbers: √(1/12/n), √(4/45/n)
    EXPECT_NEAR(sum / seeds, 1.0 / 2.0, 3.0 * std::sqrt(1.0 / 12.0 / seeds));
    EXPECT_NEAR(squares / seeds, 1.0 / 3.0, 3.0 * std::sqrt(4.0 / 45.0 / seeds));
}

TEST(RecipeRanges, DoNotDependOnOtherSurfaces) {
    const Recipe alone = recipe_of(head + surface("B")), both = recipe_of(head + surface("A") + surface("B"));
    ASSERT_EQ(both.surfaces.size(), 2u);
    for (const char* key : {"hurst_exponent", "rolloff_wavelength", "rms_slope", "skewness"}) {
        EXPECT_EQ(parameter(alone.surfaces[0], key), parameter(both.surfaces[1], key)) << key;
        EXPECT_NE(parameter(both.surfaces[0], key), parameter(both.surfaces[1], key)) << key;
    }
    EXPECT_EQ(alone.work_of_adhesion, both.work_of_adhesion);
}

TEST(RecipeRanges, AreRefusedWhereInvalid) {
    EXPECT_NE(refusal("rms_slope = [0.3, 1.5]", "rms_slope = [1.5, 0.3]").find("0 < from <= to"), std::string::npos);
    EXPECT_NE(refusal("rms_slope = [0.3, 1.5]", "rms_slope = [0, 0.3]").find("0 < from <= to"), std::string::npos);
    EXPECT_NE(refusal("rms_slope = [0.3, 1.5]", "rms_slope = [0.3]").find("[from, to]"), std::string::npos);
    EXPECT_NE(refusal("\"4 um\"", "\"4 J\"").find("rolloff_wavelength"), std::string::npos);
    EXPECT_EQ(refusal("rms_slope = [0.3, 1.5]", "rms_slope = [0.3, 0.3]"), "");
}

TEST(RecipeSpectra, HaveTheRequestedSlopeForEveryModel) {
    for (const char* model :
         {"model = \"soft_cutoff\"", "model = \"bump\", bump_wavelength = \"50 nm\", bump_excess = 2.0",
          "model = \"two_slopes\", crossover_wavelength = \"50 nm\", short_hurst_exponent = 0.6"}) {
        std::string text = head + surface("A");
        text.replace(text.find("model = \"self_affine\""), 21, model);
        text.replace(text.find("skewness = [0.2, 0.8]"), 21, "");
        const Recipe recipe = recipe_of(text);
        const auto truth = true_surface_values(recipe.surfaces[0].surface);
        EXPECT_NEAR(truth.parameters.rms_slope / parameter(recipe.surfaces[0], "rms_slope"), 1.0, 1e-6) << model;
    }
}

TEST(RecipeProtocols, NameContradictionsInTheError) {
    EXPECT_NE(refusal("step = [\"0.2 um\", \"0.1 um\"]", "step = [\"0.2 um\", \"0.1 um\", \"1 um\"]")
                  .find("3 values for 2 measurements"),
              std::string::npos);
    EXPECT_NE(refusal("step = [\"0.2 um\", \"0.1 um\"]", "step = \"11 um\"").find("length/2"), std::string::npos);
    EXPECT_NE(refusal("pixels = [32]", "pixels = [32, 64]").find("2 values for 1"), std::string::npos);
    EXPECT_NE(refusal("pixels = [32]", "pixels = [4096]").find("2 to 2048"), std::string::npos);
    EXPECT_NE(refusal("tip_radius = \"5 um\"", "tip_radius = \"5 um\", tip = \"none\"").find("one of them"),
              std::string::npos);
    EXPECT_NE(refusal("tip_radius = \"5 um\"", "tip = \"cone\"").find("none"), std::string::npos);
    EXPECT_NE(refusal("tip_radius = \"5 um\"", "noise = \"-1 nm\"").find("noise"), std::string::npos);
    EXPECT_NE(refusal("steps = \"uniform\"", "steps = \"even\"").find("regular, uniform, gamma"), std::string::npos);
    EXPECT_NE(refusal("steps = \"uniform\"", "steps = \"uniform\", step_spread = 0.6").find("step_spread"),
              std::string::npos);
    EXPECT_NE(refusal("[surfaces.A]", "[surfaces.A]\nanisotropy = { stretch = 0.5 }").find("stretch"),
              std::string::npos);
    EXPECT_NE(refusal("[surfaces.A]", "[surfaces.A]\nanisotropy = { stretch = 2 }").find("Gaussian heights"),
              std::string::npos);
    EXPECT_NE(refusal("[surfaces.A]", "[loops]\nnonconforming = \"drop\"\n[surfaces.A]").find("refuse, skip"),
              std::string::npos);
}

TEST(RecipeProtocols, TakeOneValueForAllScansOrOnePerScan) {
    const Recipe recipe = recipe_of(head + surface("A"));
    EXPECT_EQ(recipe.surfaces[0].stylus->step(1), 0.1e-6);
    EXPECT_EQ(recipe.surfaces[0].afm->pixels_of(0), 32);
    EXPECT_EQ(recipe.surfaces[0].tem->steps, ContourSteps::uniform);
    std::string text = head + surface("A");
    text.replace(text.find("tip_radius = \"5 um\""), 19, "tip = \"none\"");
    EXPECT_EQ(recipe_of(text).surfaces[0].stylus->tip_radius, 0.0);
}

TEST(ReadRecipe, ReadsTheScatterOfWorks) {
    const auto scatter =
        recipe_of(head + surface("A") + "[loops]\nwork_scatter = { pair = \"0.5 mJ/m2\", elastomer = \"1 mJ/m2\" }\n")
            .loops->work_scatter;
    EXPECT_DOUBLE_EQ(scatter.pair, 5e-4);
    EXPECT_EQ(scatter.surface, 0.0);
    EXPECT_DOUBLE_EQ(scatter.elastomer, 1e-3);
    try {
        (void)recipe_of(head + surface("A") + "[loops]\nwork_scatter = { pair = \"-1 mJ/m2\" }\n");
        ADD_FAILURE() << "a scatter below 0 was taken";
    } catch (const FormatError& error) {
        EXPECT_NE(std::string(error.what()).find("expected a standard deviation from 0"), std::string::npos);
    }
}

TEST(KnownLoops, SkipPairsWithoutFullContactOnRequest) {
    const std::string stiff =
        "[elastomers.stiff]\nyoungs_modulus = \"1 GPa\"\nsurface_energy = \"25 mJ/m2\"\nsphere_radius = \"1 mm\"\n";
    const auto loops = [&](const std::string& choice) {
        return known_loops(recipe_of(head + surface("A") + stiff + "[loops]\n" + choice));
    };
    EXPECT_THROW((void)loops(""), InvalidArgument);
    const auto kept = loops("nonconforming = \"skip\"");
    ASSERT_EQ(kept.size(), 1u);
    EXPECT_EQ(kept[0].elastomer, "soft");
    // jumps that lose more than a hundredth of W_int A_true
    EXPECT_EQ(loops("nonconforming = \"skip\"\nloss_factor = 0.01").size(), 0u);
    // what is wrong with the testing machine is no matter of conforming
    EXPECT_THROW((void)loops("nonconforming = \"skip\"\nspeed = \"-1 nm/s\""), InvalidArgument);
}

TEST(ClosureRecipes, GiveFullContactForMostPairsForEverySeed) {
    for (const char* name :
         {"standard", "soft_cutoff", "two_slopes", "bump", "non_gaussian", "anisotropic", "no_rolloff"})
        for (const std::uint64_t seed : {1u, 2u}) {
            const Recipe recipe = read_recipe(std::string("examples/closure/") + name + ".toml", seed);
            EXPECT_EQ(recipe.surfaces.size(), 4u) << name;
            EXPECT_GE(known_loops(recipe).size(), 12u) << name << ", seed " << seed;
        }
}

// Three of twelve pairs are predicted by the study. All are in full contact, so that a true value exists.
TEST(ClosureRecipes, LeaveThreePairsUnmeasuredForPrediction) {
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
        const auto loops = known_loops(read_recipe("examples/closure/calibrated.toml", seed));
        EXPECT_EQ(loops.size(), 12u) << seed;
        EXPECT_EQ(std::count_if(loops.begin(), loops.end(), [](const auto& loop) { return !loop.measured; }), 3)
            << seed;
    }
}

}  // namespace
}  // namespace setae::simulation::recipe_test
