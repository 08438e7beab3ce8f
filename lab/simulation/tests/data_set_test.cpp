// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/simulation/data_set.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "setae/adhesion/partial_contact.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/channel.hpp"
#include "setae/roughness/true_area.hpp"

namespace setae::simulation::data_set_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* small_recipe = R"(
seed = 3
work_of_adhesion = "37 mJ/m2"
[rough_solid]
youngs_modulus = "1100 GPa"
poisson_ratio = 0.06
[protocols.tiny]
stylus = { lengths = ["20 um"], step = "0.2 um", tip_radius = "5 um" }
afm = { sizes = ["100 nm"], pixels = 32 }
tem = { lengths = ["20 nm"], noise = "0.01 nm" }
[surfaces.A]
protocol = "tiny"
spectrum = { model = "self_affine", hurst_exponent = 0.8, rolloff_wavelength = "1 um", short_wavelength = "1 nm", rms_slope = 0.5 }
[surfaces.B]
protocol = "tiny"
skewness = 0.5
spectrum = { model = "two_slopes", hurst_exponent = 0.9, short_hurst_exponent = 0.7, crossover_wavelength = "50 nm", rolloff_wavelength = "1 um", short_wavelength = "1 nm", rms_height = "10 nm" }
[elastomers.soft]
youngs_modulus = "0.7 MPa"
surface_energy = "25 ± 1 mJ/m2"
sphere_radius = "1.25 mm"
[loops]
reference_work = "40 mJ/m2"
force_noise = "0.1 uN"
loss_factor = 1.2
)";

