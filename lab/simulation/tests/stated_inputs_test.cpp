// SPDX-License-Identifier: GPL-3.0-or-later
// Inputs with standard error in a recipe: drawn once per scope, written into the data, stated in the study by name.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <unistd.h>

#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/channel.hpp"
#include "setae/simulation/data_set.hpp"

namespace setae::simulation::stated_inputs_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* calibrated = R"(
work_of_adhesion = "37 mJ/m2"
shared_tips = true
[calibrations]
height = { stylus = "1 ± 0.02", afm = "1.05 ± 0.02", tem = "1 ± 0.03" }
lateral = { stylus = "1 ± 0.01", afm = "1 ± 0.01", tem = "1 ± 0.01" }
force = "1 ± 0.01"
displacement = "1 ± 0.005"
contact_radius = "1 ± 0.01"
[rough_solid]
youngs_modulus = "1100 GPa"
[protocols.p]
stylus = { lengths = ["20 um"], step = "0.2 um", tip_radius = "5 ± 0.4 um" }
afm = { sizes = ["100 nm"], pixels = 32, tip_radius = "10 ± 1 nm" }
tem = { lengths = ["20 nm"] }
[surfaces.A]
protocol = "p"
spectrum = { model = "self_affine", hurst_exponent = 0.8, rolloff_wavelength = "1 um", short_wavelength = "1 nm", rms_slope = 0.5 }
[surfaces.B]
protocol = "p"
spectrum = { model = "self_affine", hurst_exponent = 0.8, rolloff_wavelength = "1 um", short_wavelength = "1 nm", rms_slope = 0.4 }
[elastomers.E07]
youngs_modulus = "0.7 ± 0.02 MPa"
tell_modulus = true
surface_energy = "25 ± 5 mJ/m2"
batch = "sylgard"
sphere_radius = "1.25 ± 0.0125 mm"
lens = "lens_1"
[elastomers.E10]
youngs_modulus = "1 MPa"
surface_energy = "25 ± 5 mJ/m2"
batch = "sylgard"
sphere_radius = "1.25 ± 0.0125 mm"
lens = "lens_1"
[elastomers.E19]
youngs_modulus = "1.9 MPa"
surface_energy = "24 ± 2 mJ/m2"
sphere_radius = "1.5 to 1.6 mm"
[loops]
force_noise = "0.1 uN"
unmeasured = [{ surface = "B", elastomer = "E10" }]
)";

