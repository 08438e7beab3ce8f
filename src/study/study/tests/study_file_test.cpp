// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>

#include <unistd.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/study/study.hpp"
#include "setae/study/study_keys.hpp"

namespace setae::study::study_file_test {
namespace {

class StudyFile : public testing::Test {
protected:
    void SetUp() override { std::filesystem::create_directories(folder_); }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    Study read(const std::string& text) {
        std::ofstream(path_) << text;
        return read_study(path_);
    }
    std::string message_of(const std::string& text) {
        try {
            (void)read(text);
        } catch (const FormatError& error) {
            return std::string(error.what()).substr(folder_.string().size() + 1);
        }
        return "no error";
    }

    std::filesystem::path folder_ =
        std::filesystem::temp_directory_path() / ("setae_study_" + std::to_string(::getpid()));
    std::string path_ = (folder_ / "study.toml").string();
};

constexpr const char* surface = "[surfaces.A]\nmeasurements = [{ file = \"a.txt\", unit = \"um\" }]\n";

TEST_F(StudyFile, ConvertsEveryQuantityToSi) {
    const auto study = read(
        std::string(
            "work_of_adhesion = \"37.0 ± 3.7 mJ/m2\"\n[analysis]\nlongest_wavelength = \"100 um\"\ncutoff_scan = [\"4 A\"]\n") +
        "[rough_solid]\nyoungs_modulus = \"1100 GPa\"\npoisson_ratio = 0.06\n" + surface +
        "[elastomers.soft]\nyoungs_modulus = \"0.69 +- 0.02 MPa\"\nsurface_energy = \"25 mJ/m2\"\nsurface_energy_law = { area_ratio = [1.0, "
        "1.5], surface_energy = [\"25 mJ/m2\", \"30 mJ/m2\"] }\n");
    EXPECT_DOUBLE_EQ(study.work_of_adhesion->value, 0.037);
    EXPECT_DOUBLE_EQ(study.work_of_adhesion->standard_error, 0.0037);
    EXPECT_DOUBLE_EQ(study.analysis.longest_wavelength->value, 1e-4);
    EXPECT_DOUBLE_EQ(study.analysis.cutoff_scan.at(0), 4e-10);
    EXPECT_DOUBLE_EQ(study.counter_youngs_modulus, 1.1e12);
    EXPECT_DOUBLE_EQ(study.elastomers.at(0).youngs_modulus.standard_error, 2e4);
    EXPECT_DOUBLE_EQ(study.elastomers.at(0).surface_energy_law->law.at(1.25), 0.0275);
    EXPECT_EQ(study.surfaces.at(0).measurements.at(0).file, (folder_ / "a.txt").string());
}

TEST_F(StudyFile, RefusesImpossibleQuantities) {
    const auto elastomer = [&](const std::string& keys) { return message_of("[elastomers.soft]\n" + keys + "\n"); };
    EXPECT_EQ(elastomer("surface_energy = \"25 mJ/m2\"\nsphere_radius = \"1e-300 m\"").substr(0, 12), "study.toml:3");
    EXPECT_EQ(elastomer("surface_energy = \"1e160 J/m2\"").substr(0, 12), "study.toml:2");
    EXPECT_EQ(elastomer("surface_energy = \"25 mJ/m2\"\nsphere_radius = \"1e-30 m\""),
              "study.toml:3: elastomers.soft.sphere_radius: 1.00×10⁻¹⁸ pm, expected 0, or 1.00 nm to 1.00 m");
}

TEST_F(StudyFile, RefusesAMeasurementAsItsOwnReference) {
    std::ofstream(folder_ / "a.txt") << "0 1\n";
    std::filesystem::create_symlink("a.txt", folder_ / "link.txt");
    for (const char* reference : {"a.txt", "./a.txt", "link.txt"})
        EXPECT_NE(message_of(std::string("[surfaces.A]\nmeasurements = [{ file = \"a.txt\", references = [\"") +
                             reference + "\"] }]\n")
                      .find("is the measurement itself"),
                  std::string::npos)
            << reference;
}

TEST_F(StudyFile, RefusesZeroBytesInNames) {
    EXPECT_NE(message_of("[surfaces.\"A\\u0000B\"]\nmeasurements = [{ file = \"a.txt\" }]\n").find("study.toml:1"),
              std::string::npos);
    EXPECT_NE(message_of("[surfaces.A]\nmeasurements = [{ file = \"a\\u0000.txt\" }]\n").find("zero byte"),
              std::string::npos);
}

TEST_F(StudyFile, ReadsTimeDependenceOfAnElastomer) {
    const std::string head = std::string("[rough_solid]\nyoungs_modulus = \"1100 GPa\"\npoisson_ratio = 0.06\n") +
                             surface + "[elastomers.soft]\nsurface_energy = \"25 mJ/m2\"\n";
    const auto study =
        read(head +
             "speed = \"60 nm/s\"\nhold_time = \"30 s\"\n"
             "crack_speed = { reference_speed = \"1.0 ± 0.1 um/s\", exponent = \"0.60 ± 0.02\" }\n"
             "relaxation = [{ share = \"0.10 ± 0.01\", time = \"20 s\" }, { share = 0.05, time = \"1 min\" }]\n");
    const auto& soft = study.elastomers.at(0);
    EXPECT_DOUBLE_EQ(*soft.speed, 60e-9);
    EXPECT_DOUBLE_EQ(*soft.hold_time, 30.0);
    EXPECT_DOUBLE_EQ(soft.crack_speed->reference_speed.standard_error, 1e-7);
    EXPECT_DOUBLE_EQ(soft.crack_speed->exponent.value, 0.6);
    ASSERT_EQ(soft.relaxation.size(), 2u);
    EXPECT_DOUBLE_EQ(soft.relaxation[0].share.standard_error, 0.01);
    EXPECT_DOUBLE_EQ(soft.relaxation[1].time.value, 60.0);
    EXPECT_EQ(message_of(head + "crack_speed = { exponent = 0.6 }\n").find("study.toml:"), 0u);
    EXPECT_NE(message_of(head + "crack_speed = { exponent = 0.6 }\n").find("reference_speed"), std::string::npos);
    EXPECT_NE(message_of(head + "relaxation = [{ share = -0.1, time = \"1 s\" }]\n").find("share"), std::string::npos);
    EXPECT_NE(message_of(head + "relaxation = [{ share = 0.1, tme = \"1 s\" }]\n").find("time"), std::string::npos);
}

TEST_F(StudyFile, LeavesTheSpectrumMethodOpenUnlessGiven) {
    EXPECT_FALSE(read(surface).analysis.spectrum);
    EXPECT_EQ(read(std::string("[analysis]\nspectrum = \"average\"\n") + surface).analysis.spectrum,
              SpectrumMethod::average);
    EXPECT_EQ(read(std::string("[analysis]\nspectrum = \"likelihood\"\n") + surface).analysis.spectrum,
              SpectrumMethod::likelihood);
    EXPECT_NE(message_of(std::string("[analysis]\nspectrum = \"best\"\n") + surface).find("analysis.spectrum"),
              std::string::npos);
}

TEST_F(StudyFile, NamesTheNearestKeyAndItsLine) {
    EXPECT_EQ(message_of("[analysis]\nlongest_wavelenght = \"1 um\"\n"),
              "study.toml:2: unknown key 'longest_wavelenght' in analysis; did you mean 'longest_wavelength'?");
}

TEST_F(StudyFile, ReadsProbeAndDirectionOfEachFile) {
    const auto study = read(
        "[surfaces.A]\nmeasurements = [\n"
        "{ file = \"a.txt\", instrument = \"stylus\", direction = \"y\", tip_radius = \"2 um\", "
        "tip_shape = \"cone\", tip_half_angle = \"30 deg\" },\n"
        "{ file = \"b.txt\", instrument = \"afm\", direction = \"45 deg\", tip_file = \"tip.txt\" },\n"
        "{ file = \"c.txt\", instrument = \"tem\", foil_thickness = \"20 ± 5 nm\" },\n"
        "{ file = \"d.txt\", instrument = \"optical\", numerical_aperture = 0.55, "
        "light_wavelength = \"520 nm\" }]\n");
    const auto& all = study.surfaces.at(0).measurements;
    EXPECT_DOUBLE_EQ(all[0].direction, 0.5 * pi);
    EXPECT_EQ(all[0].tip_shape, "cone");
    EXPECT_DOUBLE_EQ(*all[0].tip_half_angle, pi / 6.0);
    EXPECT_DOUBLE_EQ(all[1].direction, 0.25 * pi);
    EXPECT_EQ(*all[1].tip_file, (folder_ / "tip.txt").string());
    EXPECT_DOUBLE_EQ(all[2].foil_thickness->standard_error, 5e-9);
    EXPECT_DOUBLE_EQ(*all[3].numerical_aperture, 0.55);
    EXPECT_DOUBLE_EQ(*all[3].light_wavelength, 520e-9);
}

TEST_F(StudyFile, RefusesUnknownDirectionsAndShapes) {
    const auto message = [&](const std::string& key) {
        return message_of("[surfaces.A]\nmeasurements = [{ file = \"a.txt\", instrument = \"afm\", " + key + " }]\n");
    };
    EXPECT_EQ(message("direction = \"north\"").find("study.toml:2"), 0U) << message("direction = \"north\"");
    EXPECT_EQ(message("tip_shape = \"pyramid\"").find("study.toml:2"), 0U) << message("tip_shape = \"pyramid\"");
    EXPECT_NE(message("tip_half_angle = \"1 nm\""), "no error");
    EXPECT_NE(message("foil_thickness = \"20\""), "no error");
}

TEST_F(StudyFile, RefusesANumberWithoutUnit) {
    EXPECT_NE(message_of(std::string(surface) + "[elastomers.s]\nsurface_energy = 25\n")
                  .find("study.toml:4: elastomers.s.surface_energy: a number without unit"),
              std::string::npos);
    EXPECT_NE(
        message_of(std::string(surface) + "[elastomers.s]\nsurface_energy = \"25 nm\"\n").find("expected one of J/m2"),
        std::string::npos);
}

TEST_F(StudyFile, RefusesNamesThatAreNotDeclared) {
    EXPECT_NE(
        message_of(
            std::string("[rough_solid]\nyoungs_modulus = \"1 GPa\"\npoisson_ratio = 0.3\n") + surface +
            "[elastomers.s]\nsurface_energy = \"25 mJ/m2\"\n[[experiments]]\nfile = \"l.csv\"\nsurface = \"B\"\nelastomer = \"s\"\n")
            .find("surface 'B', which is not declared"),
        std::string::npos);
}

TEST_F(StudyFile, RequiresOneSourceOfRoughnessPerSurface) {
    EXPECT_NE(message_of("[surfaces.A]\n").find("has 0 sources of roughness"), std::string::npos);
}

TEST_F(StudyFile, RequiresOnePublishedValuePerElastomer) {
    const std::string head = std::string("[rough_solid]\nyoungs_modulus = \"1 GPa\"\npoisson_ratio = 0.3\n") + surface +
                             "[elastomers.s]\nsurface_energy = \"25 mJ/m2\"\n";
    EXPECT_NE(
        message_of(head + "[published]\nelastomers = [\"s\"]\n[published.approach]\nA = [\"1 mJ/m2\", \"2 mJ/m2\"]\n")
            .find("2 values, expected 1"),
        std::string::npos);
    EXPECT_NE(message_of(head + "[published]\nelastomers = [\"s\"]\n[published.approach]\nB = [\"1 mJ/m2\"]\n")
                  .find("surface 'B' is not declared"),
              std::string::npos);
}

TEST_F(StudyFile, ReportsInvalidTomlWithItsLine) {
    EXPECT_EQ(message_of("title = \"a\"\nb = = 1\n").substr(0, 13), "study.toml:2:");
}

TEST_F(StudyFile, ReadsReplicateLabelsAndReasonsForExclusion) {
    const std::string head = std::string("[rough_solid]\nyoungs_modulus = \"1100 GPa\"\npoisson_ratio = 0.06\n") +
                             surface + "[elastomers.soft]\nyoungs_modulus = \"1 MPa\"\nsurface_energy = \"25 mJ/m2\"\n";
    const auto loop = [](const std::string& file, const std::string& more) {
        return "[[experiments]]\nfile = \"" + file + "\"\nsurface = \"A\"\nelastomer = \"soft\"\n" + more;
    };
    const auto study = read(head + loop("1.csv", "lens = \"a\"\nspot = \"1\"\n") +
                            loop("2.csv", "lens = \"b\"\nspot = \"1\"\nexclude = \"dust\"\n"));
    EXPECT_EQ(study.experiments.at(0).lens, "a");
    EXPECT_EQ(study.experiments.at(1).spot, "1");
    EXPECT_FALSE(study.experiments.at(0).excluded());
    EXPECT_EQ(study.experiments.at(1).exclusion, "dust");
    EXPECT_NE(message_of(head + loop("1.csv", "exclude = \" \"\n")).find("an exclusion without a reason"),
              std::string::npos);
    EXPECT_NE(message_of(head + loop("1.csv", "lens = \"a\"\n") + loop("2.csv", "")).find("2.csv names no lens"),
              std::string::npos);
}

TEST_F(StudyFile, LoopOptionsOverrideCommonOptions) {
    const std::string head = std::string("[rough_solid]\nyoungs_modulus = \"1100 GPa\"\npoisson_ratio = 0.06\n") +
                             "[elastomers.soft]\nsurface_energy = \"25 mJ/m2\"\n[loops]\nmodels = [\"jkr\"]\nprofile = "
                             "true\nexponent = 0.5\nshare = [\"work\"]\n";
    const auto loop = [](const std::string& file, const std::string& more) {
        return "[[experiments]]\nfile = \"" + file + "\"\nrole = \"reference\"\nelastomer = \"soft\"\n" + more;
    };
    const auto study = read(head + loop("1.csv", "crack_speed = true\n") +
                            loop("2.csv", "models = []\nprofile = false\nexponent = 0.3\nshare = []\n"));
    const auto &as_all = study.experiments.at(0).models, &own = study.experiments.at(1).models;
    EXPECT_EQ(as_all.models, std::vector<std::string>{"jkr"});
    EXPECT_TRUE(as_all.profile && as_all.crack_speed && as_all.share_work_of_adhesion);
    EXPECT_EQ(as_all.exponent, 0.5);
    EXPECT_FALSE(own.any() || own.shared());
    EXPECT_EQ(own.exponent, 0.3);
    EXPECT_NE(message_of(head + loop("1.csv", "") + loop("2.csv", "share = [\"modulus\"]\n"))
                  .find("share: expected the share, models and fit_errors of " + (folder_ / "1.csv").string() +
                        " on the same elastomer"),
              std::string::npos);
}

TEST(StudyKeys, StateTheDefaultsOfTheProgram) {
    std::map<std::string, KeyDescription> keys;
    for (const auto& table : study_keys())
        for (const auto& key : table.keys)
            EXPECT_TRUE(keys.emplace(table.name + " " + key.key, key).second) << table.name << " " << key.key;
    EXPECT_EQ(keys.at("[loops] samples_dropped").standard, std::to_string(loops::AnalysisOptions{}.samples_dropped));
    EXPECT_EQ(keys.at("[loops] fit_errors").standard, "`orthogonal_distance`");
    EXPECT_EQ(keys.at("[analysis] conversion").standard, "`exact`");
    EXPECT_EQ(keys.at("[elastomers.NAME] surface_energy").standard, "required");
    EXPECT_EQ(keys.at("[elastomers.NAME] surface_energy").unit, "J/m2");
    EXPECT_EQ(keys.at("[[experiments]] camera").type, "table");
}

TEST_F(StudyFile, FindsMappingsByFileAndByName) {
    std::filesystem::create_directories(folder_ / "mappings");
    std::ofstream(folder_ / "mappings" / "rig.toml") << "";
    const auto mapping_of = [&](const std::string& name) {
        std::ofstream(path_) << surface << "[rough_solid]\nyoungs_modulus = \"1 TPa\"\npoisson_ratio = 0.1\n"
                             << "[elastomers.soft]\nsurface_energy = \"25 mJ/m2\"\n[[experiments]]\nfile = \"l.csv\"\n"
                             << "surface = \"A\"\nelastomer = \"soft\"\nmapping = \"" << name << "\"\n";
        return *read_study(path_, (folder_ / "mappings").string()).experiments.at(0).mapping;
    };
    EXPECT_EQ(mapping_of("rig"), (folder_ / "mappings" / "rig.toml").string());
    EXPECT_EQ(mapping_of("own.toml"), (folder_ / "own.toml").string());
    try {
        (void)mapping_of("rog");
        FAIL();
    } catch (const FormatError& error) {
        EXPECT_NE(std::string(error.what()).find("did you mean 'rig'?"), std::string::npos) << error.what();
    }
    std::ofstream(folder_ / "rig") << "";  // a file of that name beside the study comes first
    EXPECT_EQ(mapping_of("rig"), (folder_ / "rig").string());
}

TEST_F(StudyFile, ReadsChosenColumnsOfAllLoopsAndOfOne) {
    const std::string text =
        std::string(surface) + "[rough_solid]\nyoungs_modulus = \"1 TPa\"\npoisson_ratio = 0.1\n" +
        "[elastomers.soft]\nsurface_energy = \"25 mJ/m2\"\n[loops]\ncolumns = { force = \"-1 * load\" }\n" +
        "[[experiments]]\nfile = \"l.csv\"\nsurface = \"A\"\nelastomer = \"soft\"\n" +
        "[[experiments]]\nfile = \"m.csv\"\nsurface = \"A\"\nelastomer = \"soft\"\ncolumns = { displacement = \"2\" }\n";
    const auto study = read(text);
    EXPECT_EQ(study.experiments.at(0).columns, (tables::ChosenColumns{{"force", "-1 * load"}}));
    EXPECT_EQ(study.experiments.at(1).columns, (tables::ChosenColumns{{"displacement", "2"}}));
    auto misspelt = text;
    misspelt.replace(misspelt.find("displacement = \"2\""), 12, "displacment");
    EXPECT_NE(message_of(misspelt).find("displacement"), std::string::npos) << message_of(misspelt);
}

}  // namespace
}  // namespace setae::study::study_file_test
