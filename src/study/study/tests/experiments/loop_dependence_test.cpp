// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/loop_dependence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <unistd.h>

#include "loop_files.hpp"
#include "setae/cache/store.hpp"
#include "setae/core/errors.hpp"
#include "setae/study/study_result.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::study::loop_dependence_test {
namespace {

/// Standard error of a value that one input makes; signed, 0 where the value does not rest on it.
double part(const Components& components, const std::string& input) {
    const auto found = components.find(input);
    return found == components.end() ? 0.0 : found->second.directions[0];
}

class StudyLoops : public testing::Test {
protected:
    void SetUp() override {
        std::filesystem::create_directories(folder_);
        for (int i = 0; i < 4; ++i)
            tables::write_csv((folder_ / fmt::format("loop{}.csv", i)).string(),
                              loop_files::noisy_loop(0.030 + 0.004 * i, 0.060, 20e-6, 1U + static_cast<unsigned>(i)));
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    /// elastomer: further keys of it; loops: [loops] and [[experiments]].
    StudyResult run(const std::string& elastomer, const std::string& loops, const std::string& inputs = "",
                    const RunOptions& options = {}) {
        const auto path = (folder_ / "study.toml").string();
        std::ofstream(path) << inputs
                            << "[rough_solid]\nyoungs_modulus = \"100 MPa\"\npoisson_ratio = 0.3\n"
                               "[analysis]\nbootstrap_resamples = 0\n"
                               "[surfaces.A]\nmoments = { rms_height = \"20 nm\", rms_slope = 0.3, rms_curvature = "
                               "\"1e8 1/m\", short_wavevector = \"1e9 1/m\" }\n"
                               "[surfaces.B]\nmoments = { rms_height = \"30 nm\", rms_slope = 0.4, rms_curvature = "
                               "\"1e8 1/m\", short_wavevector = \"1e9 1/m\" }\n"
                               "[elastomers.soft]\nsurface_energy = \"25 mJ/m2\"\n"
                            << elastomer << loops;
        return run_study(read_study(path), options);
    }

    static std::string experiment(int loop, const std::string& surface, const std::string& more = "") {
        return fmt::format("[[experiments]]\nfile = \"loop{}.csv\"\nsurface = \"{}\"\nelastomer = \"soft\"\n{}", loop,
                           surface, more);
    }

    static const PairResult& pair(const StudyResult& result, const std::string& surface) {
        for (const auto& pair : result.pairs)
            if (pair.surface == surface) return pair;
        throw InternalError("no such pair");
    }

    std::string error_of(const std::string& elastomer, const std::string& loops, const std::string& inputs = "") {
        try {
            (void)run(elastomer, loops, inputs);
        } catch (const FormatError& error) {
            return std::string(error.what()).substr(folder_.string().size() + 1);
        }
        return "no error";
    }

    std::filesystem::path folder_ =
        std::filesystem::temp_directory_path() / ("setae_dependence_" + std::to_string(::getpid()));
};

constexpr const char* lens = "sphere_radius = \"1.00 ± 0.01 mm\"\n";

TEST_F(StudyLoops, DependOnTheRadiusOfTheirLens) {
    const auto result = run(lens, experiment(0, "A") + experiment(1, "B"));
    const std::string name = "elastomers.soft.sphere_radius";
    for (const auto& p : result.pairs) {
        EXPECT_NEAR(part(p.approach_inputs, name) / (-0.01 * p.approach->value), 1.0, 1e-5);
        EXPECT_NEAR(part(p.pull_off_inputs, name) / (-0.01 * p.pull_off->value), 1.0, 1e-5);
        EXPECT_NEAR(part(p.retraction_inputs, name) / (-0.01 * p.retraction->value), 1.0, 1e-5);
        EXPECT_TRUE(p.loss_inputs.empty());
        // own noise is as without the lens's
        EXPECT_LT(p.approach->standard_error, 1e-3 * p.approach->value);
    }
    const auto exact = run("sphere_radius = \"1 mm\"\n", experiment(0, "A") + experiment(1, "B"));
    EXPECT_EQ(pair(result, "A").approach->standard_error, pair(exact, "A").approach->standard_error);
    EXPECT_TRUE(pair(exact, "A").approach_inputs.empty());
    // E* of both loops moves with R, and so does their mean
    const auto& soft = result.elastomers.front();
    EXPECT_NEAR(part(soft.traced_contact_modulus.components, name) / (0.01 * soft.contact_modulus.value), 1.0, 1e-3);
    EXPECT_EQ(soft.contact_modulus.standard_error, soft.traced_contact_modulus.standard_error());
    EXPECT_GT(soft.youngs_modulus.standard_error, 0.0099 * soft.youngs_modulus.value);
    // one lens: the two W are wrong together, W and E* against each other
    const auto a = *pair(result, "A").traced_approach(), b = *pair(result, "B").traced_approach();
    EXPECT_GT(covariance(a, b) / (a.standard_error() * b.standard_error()), 0.99);
    EXPECT_LT(covariance(a, soft.traced_contact_modulus), 0.0);
}

TEST_F(StudyLoops, ShareALensByItsName) {
    const auto result =
        run("", experiment(0, "A", "sphere_radius = \"lens_3\"\n") + experiment(1, "B", "sphere_radius = \"lens_3\"\n"),
            "[inputs]\nlens_3 = \"1.00 ± 0.01 mm\"\n");
    const auto &a = pair(result, "A").approach_inputs, &b = pair(result, "B").approach_inputs;
    EXPECT_EQ(a.size(), 1U);
    EXPECT_NEAR(covariance(a, b) / (part(a, "lens_3") * part(b, "lens_3")), 1.0, 1e-12);
    // two lenses are two inputs
    const auto apart = run("", experiment(0, "A", "sphere_radius = \"1.00 ± 0.01 mm\"\n") +
                                   experiment(1, "B", "sphere_radius = \"1.00 ± 0.01 mm\"\n"));
    EXPECT_EQ(covariance(pair(apart, "A").approach_inputs, pair(apart, "B").approach_inputs), 0.0);
    EXPECT_NE(part(pair(apart, "B").approach_inputs, "experiments[2].sphere_radius"), 0.0);
}

// A pair of one loop: what its inputs make of it is what the whole study finds with one of them a little off.
TEST_F(StudyLoops, ChangeWithTheirInputsByTheirDerivatives) {
    struct Input {
        const char* key;
        bool of_loops;
        double value;
        const char* unit;
    };
    const std::vector<Input> inputs{{"sphere_radius", false, 1.0, "mm"},
                                    {"sphere_height", false, 0.7, "mm"},
                                    {"poisson_ratio", false, 0.47, ""},
                                    {"machine_stiffness", true, 2000.0, "N/m"},
                                    {"force_calibration", true, 1.02, ""},
                                    {"displacement_calibration", true, 0.97, ""},
                                    {"contact_radius_calibration", true, 1.01, ""}};
    const auto study_with = [&](const Input& changed, double factor, bool uncertain) {
        std::string elastomer, loops = "[loops]\n";
        for (const auto& input : inputs)
            (input.of_loops ? loops : elastomer) += fmt::format(
                "{} = \"{:.17g}{} {}\"\n", input.key, input.value * (input.key == changed.key ? factor : 1.0),
                uncertain && input.key == changed.key ? fmt::format(" ± {:.17g}", 0.01 * input.value) : "", input.unit);
        return run(elastomer, loops + experiment(0, "A"));
    };
    for (const auto& input : inputs) {
        const auto result = study_with(input, 1.0, true);
        const auto name = std::string(input.of_loops ? "loops." : "elastomers.soft.") + input.key;
        constexpr double step = 2e-3;
        const auto above = study_with(input, 1.0 + step, false), below = study_with(input, 1.0 - step, false);
        const auto expect = [&](const char* number, const Components& found, double value, double higher,
                                double lower) {
            EXPECT_NEAR(part(found, name), 0.01 * (higher - lower) / (2.0 * step), 1e-4 * 0.01 * std::abs(value))
                << number << " by " << input.key;
        };
        const auto &p = pair(result, "A"), &high = pair(above, "A"), &low = pair(below, "A");
        expect("W_app", p.approach_inputs, p.approach->value, high.approach->value, low.approach->value);
        expect("W_po", p.pull_off_inputs, p.pull_off->value, high.pull_off->value, low.pull_off->value);
        expect("W_ret", p.retraction_inputs, p.retraction->value, high.retraction->value, low.retraction->value);
        expect("E_loss", p.loss_inputs, p.loss->value, high.loss->value, low.loss->value);
        const auto &E = result.elastomers.front(), &E_high = above.elastomers.front(),
                   &E_low = below.elastomers.front();
        expect("E", E.traced_youngs_modulus.components, E.youngs_modulus.value, E_high.youngs_modulus.value,
               E_low.youngs_modulus.value);
        expect("E*", E.traced_contact_modulus.components, E.contact_modulus.value, E_high.contact_modulus.value,
               E_low.contact_modulus.value);
    }
}

TEST_F(StudyLoops, ShareTheNoiseOfTheirFitsWithTheModulus) {
    const auto result = run("sphere_radius = \"1 mm\"\n",
                            experiment(0, "A") + experiment(1, "A") + experiment(2, "B") + experiment(3, "B"));
    for (const auto& p : result.pairs) {
        const auto traced = *p.traced_approach();
        EXPECT_EQ(p.approach_fits.size(), 2U);
        EXPECT_NEAR(traced.variance() / p.approach->variance(), 1.0, 1e-12);
        EXPECT_NEAR(
            traced.estimate().degrees_of_freedom.value_or(INFINITY) / p.approach->degrees_of_freedom.value_or(INFINITY),
            1.0, 1e-9);
        EXPECT_TRUE(traced.components.contains(fmt::format("noise of W_app on {} × soft", p.surface)));
    }
    const auto& soft = result.elastomers.front();
    EXPECT_NEAR(soft.traced_youngs_modulus.variance() / soft.youngs_modulus.variance(), 1.0, 1e-12);
    // one loop alone: the covariance of E and W is that of its fit
    const auto single = run("sphere_radius = \"1 mm\"\n", experiment(0, "A"));
    const auto& fit = single.experiments.front().analysis->loading.primary();
    const auto w = *pair(single, "A").traced_approach();
    const auto& E = single.elastomers.front().traced_youngs_modulus;
    EXPECT_NEAR(w.standard_error() / fit.work_of_adhesion.standard_error, 1.0, 1e-12);
    EXPECT_NEAR(E.standard_error() / fit.youngs_modulus.standard_error, 1.0, 1e-12);
    EXPECT_NEAR(covariance(w, E) / (w.standard_error() * E.standard_error()), fit.correlation, 1e-12);
    EXPECT_GT(std::abs(fit.correlation), 0.3);
}

TEST_F(StudyLoops, OfAGivenModulusDoNotShareNoise) {
    const auto result =
        run("sphere_radius = \"1 mm\"\nyoungs_modulus = \"0.7 ± 0.02 MPa\"\npoisson_ratio = \"0.48 ± 0.01\"\n",
            experiment(0, "A"));
    EXPECT_TRUE(pair(result, "A").approach_fits.empty());
    const auto& soft = result.elastomers.front();
    EXPECT_EQ(part(soft.traced_youngs_modulus.components, "elastomers.soft.youngs_modulus"), 2e4);
    const auto modulus = [](double E, double nu) { return 1.0 / ((1.0 - nu * nu) / E + 0.91 / 1e8); };
    EXPECT_NEAR(part(soft.traced_contact_modulus.components, "elastomers.soft.youngs_modulus") /
                    (10.0 * (modulus(0.701e6, 0.48) - modulus(0.699e6, 0.48))),
                1.0, 1e-6);
    EXPECT_NEAR(part(soft.traced_contact_modulus.components, "elastomers.soft.poisson_ratio") /
                    (5.0 * (modulus(0.7e6, 0.481) - modulus(0.7e6, 0.479))),
                1.0, 1e-5);
    EXPECT_TRUE(pair(result, "A").approach_inputs.empty());
}

TEST_F(StudyLoops, InMixedModelsDependOnInputsByTheirWeights) {
    const auto result = run(lens, "[comparison]\ncrossed = [\"lens\"]\n" + experiment(0, "A", "lens = \"a\"\n") +
                                      experiment(1, "A", "lens = \"b\"\n") + experiment(2, "B", "lens = \"a\"\n") +
                                      experiment(3, "B", "lens = \"b\"\n"));
    for (const auto& p : result.pairs) {
        ASSERT_NE(p.approach->method, "mean over loops");
        // every W goes with 1/R, and so does a mean that is linear in them
        EXPECT_NEAR(part(p.approach_inputs, "elastomers.soft.sphere_radius") / (-0.01 * p.approach->value), 1.0, 1e-5);
    }
}

TEST_F(StudyLoops, AreMultipliedByTheirCalibrations) {
    const auto plain = run("sphere_radius = \"1 mm\"\n", experiment(0, "A"));
    const auto result =
        run("sphere_radius = \"1 mm\"\n", "[loops]\nforce_calibration = 1.1\ndisplacement_calibration = 0.9\n" +
                                              experiment(0, "A", "contact_radius_calibration = 1.05\n"));
    const auto &p = pair(result, "A"), &before = pair(plain, "A");
    EXPECT_NEAR(p.approach->value / before.approach->value, 1.1, 1e-6);
    EXPECT_NEAR(p.loss->value / before.loss->value, 1.1 * 0.9, 1e-9);
    EXPECT_NEAR(result.experiments.front().analysis->loading.primary().contact_modulus.value /
                    plain.experiments.front().analysis->loading.primary().contact_modulus.value,
                1.1 * std::pow(1.05, -3), 1e-6);
}

TEST_F(StudyLoops, StoreDerivativesWithTheAnalysis) {
    const cache::Store store((folder_ / "cache").string(), "test");
    const auto loops = experiment(0, "A");
    const auto first = run(lens, loops, "", {.store = &store});
    bool computed = false;
    const auto second = run("sphere_radius = \"1.00 ± 0.02 mm\"\n", loops, "",
                            {.store = &store, .progress = [&](const Progress& step) {
                                 computed |= step.stage == "experiment" && !step.begins && !step.cached;
                             }});
    EXPECT_FALSE(computed);
    const std::string name = "elastomers.soft.sphere_radius";
    EXPECT_EQ(part(pair(second, "A").approach_inputs, name), 2.0 * part(pair(first, "A").approach_inputs, name));
}

TEST_F(StudyLoops, RefuseImpossibleInputs) {
    const auto loops = [](const char* key) { return std::string("[loops]\n") + key + "\n"; };
    EXPECT_EQ(error_of(lens, loops("force_calibration = 0")),
              "study.toml:14: loops.force_calibration: '0', expected above 0");
    EXPECT_EQ(error_of(lens, loops("displacement_calibration = -1.0")),
              "study.toml:14: loops.displacement_calibration: '-1', expected above 0");
    EXPECT_NE(error_of(lens, loops("contact_radius_calibration = \"1.1 um\""))
                  .find("study.toml:14: loops.contact_radius_calibration: "),
              std::string::npos);
    EXPECT_NE(error_of("sphere_radius = \"1.0 ± 1.2 mm\"\n", "").find("elastomers.soft.sphere_radius: "),
              std::string::npos);
    EXPECT_NE(error_of("sphere_radius = \"lens\"\n", experiment(0, "A", "sphere_radius = \"lens = 2 mm\"\n"),
                       "[inputs]\nlens = \"1.0 ± 0.1 mm\"\n")
                  .find("expected one value per name"),
              std::string::npos);
}

}  // namespace
}  // namespace setae::study::loop_dependence_test