fs::path scratch(const std::string& name) {
    const fs::path folder =
        fs::path(testing::TempDir()) / ("setae_stated_inputs_" + name + "_" + std::to_string(::getpid()));
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

Recipe recipe_of(const std::string& text, std::optional<std::uint64_t> seed = 3) {
    const std::string path = (scratch("recipe") / "recipe.toml").string();
    bytes::write_whole_file(path, text);
    return read_recipe(path, seed);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

/// The error of a recipe in which `from` reads `to`.
std::string refusal(const std::string& from, const std::string& to) {
    try {
        (void)recipe_of(replaced(calibrated, from, to));
    } catch (const FormatError& error) {
        return error.what();
    }
    return "";
}

/// Deviations from stated values in units of their standard errors, by scope.
std::map<std::string, double> deviations(const Recipe& recipe) {
    std::map<std::string, double> found;
    const auto add = [&](const std::string& scope, const StatedQuantity& q) {
        found[scope] = (q.value - q.stated_value.value) / q.stated_value.standard_error;
    };
    for (const auto& quantity : named_inputs(recipe)) add(quantity.input, quantity);
    add("modulus", recipe.elastomers[0].youngs_modulus);
    add("sphere of E19", recipe.elastomers[2].sphere_radius);
    return found;
}

// Deviations of 200 seeds: mean 0 ± 1/√n, variance 1 ± √((β − 1)/n) with kurtosis β = 3 of normal, 9/5 of uniform
// numbers, and correlations 0 ± 1/√n between any two scopes.
TEST(StatedInputs, AreDrawnIndependentlyOncePerScope) {
    constexpr int seeds = 200;
    std::map<std::string, std::vector<double>> all;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed)
        for (const auto& [scope, deviation] : deviations(recipe_of(calibrated, seed))) all[scope].push_back(deviation);
    ASSERT_EQ(all.size(), 15u);
    constexpr double n = seeds;
    const auto mean_product = [&](const std::vector<double>& a, const std::vector<double>& b) {
        double sum = 0.0;
        for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
        return sum / n;
    };
    const std::vector<double> ones(seeds, 1.0);
    int pairs = 0, far = 0;
    for (auto a = all.begin(); a != all.end(); ++a) {
        const double kurtosis = a->first == "sphere of E19" ? 1.8 : 3.0;
        EXPECT_NEAR(mean_product(a->second, ones), 0.0, 3.0 / std::sqrt(n)) << a->first;
        EXPECT_NEAR(mean_product(a->second, a->second), 1.0, 3.0 * std::sqrt((kurtosis - 1.0) / n)) << a->first;
        for (auto b = std::next(a); b != all.end(); ++b) {
            const double correlation = mean_product(a->second, b->second) * std::sqrt(n);
            EXPECT_LT(std::abs(correlation), 4.0) << a->first << ", " << b->first;
            ++pairs;
            far += std::abs(correlation) > 2.0 ? 1 : 0;
        }
    }
    // one in 22 lies beyond 2 standard errors
    EXPECT_NEAR(far, 0.0455 * pairs, 3.0 * std::sqrt(0.0455 * pairs));
}

TEST(StatedInputs, AreEqualWithinAScope) {
    const Recipe recipe = recipe_of(calibrated);
    const auto &first = recipe.elastomers[0], &second = recipe.elastomers[1], &third = recipe.elastomers[2];
    EXPECT_EQ(first.sphere_radius.value, second.sphere_radius.value);
    EXPECT_EQ(first.surface_energy.value, second.surface_energy.value);
    EXPECT_NE(first.surface_energy.value, 25e-3);
    EXPECT_EQ(third.surface_energy.value, 24e-3);  // of no batch: equal to the stated value
    EXPECT_EQ(second.youngs_modulus.value, 1e6);
    EXPECT_TRUE(third.sphere_radius.value > 1.5e-3 && third.sphere_radius.value < 1.6e-3);
    EXPECT_NE(*recipe.surfaces[0].afm->shared_tip_radius, 10e-9);
    EXPECT_EQ(recipe.surfaces[0].afm->shared_tip_radius, recipe.surfaces[1].afm->shared_tip_radius);
    EXPECT_EQ(recipe.surfaces[0].stylus->shared_tip_radius, recipe.stylus_tip->value);
    EXPECT_FALSE(recipe_of(replaced(calibrated, "shared_tips = true", "")).surfaces[0].afm->shared_tip_radius);
}

TEST(StatedInputs, DoNotDependOnOtherScopes) {
    const auto all = deviations(recipe_of(calibrated));
    auto text = replaced(calibrated, "[elastomers.E07]",
                         "[elastomers.first]\nyoungs_modulus = \"1 MPa\"\nsurface_energy = \"20 ± 2 mJ/m2\"\n"
                         "batch = \"other\"\nsphere_radius = \"1 ± 0.1 mm\"\n[elastomers.E07]");
    text = replaced(text, "force = \"1 ± 0.01\"", "");
    const Recipe more = recipe_of(text);
    for (const auto& quantity : named_inputs(more)) {
        const auto same = all.find(quantity.input);
        if (same == all.end()) continue;
        EXPECT_EQ((quantity.value - quantity.stated_value.value) / quantity.stated_value.standard_error, same->second)
            << quantity.input;
    }
    EXPECT_EQ(more.elastomers[3].sphere_radius.value, recipe_of(calibrated).elastomers[2].sphere_radius.value);
}

/// Two data sets of one recipe; the second is written by instruments without calibration error.
struct Twins {
    Recipe recipe = recipe_of(calibrated);
    fs::path stated = scratch("stated"), exact = scratch("exact");

    Twins() {
        make(recipe, stated.string(), {2});
        Recipe other = recipe;
        other.calibrations = {};
        make(other, exact.string(), {2});
    }
};
const Twins& twins() {
    static const Twins made;
    return made;
}

/// Column of a text table.
Array1D column(const fs::path& file, Index index) {
    std::vector<double> values;
    std::istringstream lines(bytes::read_file(file.string()));
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        std::istringstream cells(line);
        std::string cell;
        for (Index i = 0; i <= index && std::getline(cells, cell, ','); ++i)
            if (i == index && !cell.empty()) values.push_back(std::stod(cell));
    }
    return Eigen::Map<const Array1D>(values.data(), static_cast<Index>(values.size()));
}

