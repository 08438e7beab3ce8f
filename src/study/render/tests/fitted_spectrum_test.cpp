// SPDX-License-Identifier: GPL-3.0-or-later
// Which spectrum a surface uses, and results of a fitted spectrum.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <unistd.h>

#include "setae/core/constants.hpp"
#include "setae/core/estimate.hpp"
#include "setae/numerics/random_numbers.hpp"
#include "setae/output/json.hpp"
#include "setae/output/screen.hpp"
#include "setae/output/study_tables.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::output::fitted_spectrum_test {
namespace {

/// Random walks, whose C1D falls like q⁻², as files.
class FittedSpectrum : public testing::Test {
protected:
    void SetUp() override { std::filesystem::create_directories(folder_); }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    study::MeasurementInput walk(std::uint64_t seed, Index points = 400, double step = 0.1e-6) {
        const auto path = (folder_ / ("walk" + std::to_string(seed) + "_" + std::to_string(points) + ".csv")).string();
        const Array1D x = Array1D::LinSpaced(points, 0.0, step * static_cast<double>(points - 1));
        Array1D h = numerics::normal_numbers({seed, 0}, 0, points) * (5e-9 * std::sqrt(step / 0.1e-6));
        for (Index i = 1; i < points; ++i) h[i] += h[i - 1];
        tables::write_csv(path, {{{"x", "m", x}, {"h", "m", h}}, {}});
        study::MeasurementInput input;
        input.file = path;
        input.instrument = step < 0.05e-6 ? "afm" : "stylus";
        return input;
    }

    study::SurfaceInput surface(const std::string& name, std::vector<study::MeasurementInput> measurements) {
        return {name, "", std::move(measurements), {}, {}};
    }

    study::Study study() {
        study::Study study;
        study.output = (folder_ / "out").string();
        study.counter_youngs_modulus = 1e12;
        study.work_of_adhesion = Estimate{.value = 0.04};
        study.analysis.cutoff_scan = {};
        study.surfaces = {surface("two", {walk(1), walk(2)}),
                          surface("three", {walk(3), walk(4), walk(5, 400, 0.02e-6)}), surface("one", {walk(6)})};
        study::ElastomerInput soft;
        soft.name = "soft";
        soft.youngs_modulus.value = 1e6;
        soft.surface_energy.value = 0.025;
        study.elastomers = {soft};
        for (const char* name : {"two", "three", "one"}) {
            study::PublishedPair pair;
            pair.surface = name;
            pair.elastomer = "soft";
            pair.approach = Estimate{.value = 0.04};
            study.published.push_back(pair);
        }
        return study;
    }

