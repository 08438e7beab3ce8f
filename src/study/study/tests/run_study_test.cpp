// SPDX-License-Identifier: GPL-3.0-or-later
// The whole chain on files made here: roughness with a known spectrum, loops with known work of adhesion and loss.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <random>

#include <unistd.h>

#include "loop_files.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/output/json.hpp"
#include "setae/output/study_tables.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::study::run_study_test {
namespace {

namespace jkr = contact::jkr;
using loop_files::contact_modulus;
using loop_files::loop;
using loop_files::sphere_radius;

/// ∮F dδ of such a loop in closed form: the work to and fro is the change of elastic minus surface energy of each
/// branch.
double loss(double work_in, double work_out, double depth) {
    const jkr::Contact in{sphere_radius, contact_modulus, work_in}, out{sphere_radius, contact_modulus, work_out};
    const auto energy = [](const jkr::Contact& c, double d) {
        return jkr::total_energy(jkr::contact_radius_at_displacement(d, c, jkr::Branch::outer), d, c);
    };
    const auto pull_off = jkr::pull_off_at_fixed_grips(out);
    const double pressed = energy(in, depth) - energy(in, 0.0);
    const double released = energy(out, depth) - jkr::total_energy(pull_off.contact_radius, pull_off.displacement, out);
    return pressed - released;
}

class StudyOfFiles : public testing::Test {
protected:
    void SetUp() override {
        std::filesystem::create_directories(folder_);
        write_scan("a.csv", 20e-9);
        write_scan("b.csv", 60e-9);
        for (int i = 0; i < 4; ++i)
            tables::write_csv((folder_ / ("loop" + std::to_string(i) + ".csv")).string(),
                              loop(0.03 + 0.004 * i, 0.06 + 0.01 * i, 20e-6));
        tables::write_csv((folder_ / "smooth_before.csv").string(), loop(0.040, 0.0405, 20e-6));
        tables::write_csv((folder_ / "smooth_after.csv").string(), loop(0.041, 0.0415, 20e-6));
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    /// A line of 200 µm with one cosine of 5 µm wavelength.
    void write_scan(const std::string& name, double amplitude) {
        const Array1D x = Array1D::LinSpaced(2000, 0.0, 199.9e-6);
        tables::write_csv((folder_ / name).string(),
                          {{{"x", "m", x}, {"h", "m", amplitude * (2.0 * pi * x / 5e-6).cos()}}, {}});
    }

    StudyResult run(const std::string& experiments, int threads = 2) {
        return run_text(std::string(beginning) + experiments, threads);
    }

    StudyResult run_text(const std::string& text, int threads = 2) {
        const auto path = (folder_ / "study.toml").string();
        std::ofstream(path) << text;
        return run_study(read_study(path), {threads});
    }

    static constexpr const char* beginning =
        "[rough_solid]\nyoungs_modulus = \"1e9 GPa\"\npoisson_ratio = 0.0\n"
        "[analysis]\nwindow = \"none\"\nbootstrap_resamples = 0\n"
        "[surfaces.A]\nmeasurements = [{ file = \"a.csv\", instrument = \"stylus\", trend = \"mean\" }]\n"
        "[surfaces.B]\nmeasurements = [{ file = \"b.csv\", instrument = \"stylus\", trend = \"mean\" }]\n"
        "[elastomers.soft]\nsurface_energy = \"25 mJ/m2\"\nsphere_radius = \"1 mm\"\n"
        "[elastomers.other]\nyoungs_modulus = \"0.75 MPa\"\nsurface_energy = \"25 mJ/m2\"\nsphere_radius = \"1 mm\"\n";

    static constexpr const char* rough_loops =
        "[[experiments]]\nfile = \"loop0.csv\"\nsurface = \"A\"\nelastomer = \"soft\"\n"
        "[[experiments]]\nfile = \"loop1.csv\"\nsurface = \"B\"\nelastomer = \"soft\"\n"
        "[[experiments]]\nfile = \"loop2.csv\"\nsurface = \"A\"\nelastomer = \"other\"\n"
        "[[experiments]]\nfile = \"loop3.csv\"\nsurface = \"B\"\nelastomer = \"other\"\n";

    std::filesystem::path folder_ =
        std::filesystem::temp_directory_path() / ("setae_chain_" + std::to_string(::getpid()));
};

TEST_F(StudyOfFiles, RecoversTheTrueRoughness) {
    const auto result = run(rough_loops);
    const double q = 2.0 * pi / 5e-6;
    for (const auto& [name, amplitude] : {std::pair{"A", 20e-9}, {"B", 60e-9}}) {
        const auto& surface = result.surface(name);
        ASSERT_EQ(surface.error, "");
        EXPECT_NEAR(surface.average.parameters.rms_height / (amplitude / std::sqrt(2.0)), 1.0, 1e-6) << name;
        // taken for isotropic, a line of one wave has U_el/(A E*) = (1/8) ∫ q C1D dq = π q A²/16
        EXPECT_NEAR(surface.average.parameters.elastic_energy_per_modulus / (pi * q * amplitude * amplitude / 16.0),
                    1.0, 1e-6)
            << name;
    }
}

TEST_F(StudyOfFiles, PropagatesTheUncertaintyOfEachTip) {
    // one measured walk with a tip known exactly and once more with an uncertain one
    std::mt19937_64 random(4);
    std::normal_distribution<double> step(0.0, 2e-9);
    const Array1D x = Array1D::LinSpaced(2000, 0.0, 199.9e-6);
    Array1D h = Array1D::Zero(2000);
    for (Index i = 1; i < 2000; ++i) h[i] = h[i - 1] + step(random);
    tables::write_csv((folder_ / "walk.csv").string(), {{{"x", "m", x}, {"h", "m", h}}, {}});
    SurfaceInput input;
    input.name = "walk";
    for (const double error : {0.0, 1e-6}) {
        MeasurementInput measurement;
        measurement.file = (folder_ / "walk.csv").string();
        measurement.tip_radius = Estimate{5e-6, error};
        input.measurements.push_back(measurement);
    }
    const auto surface = analyse_surface(input, {.spectrum = SpectrumMethod::average}, {1});
    ASSERT_EQ(surface.error, "");
    EXPECT_FALSE(surface.measurements[0].bands_of_uncertain_tip);
    ASSERT_TRUE(surface.measurements[1].bands_of_uncertain_tip);
    const auto& [blunter, sharper] = *surface.measurements[1].bands_of_uncertain_tip;
    EXPECT_LT(blunter.upper, surface.measurements[1].spectrum.band.upper);
    EXPECT_GT(sharper.upper, surface.measurements[1].spectrum.band.upper);
    ASSERT_EQ(surface.average.spread.sources.size(), 1u);
    EXPECT_GT(surface.average.spread.sources[0].minus.rms_slope, surface.average.spread.sources[0].plus.rms_slope);
}

TEST_F(StudyOfFiles, RecoversTheWorkAlongTheRetraction) {
    const auto result = run(rough_loops);
    int loops = 0;
    for (const auto& pair : result.pairs) {
        const auto& along = pair.work_along_retraction;
        ASSERT_TRUE(along) << along.reason;
        loops += along->loops;
        const double work_out = pair.retraction->value, across = 1e-4;  // m, about the largest contact radius
        EXPECT_NEAR(along->slope.value * across / work_out, 0.0, 0.02) << pair.surface << pair.elastomer;
        EXPECT_NEAR(along->at_pull_off.value / work_out, 1.0, 0.01);
        EXPECT_NEAR(along->energy_recorded.value / pair.loss->value, 1.0, 1e-12);
    }
    EXPECT_EQ(loops, 4);
}

TEST_F(StudyOfFiles, RecoversTheTrueWorkAndLoss) {
    const auto result = run(rough_loops);
    int checked = 0;
    for (const auto& pair : result.pairs) {
        const int i = (pair.elastomer == "other" ? 2 : 0) + (pair.surface == "B" ? 1 : 0);
        ASSERT_TRUE(pair.approach && pair.retraction && pair.loss) << pair.surface << pair.elastomer;
        EXPECT_NEAR(pair.approach->value, 0.03 + 0.004 * i, 2e-5);
        EXPECT_NEAR(pair.retraction->value, 0.06 + 0.01 * i, 2e-3);
        EXPECT_NEAR(pair.loss->value / loss(0.03 + 0.004 * i, 0.06 + 0.01 * i, 20e-6), 1.0, 0.01);
        ++checked;
    }
    EXPECT_EQ(checked, 4);
    EXPECT_NEAR(result.elastomer("soft").youngs_modulus.value, 0.75e6, 1e3);
    EXPECT_TRUE(result.elastomer("soft").modulus_from_loops);
}

TEST_F(StudyOfFiles, FitsTheLossOfAllPairsAgainstTrueArea) {
    const auto result = run(rough_loops);
    ASSERT_TRUE(result.loop) << result.loop.reason;
    double products = 0.0, squares = 0.0;
    for (const auto& pair : result.pairs) {
        const double area = result.surface(pair.surface).area_ratio() * *pair.contact_area;
        products += area * pair.loss->value;
        squares += area * area;
    }
    EXPECT_NEAR(result.loop->through_origin.work_of_adhesion.value / (products / squares), 1.0, 1e-9);
    ASSERT_TRUE(result.loop->through_origin_without_ideal_loss);
    EXPECT_LT(result.loop->through_origin_without_ideal_loss->work_of_adhesion.value,
              result.loop->through_origin.work_of_adhesion.value);
    EXPECT_TRUE(result.loop->with_intercept);
}

TEST_F(StudyOfFiles, PredictionsMatchTheBalancesOfItsFits) {
    // the balances as lines in W_int, which the fits use, against the balances themselves, which the predictions use
    const auto result = run(rough_loops);
    for (const auto& [fit, predicted] : {std::pair{&result.modified, &PairResult::modified},
                                         {&result.persson_tosatti, &PairResult::persson_tosatti},
                                         {&result.without_area_change, &PairResult::without_area_change}})
        for (const auto& point : (*fit)->pairs)
            for (const auto& pair : result.pairs) {
                if (pair.surface != point.surface || pair.elastomer != point.elastomer) continue;
                EXPECT_NEAR((pair.*predicted)->work.floored, point.prediction(result.work_of_adhesion->value), 1e-15);
            }
}

TEST_F(StudyOfFiles, ComparesWithReferencesBeforeAndAfter) {
    const auto result = run(
        std::string(rough_loops) +
        "[[experiments]]\nfile = \"smooth_before.csv\"\nrole = \"reference\"\nstage = \"before\"\nelastomer = \"soft\"\n"
        "[[experiments]]\nfile = \"smooth_after.csv\"\nrole = \"reference\"\nstage = \"after\"\nelastomer = \"soft\"\n");
    ASSERT_EQ(result.references.size(), 2u);
    EXPECT_NEAR(result.references[0].approach.value, 0.040, 2e-5);
    EXPECT_NEAR(result.references[0].excess_energy->value / loss(0.040, 0.0405, 20e-6), 1.0, 0.02);
    EXPECT_GT(*result.references[0].loss_ratio, 1.0);
    ASSERT_EQ(result.reference_drifts.size(), 1u);
    EXPECT_NEAR(result.reference_drifts[0].change.work_of_adhesion_loading.value, 0.001, 4e-5);
}

TEST_F(StudyOfFiles, NamesAnIncompleteReference) {
    auto pressed = loop(0.040, 0.0405, 20e-6);
    for (auto& column : pressed.columns) column.values = Array1D(column.values.head(column.values.size() / 2 - 200));
    tables::write_csv((folder_ / "pressed.csv").string(), pressed);
    const auto result = run(std::string(rough_loops) +
                            "[[experiments]]\nfile = \"pressed.csv\"\nrole = \"reference\"\nstage = \"before\"\n"
                            "elastomer = \"soft\"\n");
    EXPECT_TRUE(result.references.empty());
    const auto& alerts = result.experiments.back().alerts;
    EXPECT_TRUE(
        std::any_of(alerts.begin(), alerts.end(), [](const Alert& a) { return a.code == "REFERENCE_INCOMPLETE"; }));
}

// A power law given to 1e8 1/m; the surface goes on to 4 Å. The table names no units.
TEST_F(StudyOfFiles, ReportsMissingMetadataOfAGivenSpectrum) {
    std::ofstream table(folder_ / "psd.csv");
    table << "q,C1D\n";
    for (int i = 0; i <= 30; ++i)
        table << std::pow(10.0, 5.0 + 0.1 * i) << "," << 1e-8 * std::pow(10.0, -2.6 * (5.0 + 0.1 * i)) << "\n";
    table.close();
    const auto path = (folder_ / "given.toml").string();
    std::ofstream(path) << "[surfaces.G]\npower_spectrum = \"psd.csv\"\n";
    const auto surface = run_study(read_study(path), {2}).surface("G");
    ASSERT_EQ(surface.error, "");
    EXPECT_TRUE(std::any_of(surface.alerts.begin(), surface.alerts.end(),
                            [](const Alert& a) { return a.code == "UNIT_GUESSED"; }));
}

// C1D = C0 (q/q0)^-3 from q0 on is C_iso = 4 C0 q0^3 q^-4, of which h_rms² = C0 q0/π, exactly.
TEST_F(StudyOfFiles, GivenSpectraHaveErrorsAndConventions) {
    constexpr double C0 = 3e-21, q0 = 1e5;
    const auto write = [&](const std::string& name, const std::string& head, double unit, bool errors) {
        std::ofstream table(folder_ / name);
        table << head << std::setprecision(15) << "\n";
        for (int i = 0; i <= 400; ++i) {
            const double q = q0 * std::pow(10.0, 0.01 * i), C = C0 * std::pow(q / q0, -3.0);
            table << q / unit << "," << C << (errors ? fmt::format(",{:.15g}", 0.1 * C) : "") << "\n";
        }
    };
    write("q.csv", "q [1/m],C1D [m3],standard_error [m3]", 1.0, true);
    write("f.csv", "frequency (1/m),two-sided PSD (m3)", 2.0 * pi, false);
    const auto path = (folder_ / "both.toml").string();
    std::ofstream(path) << "work_of_adhesion = \"37 ± 3.7 mJ/m2\"\n[surfaces.Q]\npower_spectrum = \"q.csv\"\n"
                           "[surfaces.F]\npower_spectrum = \"f.csv\"\n[rough_solid]\nyoungs_modulus = \"1.1 TPa\"\n"
                           "poisson_ratio = 0.06\n[elastomers.soft]\nyoungs_modulus = \"1 MPa\"\n"
                           "surface_energy = \"25 mJ/m2\"\n";
    const auto result = run_study(read_study(path), {2});
    const auto height = [](const auto& p) { return p.rms_height; };
    const auto known = result.surface("Q").average.estimate(height),
               bare = result.surface("F").average.estimate(height);
    EXPECT_NEAR(known.value, std::sqrt(C0 * q0 / pi), 2e-3 * known.value);
    EXPECT_NEAR(bare.value, known.value, 1e-9 * known.value);
    // half of 10 % over the root of the thirty rows or so that hold most of the heights
    EXPECT_GT(known.standard_error, 0.004 * known.value);
    EXPECT_LT(known.standard_error, 0.02 * known.value);
    EXPECT_TRUE(std::isnan(bare.standard_error));
    const auto has = [&](const std::string& surface, const char* code) {
        const auto& alerts = result.surface(surface).alerts;
        return std::any_of(alerts.begin(), alerts.end(), [&](const Alert& a) { return a.code == code; });
    };
    EXPECT_TRUE(has("F", "SPECTRUM_CONVERTED") && has("F", "SPECTRUM_WITHOUT_ERROR"));
    EXPECT_FALSE(has("Q", "SPECTRUM_CONVERTED") || has("Q", "SPECTRUM_WITHOUT_ERROR"));
    for (const auto& pair : result.pairs) EXPECT_NEAR(pair.modified->estimate.standard_error, 3.7e-3, 1e-5);
}

TEST_F(StudyOfFiles, KeepsTheRestWhenOneLoopIsMissing) {
    const auto result =
        run(std::string(rough_loops) + "[[experiments]]\nfile = \"none.csv\"\nsurface = \"A\"\nelastomer = \"soft\"\n");
    EXPECT_EQ(result.failures(), 1);
    EXPECT_TRUE(result.loop);
    EXPECT_NE(result.experiments.back().error.find("none.csv"), std::string::npos);
}

TEST_F(StudyOfFiles, OneWrongUnitIsNamedWithItsLineAndAffectsNothingElse) {
    const auto with = [&](const std::string& right, const std::string& wrong) {
        auto text = std::string(beginning) + rough_loops;
        text.replace(text.find(right), right.size(), wrong);
        return run_text(text);
    };
    const auto complete = [](const StudyResult& result, const std::string& what) {
        for (const auto& surface : result.surfaces) EXPECT_EQ(surface.error, "") << what;
        for (const auto& experiment : result.experiments) EXPECT_EQ(experiment.error, "") << what;
        ASSERT_EQ(result.pairs.size(), 4u) << what;
        for (const auto& pair : result.pairs) EXPECT_TRUE(pair.approach) << what << pair.surface << pair.elastomer;
    };
    for (const auto& [right, wrong, key] :
         {std::tuple{"surface_energy = \"25 mJ/m2\"", "surface_energy = \"25 J/m2\"",
                     "elastomers.soft.surface_energy = 25"},
          std::tuple{"youngs_modulus = \"0.75 MPa\"", "youngs_modulus = \"0.75 GPa\"",
                     "elastomers.other.youngs_modulus"},
          std::tuple{"sphere_radius = \"1 mm\"", "sphere_radius = \"1 km\"", "elastomers.soft.sphere_radius"}}) {
        const auto result = with(right, wrong);
        complete(result, wrong);
        ASSERT_FALSE(result.alerts.empty()) << wrong;
        EXPECT_EQ(result.alerts.front().code, "UNITS_IMPLAUSIBLE") << wrong;
        EXPECT_NE(result.alerts.front().subject.find("study.toml:"), std::string::npos)
            << result.alerts.front().subject;
        EXPECT_NE(result.alerts.front().message.find(key), std::string::npos) << result.alerts.front().message;
        EXPECT_NE(result.alerts.front().message.find("the likely factor is 10^"), std::string::npos)
            << result.alerts.front().message;
    }
    for (const char* radius : {"1 um", "1 nm", "1 m", "1 km", "1 pm"})
        complete(with("sphere_radius = \"1 mm\"", fmt::format("sphere_radius = \"{}\"", radius)), radius);
    for (const char* energy : {"25 uJ/m2", "25 kJ/m2", "0 J/m2"})
        complete(with("surface_energy = \"25 mJ/m2\"", fmt::format("surface_energy = \"{}\"", energy)), energy);
}

TEST_F(StudyOfFiles, TooSoftRoughSolidLeavesElastomersWithoutModulus) {
    auto text = std::string(beginning) + rough_loops;
    text.replace(text.find("1e9 GPa"), 7, "1 kPa");
    const auto result = run_text(text);
    EXPECT_EQ(result.alerts.front().code, "UNITS_IMPLAUSIBLE");
    EXPECT_TRUE(result.surface("A").error.empty());
    EXPECT_EQ(result.elastomer("soft").contact_modulus.value, 0.0);
    EXPECT_TRUE(result.pairs.front().approach);
    ASSERT_GT(result.failures(), 0);
    EXPECT_NE(result.alerts_of_failed_parts().front().message.find("gives no E"), std::string::npos);
}

TEST_F(StudyOfFiles, GivesTheSameBytesForAnyNumberOfThreads) {
    EXPECT_EQ(output::to_json(run(rough_loops, 1)).dump(), output::to_json(run(rough_loops, 3)).dump());
}

TEST_F(StudyOfFiles, WritesCompleteTablesWithUnits) {
    auto result = run(rough_loops);
    result.study.output = (folder_ / "out").string();
    const auto files = output::write_results(result);
    for (const auto& file : files) EXPECT_GT(std::filesystem::file_size(folder_ / "out" / file), 0u) << file;
    std::size_t present = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder_ / "out")) ++present;
    EXPECT_EQ(present, files.size() + 1) << "files.txt is the only other file";
    std::ifstream pairs(folder_ / "out" / "pairs.csv");
    std::string header;
    std::getline(pairs, header);
    EXPECT_NE(header.find("W_app measured [J/m2]"), std::string::npos);
}

}  // namespace
}  // namespace setae::study::run_study_test