// what is written has its last decimal rounded: 5e-5 nm of heights, 5e-6 µN, 5e-5 nm, 5e-6 µm of loops
TEST(Calibrations, DivideTheStatedValuesOfInstruments) {
    const auto& [recipe, stated, exact] = twins();
    const auto& c = recipe.calibrations;
    const auto compare = [&](const char* file, Index index, const StatedQuantity& factor, double rounding) {
        const Array1D found = column(stated / file, index) * factor.value, truth = column(exact / file, index);
        ASSERT_EQ(found.size(), truth.size()) << file;
        EXPECT_GT((column(stated / file, index) - truth).abs().maxCoeff(), 10.0 * rounding) << file << " " << index;
        EXPECT_LT((found - truth).abs().maxCoeff(), 2.2 * rounding) << file << " " << index;
    };
    compare("A/stylus_1.csv", 0, *c.stylus.lateral, 5e-6);
    compare("A/stylus_1.csv", 1, *c.stylus.height, 5e-5);
    compare("B/tem_1.csv", 0, *c.tem.lateral, 5e-6);
    compare("B/tem_1.csv", 1, *c.tem.height, 5e-6);
    compare("loops/A_E07.csv", 1, *c.force, 5e-6);
    compare("loops/A_E07.csv", 2, *c.displacement, 5e-5);
    compare("loops/A_E07.csv", 3, *c.contact_radius, 5e-6);
    const auto map = [](const fs::path& folder) {
        const auto measurement = formats::read((folder / "A/afm_1.txt").string(), 0, {});
        return std::get<topography::HeightMap>(measurement);
    };
    const auto found = map(stated), truth = map(exact);
    EXPECT_NEAR(found.size[0] * c.afm.lateral->value, truth.size[0], 1e-8 * truth.size[0]);
    EXPECT_LT((found.heights * c.afm.height->value - truth.heights).abs().maxCoeff(), 1.1e-13);
    EXPECT_LT(std::abs(c.afm.height->value - 1.05), 0.1);
}