    std::filesystem::path folder_ =
        std::filesystem::temp_directory_path() / ("setae_fitted_" + std::to_string(::getpid()));
};

bool has_alert(const study::SurfaceResult& surface, const std::string& code) {
    return std::any_of(surface.alerts.begin(), surface.alerts.end(),
                       [&](const Alert& alert) { return alert.code == code; });
}

TEST_F(FittedSpectrum, IsUsedForSeveralMeasurements) {
    const auto result = study::analyse_surface(surface("two", {walk(1), walk(2)}), {}, {1});
    ASSERT_EQ(result.error, "");
    EXPECT_EQ(result.method, study::SpectrumMethod::likelihood);
    ASSERT_TRUE(result.likelihood && result.fitted);
    EXPECT_EQ(&result.used(), &*result.likelihood);
    ASSERT_EQ(study::spectra_of(result).size(), 2u);
    EXPECT_EQ(study::spectra_of(result)[1].method, "average");
}

TEST_F(FittedSpectrum, IsNotUsedForOneMeasurementUnlessRequested) {
    const auto alone = study::analyse_surface(surface("one", {walk(6)}), {}, {1});
    EXPECT_EQ(alone.method, study::SpectrumMethod::average);
    EXPECT_FALSE(alone.fitted);
    EXPECT_FALSE(has_alert(alone, "LIKELIHOOD_FAILED"));
    EXPECT_EQ(
        study::analyse_surface(surface("one", {walk(6)}), {.spectrum = study::SpectrumMethod::likelihood}, {1}).method,
        study::SpectrumMethod::likelihood);
    EXPECT_FALSE(
        study::analyse_surface(surface("two", {walk(1), walk(2)}), {.spectrum = study::SpectrumMethod::average}, {1})
            .likelihood);
}

TEST_F(FittedSpectrum, ReportsTheContributionOfUnmeasuredWaves) {
    const auto coarse = surface("two", {walk(1), walk(2)});  // waves to 0.2 µm
    const auto open = study::analyse_surface(coarse, {}, {1});
    EXPECT_TRUE(has_alert(open, "WAVES_BEYOND_DATA"));
    ASSERT_TRUE(open.beyond_data);
    EXPECT_GT(open.beyond_data->rms_slope.value, open.used().parameters.rms_slope);
    study::SurfaceAnalysisOptions ends;
    ends.likelihood.shortest_wavelength = 0.2e-6;
    EXPECT_FALSE(has_alert(study::analyse_surface(coarse, ends, {1}), "WAVES_BEYOND_DATA"));
}

TEST_F(FittedSpectrum, FallsBackToTheAverageWhenRefused) {
    const auto result = study::analyse_surface(surface("short", {walk(1, 7), walk(2, 7)}), {}, {1});
    ASSERT_EQ(result.error, "");
    EXPECT_EQ(result.method, study::SpectrumMethod::average);
    EXPECT_FALSE(result.fitted);
    EXPECT_TRUE(has_alert(result, "LIKELIHOOD_FAILED"));
}

TEST_F(FittedSpectrum, NamesExcludedFiles) {
    auto missing = walk(2);
    missing.file += ".gone";
    const auto result = study::analyse_surface(surface("two", {walk(1), missing}), {}, {1});
    EXPECT_EQ(result.method, study::SpectrumMethod::average);
    const auto alert = std::find_if(result.alerts.begin(), result.alerts.end(),
                                    [](const Alert& a) { return a.code == "FILES_LEFT_OUT"; });
    ASSERT_NE(alert, result.alerts.end());
    EXPECT_NE(alert->message.find("1 of 2"), std::string::npos);
    EXPECT_NE(alert->message.find("replaces the likelihood"), std::string::npos);
    EXPECT_FALSE(has_alert(study::analyse_surface(surface("two", {walk(1), walk(2)}), {}, {1}), "FILES_LEFT_OUT"));
}

// Increments of variance s² a step Δ: C1D = s²/(Δ q²) up to the turn of sampling; here over the decade 2e5 … 2e6 1/m.
TEST_F(FittedSpectrum, RecoversTheSpectrumOfRandomWalks) {
    const auto result =
        study::analyse_surface(surface("six", {walk(1), walk(2), walk(3), walk(4), walk(5), walk(6)}), {}, {1});
    ASSERT_TRUE(result.fitted);
    const auto& f = *result.fitted;
    double deviation = 0.0, error = 0.0;
    int nodes = 0;
    for (Index i = 0; i < f.wavevector.size(); ++i) {
        if (f.wavevector[i] < 2e6 || f.wavevector[i] > 1e7) continue;
        deviation += std::log(f.C1D[i] / (25e-18 / 0.1e-6 / std::pow(f.wavevector[i], 2)));
        error += f.log_C1D_standard_error[i];
        ++nodes;
    }
    ASSERT_GT(nodes, 20);
    EXPECT_LT(std::abs(deviation), 4.0 * error);
    EXPECT_LT(error / nodes, 0.2);
}

TEST_F(FittedSpectrum, ErrorsOfDecadeMeansMatchThoseOfLines) {
    // SE of a mean of ln C1D is at most the mean SE, and at least that over √10, ten coefficients a decade
    const auto result = study::analyse_surface(surface("two", {walk(1), walk(2)}), {.bootstrap_resamples = 400}, {1});
    ASSERT_TRUE(result.fitted);
    const auto& f = *result.fitted;
    int checked = 0;
    for (const auto& q : decade_quantities(result, result.used())) {
        double sum = 0.0;
        int nodes = 0;
        for (Index i = 0; i < f.wavevector.size(); ++i)
            if (f.wavevector[i] > q.band->lower && f.wavevector[i] < q.band->upper) {
                sum += f.log_C1D_standard_error[i];
                ++nodes;
            }
        const double of_mean = std::log(q.estimate.interval->upper / q.estimate.value) / 1.95996;
        constexpr double scatter = 0.15;  // of a standard error from 400 draws: 4/√800
        EXPECT_LT(of_mean, (1.0 + scatter) * sum / nodes);
        EXPECT_GT(of_mean, (1.0 - scatter) * sum / nodes / std::sqrt(10.0));
        ++checked;
    }
    EXPECT_GE(checked, 1);
}

TEST_F(FittedSpectrum, IsListedWithTheAverageInEveryTable) {
    auto result = study::run_study(study(), {2});
    ASSERT_EQ(result.failures(), 0);
    ASSERT_TRUE(result.by_average);
    const auto rows = [](const tables::TidyTable& table, const std::string& surface, const std::string& method) {
        const auto column = std::find(table.columns.begin(), table.columns.end(), "method") - table.columns.begin();
        return std::count_if(table.rows.begin(), table.rows.end(), [&](const auto& row) {
            return std::get<std::string>(row[0]) == surface &&
                   std::get<std::string>(row[static_cast<std::size_t>(column)]) == method;
        });
    };
    for (const auto& table :
         {surface_table(result), pair_table(result), cumulative_table(result), decade_table(result)}) {
        EXPECT_GT(rows(table, "two", "likelihood"), 0);
        EXPECT_GT(rows(table, "two", "average"), 0);
        EXPECT_EQ(rows(table, "one", "likelihood"), 0);
        EXPECT_GT(rows(table, "one", "average"), 0);
    }
    EXPECT_EQ(rows(pair_table(result), "one", "average"), 1) << "once, not once by each method";
    const auto fits = fit_table(result);
    EXPECT_GT(std::count_if(fits.rows.begin(), fits.rows.end(),
                            [](const auto& row) { return std::get<std::string>(row[2]) == "average"; }),
              0);
    const auto text = summary(result);
    EXPECT_NE(text.find("Measured periodograms against those expected from the fitted spectra"), std::string::npos);
    EXPECT_NE(text.find("likelihood"), std::string::npos);
}

TEST_F(FittedSpectrum, ReportsAgreementBetweenInstruments) {
    const auto result = study::run_study(study(), {2});
    const auto table = agreement_table(result);
    ASSERT_FALSE(table.rows.empty());
    bool afm = false;
    for (const auto& row : table.rows) {
        afm = afm || (std::get<std::string>(row[0]) == "three" && std::get<std::string>(row[1]) == "afm");
        EXPECT_NEAR(std::get<double>(row[3]) / std::get<double>(row[2]), 10.0, 1e-12);
        EXPECT_GT(std::get<double>(row[7]), 1e-4);
    }
    EXPECT_TRUE(afm);
    EXPECT_TRUE(tip_factor_table(result).rows.empty()) << "no tips";
    const auto json = to_json(result);
    const auto& likelihood = json["surfaces"]["three"]["likelihood"];
    EXPECT_EQ(likelihood["agreement"].size(), result.surface("three").fitted->agreement.size());
    EXPECT_EQ(likelihood["spectrum"]["C1D"]["unit"], "m3");
    EXPECT_EQ(likelihood["spectrum"]["C1D_high"]["values"].size(),
              likelihood["spectrum"]["wavevector"]["values"].size());
    EXPECT_FALSE(json["surfaces"]["one"].contains("likelihood"));
    for (const char* key : {"fits", "pairs", "cutoff_scan", "work_of_adhesion"})
        EXPECT_TRUE(json["by_average"].contains(key)) << key;
}

TEST_F(FittedSpectrum, BandsAreNinetyFivePercentIntervals) {
    const auto result = study::analyse_surface(surface("two", {walk(1), walk(2)}), {}, {1});
    const auto table = fitted_spectrum_table(*result.fitted);
    for (const std::string name : {"C_iso", "C1D"}) {
        const auto &value = table.at(name), &error = table.at(name + "_standard_error"), &low = table.at(name + "_low"),
                   &high = table.at(name + "_high");
        EXPECT_LT((low * high / value.square() - 1.0).abs().maxCoeff(), 1e-12);
        EXPECT_LT(((high / low).log() / (2.0 * 1.959963985 * error / value) - 1.0).abs().maxCoeff(), 1e-9);
    }
}

TEST_F(FittedSpectrum, HasTheSameBytesForAnyNumberOfThreads) {
    const auto written = [&](int threads) {
        auto result = study::run_study(study(), {threads});
        std::string all;
        for (const auto& file : write_results(result)) {
            std::ifstream stream(folder_ / "out" / file, std::ios::binary);
            std::ostringstream bytes;
            bytes << stream.rdbuf();
            all += file + "\n" + bytes.str();
        }
        return all;
    };
    const auto one = written(1);
    EXPECT_NE(one.find("likelihood_three.csv"), std::string::npos);
    EXPECT_TRUE(one == written(3));
}

}  // namespace
}  // namespace setae::output::fitted_spectrum_test