fs::path scratch(const std::string& name) {
    const fs::path folder = fs::path(testing::TempDir()) / ("setae_data_set_" + name);
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

Recipe recipe_of(const std::string& text, const std::string& name) {
    const std::string path = (scratch(name) / "recipe.toml").string();
    bytes::write_whole_file(path, text);
    return read_recipe(path);
}

KnownSurface self_affine(const spectra::SelfAffine& model, double skewness = 0.0) {
    return {.C_iso = spectra::density(model),
            .rolloff_wavelength = 2.0 * pi / model.rolloff_wavevector,
            .short_wavelength = 2.0 * pi / model.short_wavevector,
            .skewness = skewness};
}

constexpr spectra::SelfAffine model{
    .plateau = 1e-29, .rolloff_wavevector = 6e6, .hurst_exponent = 0.8, .short_wavevector = 1.5e10};

TEST(TrueSurfaceValues, ForGaussianHeightsMatchTheClosedForm) {
    const TrueSurfaceValues truth = true_surface_values(self_affine(model));
    EXPECT_NEAR(truth.parameters.rms_height / spectra::rms_height(model), 1.0, 1e-6);
    EXPECT_NEAR(truth.parameters.rms_slope / spectra::rms_slope(model), 1.0, 1e-6);
    EXPECT_NEAR(truth.parameters.rms_curvature / spectra::rms_curvature(model), 1.0, 1e-6);
    EXPECT_NEAR(truth.parameters.elastic_energy_per_modulus / (spectra::moment(model, 1.0) / (8.0 * pi)), 1.0, 1e-6);
    const Array1D exact = spectra::profile_power_spectrum(model, truth.C1D.wavevector);
    const Index inner = truth.C1D.wavevector.size() - 3;  // profile_density is less exact close to q_s, and 1.2e-3 off
                                                          // at the roll-off, where C_iso bends between nodes
    for (Index i = 0; i < inner; ++i)
        EXPECT_NEAR(truth.C1D.density[i] / exact[i], 1.0, 2e-3) << truth.C1D.wavevector[i];
}

TEST(TrueSurfaceValues, TendToGaussianValuesForSmallSkewness) {
    const TrueSurfaceValues gaussian = true_surface_values(self_affine(model)),
                            skewed = true_surface_values(self_affine(model, 1e-3));
    EXPECT_NEAR(skewed.parameters.rms_slope / gaussian.parameters.rms_slope, 1.0, 1e-5);
    EXPECT_NEAR(skewed.parameters.rms_curvature / gaussian.parameters.rms_curvature, 1.0, 1e-5);
    EXPECT_NEAR(skewed.area_ratio, gaussian.area_ratio, 1e-5);
    EXPECT_NEAR(skewed.parameters.elastic_energy_per_modulus / gaussian.parameters.elastic_energy_per_modulus, 1.0,
                1e-3);
}

TEST(TrueSurfaceValues, HaveTheSlopeOfLogNormalHeightsInClosedForm) {
    // g = (exp(σz − σ²/2) − 1)/√(e^σ² − 1): ⟨g'²⟩ = σ² e^σ²/(e^σ² − 1); a skewness of 0.6 has σ = 0.195550204
    constexpr double sigma2 = 0.195550204 * 0.195550204;
    const double stretch = sigma2 * std::exp(sigma2) / std::expm1(sigma2);
    const double skewed = true_surface_values(self_affine(model, 0.6)).parameters.rms_slope;
    EXPECT_NEAR(std::pow(skewed / spectra::rms_slope(model), 2), stretch, 1e-5);
}

TEST(KnownLoops, HaveFullContactBalanceWorkAndTheRequestedLoss) {
    const Recipe recipe = recipe_of(small_recipe, "balance");
    const auto loops = known_loops(recipe);
    ASSERT_EQ(loops.size(), 4u);
    const TrueSurfaceValues surface = true_surface_values(recipe.surfaces[0].surface);
    EXPECT_NEAR(surface.parameters.rms_slope, 0.5, 1e-9);
    const double r = surface.area_ratio, E = loops[0].specimen.contact_modulus;
    EXPECT_NEAR(E, 0.7e6 / 0.75, 2e-6 * E);  // diamond is 1.6e6 times stiffer
    EXPECT_NEAR(loops[0].specimen.work_approach,
                0.037 * r - 0.025 * (r - 1.0) - E * surface.parameters.elastic_energy_per_modulus, 1e-12);
    EXPECT_NEAR(loops[0].truth.energy_loss() / (1.2 * 0.037 * r * loops[0].truth.largest_contact_area()), 1.0, 1e-9);
    EXPECT_EQ(loops[2].specimen.work_retraction, 0.040);
    EXPECT_EQ(loops[3].stage, "after");
}

// Where little is stored both are alike; a stiff body touches in part, gains more than (7) and opens less
TEST(KnownLoops, HavePartialContactWhereTheRecipeRequestsIt) {
    Recipe recipe = recipe_of(small_recipe, "partial");
    recipe.loops->reference_work.reset();
    recipe.surfaces.resize(1);
    recipe.loops->law = RetractionChoice::opening;
    recipe.loops->opening_work = 0.12;
    const TrueSurfaceValues surface = true_surface_values(recipe.surfaces[0].surface);
    const double r = surface.area_ratio, gain = 0.037 * r - 0.025 * (r - 1.0);
    const auto known_specimen = [&](double energy_share, KnownContact contact) {
        recipe.loops->contact = contact;
        auto& elastomer = recipe.elastomers[0];
        const double wanted = energy_share * gain / surface.parameters.elastic_energy_per_modulus;
        elastomer.youngs_modulus.value = wanted * (1.0 - std::pow(elastomer.poisson_ratio, 2));
        return known_loops(recipe, {surface})[0].specimen;
    };
    const auto soft = known_specimen(0.1, KnownContact::full),
               soft_in_part = known_specimen(0.1, KnownContact::patches);
    EXPECT_NEAR(soft_in_part.work_approach / soft.work_approach, 1.0, 1e-6);
    EXPECT_NEAR(soft_in_part.work_retraction / soft.work_retraction, 1.0, 1e-6);
    const auto stiff = known_specimen(0.7, KnownContact::full),
               stiff_in_part = known_specimen(0.7, KnownContact::patches);
    const auto contact = adhesion::unloaded_contact(0.7);
    EXPECT_NEAR(stiff.work_approach / gain, 0.3, 1e-3);
    EXPECT_NEAR(stiff_in_part.work_approach / gain, contact.gain, 1e-3);
    EXPECT_NEAR(stiff_in_part.work_retraction, 0.12 * contact.area_fraction * r, 1e-4);
    EXPECT_NEAR(stiff.work_retraction, 0.12 * r, 1e-9);
}

// Surfaces alike and elastomers alike, so that the whole difference is what was drawn.
TEST(KnownLoops, ScatterByPairSurfaceAndElastomerAsRequested) {
    Recipe recipe = recipe_of(small_recipe, "scattered");
    recipe.loops->reference_work.reset();
    const auto surface = recipe.surfaces[0];
    const auto elastomer = recipe.elastomers[0];
    constexpr int count = 12;
    recipe.surfaces.assign(count, surface);
    recipe.elastomers.assign(count, elastomer);
    for (int i = 0; i < count; ++i) {
        recipe.surfaces[static_cast<std::size_t>(i)].surface.name = "S" + std::to_string(i);
        recipe.elastomers[static_cast<std::size_t>(i)].name = "E" + std::to_string(i);
    }
    const std::vector<TrueSurfaceValues> truths(count, true_surface_values(surface.surface));
    const double planned = known_loops(recipe, truths)[0].specimen.work_approach;
    const auto departures = [&](const WorkScatter& scatter) {
        recipe.loops->work_scatter = scatter;
        const auto loops = known_loops(recipe, truths);
        Array2D result(count, count);
        for (std::size_t k = 0; k < loops.size(); ++k) result.data()[k] = loops[k].specimen.work_approach - planned;
        return result;
    };
    constexpr double deviation = 1e-3;
    const Array2D pairs = departures({.pair = deviation}), surfaces = departures({.surface = deviation}),
                  elastomers = departures({.elastomer = deviation});
    // 144 and 12 normal numbers: 95 % of roots of mean squares lie within
    EXPECT_NEAR(std::sqrt(pairs.square().mean()) / deviation, 1.0, 0.15);
    EXPECT_NEAR(std::sqrt(surfaces.square().mean()) / deviation, 1.0, 0.4);
    EXPECT_NEAR(std::sqrt(elastomers.square().mean()) / deviation, 1.0, 0.4);
    EXPECT_LT((surfaces.colwise() - surfaces.col(0)).abs().maxCoeff(), 1e-15);
    EXPECT_LT((elastomers.rowwise() - elastomers.row(0)).abs().maxCoeff(), 1e-15);
    const Array2D all = departures({deviation, deviation, deviation});
    EXPECT_LT((all - pairs - surfaces - elastomers).abs().maxCoeff(), 1e-14);
    recipe.seed += 1;
    EXPECT_GT((departures({.pair = deviation}) - pairs).abs().minCoeff(), 0.0);
}

TEST(KnownLoops, RefusePairsWithoutFullContactByName) {
    Recipe recipe = recipe_of(small_recipe, "stiff");
    recipe.elastomers[0].youngs_modulus.value = 1e9;
    try {
        (void)known_loops(recipe);
        FAIL();
    } catch (const InvalidArgument& error) {
        EXPECT_NE(std::string(error.what()).find("surface A on elastomer soft"), std::string::npos) << error.what();
    }
}

TEST(MakeDataSet, DependsOnTheSeedButNotOnTheNumberOfThreads) {
    Recipe recipe = recipe_of(small_recipe, "recipe");
    recipe.loops.reset();
    const fs::path one = scratch("one"), three = scratch("three"), other = scratch("other");
    const auto files = make(recipe, one.string(), {1});
    EXPECT_EQ(files, make(recipe, three.string(), {3}));
    recipe.seed = 4;
    make(recipe, other.string(), {2});
    for (const auto& file : files)
        EXPECT_EQ(bytes::read_file((one / file).string()), bytes::read_file((three / file).string())) << file;
    for (const char* file : {"A/stylus_1.csv", "A/afm_1.txt", "A/tem_1.csv"})
        EXPECT_NE(bytes::read_file((one / file).string()), bytes::read_file((other / file).string())) << file;
    const auto map = std::get<topography::HeightMap>(formats::read((one / "A/afm_1.txt").string(), 0, {}));
    EXPECT_EQ(map.heights.rows(), 32);
    EXPECT_NEAR(map.size[0], 100e-9, 1e-15);
}

TEST(ReadRecipe, NamesContradictionsInTheError) {
    const auto message = [](const std::string& from, const std::string& to) {
        std::string text = small_recipe;
        text.replace(text.find(from), from.size(), to);
        try {
            (void)recipe_of(text, "bad");
        } catch (const FormatError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_NE(message("rms_slope = 0.5", "rms_slope = 0.5, rms_height = \"1 nm\"").find("exactly one"),
              std::string::npos);
    EXPECT_NE(message("protocol = \"tiny\"", "protocol = \"tny\"").find("'tny' is not declared"), std::string::npos);
    EXPECT_NE(message("loss_factor", "los_factor").find("loss_factor"), std::string::npos);
    EXPECT_NE(message("rolloff_wavelength = \"1 um\"", "rolloff_wavelength = \"0.5 nm\""), "");
}

}  // namespace
}  // namespace setae::simulation::data_set_test