TEST(Calibrations, AreWrittenToTheStudyAndEveryNameIsUsed) {
    const auto study = bytes::read_file((twins().stated / "study.toml").string());
    const auto holds = [&](const std::string& text) { return study.find(text) != std::string::npos; };
    for (const char* line :
         {"[inputs]\n", "\"stylus_height\" = \"1 ± 0.02\"\n", "\"afm_height\" = \"1.05 ± 0.02\"\n",
          "\"tem_lateral\" = \"1 ± 0.01\"\n", "\"afm_tip\" = \"1e-08 ± 1e-09 m\"\n",
          "\"stylus_tip\" = \"5e-06 ± 4e-07 m\"\n", "\"lens_1\" = \"0.00125 ± 1.25e-05 m\"\n",
          "\"surface_energy_sylgard\" = \"0.025 ± 0.005 J/m2\"\n", "\"force_calibration\" = \"1 ± 0.01\"\n",
          "[loops]\nforce_calibration = \"force_calibration\"\ndisplacement_calibration = "
          "\"displacement_calibration\"\ncontact_radius_calibration = \"contact_radius_calibration\"\n",
          "instrument = \"afm\", tip_radius = \"afm_tip\", height_calibration = \"afm_height\", "
          "lateral_calibration = \"afm_lateral\" }",
          "instrument = \"tem\", height_calibration = \"tem_height\", lateral_calibration = \"tem_lateral\" }",
          "youngs_modulus = \"700000 ± 20000 Pa\"\n", "surface_energy = \"surface_energy_sylgard\"\n",
          "surface_energy = \"0.024 ± 0.002 J/m2\"\n", "sphere_radius = \"lens_1\"\n",
          "sphere_radius = \"0.0015 to 0.0016 m\"\n"})
        EXPECT_TRUE(holds(line)) << line << "\n" << study;
    for (const auto& quantity : named_inputs(twins().recipe))
        EXPECT_TRUE(holds(" = \"" + quantity.input + "\"")) << quantity.input;
}

TEST(Calibrations, OfAScaleApplyToHeightsAndLengths) {
    auto text = replaced(calibrated, ", tem = \"1 ± 0.03\" }", " }");
    text = replaced(text, ", tem = \"1 ± 0.01\" }", " }\nscale = { tem = \"1 ± 0.02\" }");
    const Recipe recipe = recipe_of(text);
    EXPECT_EQ(recipe.calibrations.tem.height->value, recipe.calibrations.tem.lateral->value);
    EXPECT_EQ(recipe.calibrations.tem.height->input, "tem_scale");
    EXPECT_NE(recipe.calibrations.tem.height->value, 1.0);
    EXPECT_EQ(named_inputs(recipe).size(), named_inputs(recipe_of(calibrated)).size() - 1);
}

TEST(Calibrations, OfUnusedInstrumentsAreNotWritten) {
    auto text = replaced(calibrated, "tem = { lengths = [\"20 nm\"] }", "");
    text.erase(text.find("[loops]"));
    for (const auto& quantity : named_inputs(recipe_of(text))) {
        EXPECT_EQ(quantity.input.find("tem_"), std::string::npos);
        EXPECT_EQ(quantity.input.find("force"), std::string::npos);
    }
}

// The same data; the study does not name common inputs.
TEST(Calibrations, WithoutNamesAreWrittenAtEveryPlace) {
    const Recipe recipe = recipe_of(std::string("name_inputs = false\n") + calibrated);
    EXPECT_EQ(recipe.calibrations.force->value, twins().recipe.calibrations.force->value);
    EXPECT_EQ(recipe.elastomers[0].sphere_radius.value, twins().recipe.elastomers[0].sphere_radius.value);
    const fs::path folder = scratch("unnamed");
    make(recipe, folder.string(), {2});
    const auto study = bytes::read_file((folder / "study.toml").string());
    EXPECT_EQ(study.find("[inputs]"), std::string::npos);
    for (const char* name : {"afm_", "lens_1", "sylgard", "\"force_calibration\""})
        EXPECT_EQ(study.find(name, study.find("[elastomers")), std::string::npos) << name;
    const auto count = [&](const std::string& text) {
        int found = 0;
        for (auto at = study.find(text); at != std::string::npos; at = study.find(text, at + 1)) ++found;
        return found;
    };
    EXPECT_EQ(count("\nforce_calibration = \"1 ± 0.01\"\n"), 5);
    EXPECT_EQ(count("sphere_radius = \"0.00125 ± 1.25e-05 m\"\n"), 2);
    EXPECT_EQ(count("surface_energy = \"0.025 ± 0.005 J/m2\"\n"), 2);
    EXPECT_EQ(count("height_calibration = \"1.05 ± 0.02\""), 2);
    EXPECT_EQ(count("tip_radius = \"1e-08 ± 1e-09 m\""), 2);
    EXPECT_EQ(bytes::read_file((folder / "loops/A_E07.csv").string()),
              bytes::read_file((twins().stated / "loops/A_E07.csv").string()));
}

TEST(UnmeasuredPairs, AreSimulatedWithoutFilesAndMarked) {
    const auto& [recipe, stated, exact] = twins();
    EXPECT_FALSE(fs::exists(stated / "loops/B_E10.csv"));
    EXPECT_TRUE(fs::exists(stated / "loops/A_E10.csv"));
    const auto loops = known_loops(recipe);
    ASSERT_EQ(loops.size(), 6u);
    EXPECT_FALSE(loops[4].measured);
    EXPECT_GT(loops[4].truth.energy_loss(), 0.0);
    const auto study = bytes::read_file((stated / "study.toml").string());
    const auto elastomer = study.substr(study.find("[elastomers.\"E10\"]"), 200);
    EXPECT_NE(elastomer.find("preload = \"0.001 N\""), std::string::npos) << elastomer;
    EXPECT_EQ(study.find("B_E10"), std::string::npos);
    const auto truth = bytes::read_file((stated / "truth.json").string());
    EXPECT_NE(truth.find("\"measured\": false"), std::string::npos);
    EXPECT_NE(truth.find("\"surface_energy_sylgard\": "), std::string::npos);
}

// What came before calibrations is written as it was, byte by byte: factors of 1 change no record.
TEST(RecipesWithoutStatedInputs, GiveUnchangedFiles) {
    std::string plain = calibrated;
    plain.erase(plain.find("shared_tips"), plain.find("[rough_solid]") - plain.find("shared_tips"));
    plain.erase(plain.find("[elastomers.E07]"), plain.find("[elastomers.E19]") - plain.find("[elastomers.E07]"));
    plain = replaced(plain, "\"1.5 to 1.6 mm\"", "\"1.5 mm\"");
    plain.erase(plain.find("unmeasured"));
    const fs::path before = scratch("before"), ones = scratch("ones");
    const auto files = make(recipe_of(plain), before.string(), {2});
    EXPECT_EQ(bytes::read_file((before / "study.toml").string()),
              "# Written by `setae lab make`; truth.json contains the true values.\n"
              "title = \"\"\n"
              "\n[analysis]\nshortest_wavelength = \"1e-09 m\"\n"
              "\n[rough_solid]\nyoungs_modulus = \"1100000000000 Pa\"\npoisson_ratio = 0\n"
              "\n[surfaces.\"A\"]\nmeasurements = [\n"
              "  { file = \"A/stylus_1.csv\", instrument = \"stylus\", tip_radius = \"5e-06 ± 4e-07 m\" },\n"
              "  { file = \"A/afm_1.txt\", instrument = \"afm\", tip_radius = \"1e-08 ± 1e-09 m\" },\n"
              "  { file = \"A/tem_1.csv\", instrument = \"tem\" },\n]\n"
              "\n[surfaces.\"B\"]\nmeasurements = [\n"
              "  { file = \"B/stylus_1.csv\", instrument = \"stylus\", tip_radius = \"5e-06 ± 4e-07 m\" },\n"
              "  { file = \"B/afm_1.txt\", instrument = \"afm\", tip_radius = \"1e-08 ± 1e-09 m\" },\n"
              "  { file = \"B/tem_1.csv\", instrument = \"tem\" },\n]\n"
              "\n[elastomers.\"E19\"]\npoisson_ratio = 0.5\nsurface_energy = \"0.024 ± 0.002 J/m2\"\n"
              "sphere_radius = \"0.0015 m\"\n"
              "\n[[experiments]]\nfile = \"loops/A_E19.csv\"\nelastomer = \"E19\"\nsurface = \"A\"\n"
              "\n[[experiments]]\nfile = \"loops/B_E19.csv\"\nelastomer = \"E19\"\nsurface = \"B\"\n");
    EXPECT_EQ(bytes::read_file((before / "truth.json").string()).find("inputs"), std::string::npos);
    make(recipe_of(replaced(plain, "[rough_solid]",
                            "[calibrations]\nheight = { stylus = 1, afm = 1, tem = \"1\" }\nforce = 1\n"
                            "[rough_solid]")),
         ones.string(), {2});
    for (const auto& file : files) {
        if (file == "truth.json" || file == "study.toml") continue;
        EXPECT_EQ(bytes::read_file((before / file).string()), bytes::read_file((ones / file).string())) << file;
    }
}

TEST(StatedInputs, AreRefusedWhereContradictory) {
    const auto expect = [](const std::string& from, const std::string& to, const std::vector<std::string>& words) {
        const auto message = refusal(from, to);
        for (const auto& word : words) EXPECT_NE(message.find(word), std::string::npos) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    };
    expect("force = \"1 ± 0.01\"", "force = \"1 ± -0.01\"", {"calibrations.force", "uncertainty >= 0"});
    expect("force = \"1 ± 0.01\"", "force = \"1 ± 0.01 N\"", {"calibrations.force", "N"});
    expect("force = \"1 ± 0.01\"", "force = -1", {"calibrations.force", "above 0"});
    expect("force = \"1 ± 0.01\"", "force = \"1 ± 1.5\"", {"calibrations.force", "larger than the value"});
    expect("afm = \"1.05 ± 0.02\"", "amf = \"1.05 ± 0.02\"",
           {"calibrations.height.amf", "expected stylus, afm or tem"});
    expect("force = \"1 ± 0.01\"", "scale = { afm = 1.01 }", {"calibrations.height.afm", "has a scale, too"});
    expect("lateral = {", "laterals = {", {"unknown key 'laterals'", "'lateral'"});
    expect("surface_energy = \"25 ± 5 mJ/m2\"", "surface_energy = \"26 ± 5 mJ/m2\"",
           {"elastomers.E10.surface_energy", "surface_energy_sylgard", "0.026 ± 0.005", "elastomers.E07"});
    expect("sphere_radius = \"1.25 ± 0.0125 mm\"", "sphere_radius = \"1.25 mm\"",
           {"elastomers.E10.sphere_radius", "lens_1", "another name"});
    expect("lens = \"lens_1\"", "lens = \"force_calibration\"", {"elastomers.E07.sphere_radius", "calibrations.force"});
    expect("lens = \"lens_1\"", "lens = \"\"", {"lens", "expected a name"});
    expect("tell_modulus = true", "", {"elastomers.E07.youngs_modulus", "tell_modulus"});
    expect("surface = \"B\", elastomer = \"E10\"", "surface = \"Z\", elastomer = \"E10\"", {"unmeasured", "'Z'"});
    expect("surface = \"B\", elastomer = \"E10\"", "surface = \"B\", elastomer = \"E99\"", {"unmeasured", "'E99'"});
    expect("[{ surface = \"B\", elastomer = \"E10\" }]",
           "[{ surface = \"A\", elastomer = \"E10\" }, { surface = \"B\", elastomer = \"E10\" }]",
           {"no loop on 'E10'", "tell_modulus"});
}

TEST(SharedTips, AreRefusedForProtocolsWithDifferentRadii) {
    auto text = replaced(calibrated, "[surfaces.A]\nprotocol = \"p\"",
                         "[protocols.q]\nafm = { sizes = [\"100 nm\"], tip_radius = \"8 ± 1 nm\" }\n"
                         "[surfaces.A]\nprotocol = \"q\"");
    try {
        (void)recipe_of(text);
        FAIL();
    } catch (const FormatError& error) {
        const std::string message = error.what();
        for (const char* word : {"shared_tips", "afm_tip", "surfaces.A", "8e-09 ± 1e-09", "1e-08 ± 1e-09"})
            EXPECT_NE(message.find(word), std::string::npos) << message;
    }
}

}  // namespace
}  // namespace setae::simulation::stated_inputs_test
