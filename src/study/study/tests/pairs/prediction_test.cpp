// SPDX-License-Identifier: GPL-3.0-or-later
// The uncertainty of predictions: linear propagation through a whole study against draws of its inputs.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "setae/adhesion/work_of_adhesion.hpp"
#include "setae/core/constants.hpp"
#include "setae/output/study_tables.hpp"

namespace setae::study::prediction_test {
namespace {

constexpr double contact_radius = 1e-4;

/// One surface with published moments (those of NCD) and one elastomer, every input uncertain.
Study uncertain_study() {
    Study study;
    SurfaceInput surface;
    surface.name = "NCD";
    surface.moments = PublishedMoments{.rms_height = {121.7e-9, 8e-9, "given"},
                                       .rms_slope = {1.15, 0.04, "given"},
                                       .rms_curvature = {3.19e9, 0.1e9, "given"},
                                       .short_wavevector = {1.6e10}};
    study.surfaces = {surface};
    ElastomerInput elastomer;
    elastomer.name = "soft";
    elastomer.youngs_modulus = {0.69e6, 0.03e6, "given"};
    elastomer.surface_energy = {0.025, 0.002, "given"};
    study.elastomers = {elastomer};
    study.counter_youngs_modulus = INFINITY;
    study.work_of_adhesion = Estimate{0.037, 0.0015, "given"};
    study.published.push_back({.surface = "NCD", .elastomer = "soft", .contact_radius = contact_radius});
    return study;
}

struct Moments {
    double count = 0.0, sum = 0.0, squares = 0.0;
    void add(double x) {
        count += 1.0;
        sum += x;
        squares += x * x;
    }
    [[nodiscard]] double deviation() const { return std::sqrt((squares - sum * sum / count) / (count - 1.0)); }
};

TEST(Prediction, PropagatesEveryUncertainInputLikeDraws) {
    const auto study = uncertain_study();
    const auto result = run_study(study, {1});
    const auto& pair = result.pairs.at(0);
    ASSERT_TRUE(pair.modified && pair.predicted_loss);
    // 6000 draws determine a standard deviation to 1/√12000 = 0.9 %; three of it, and 2 % for what is not linear
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    const auto drawn = [&](const Estimate& estimate) {
        return estimate.value + estimate.standard_error * normal(random);
    };
    Moments work, energy, loss;
    for (int i = 0; i < 6000; ++i) {
        auto moved = study.surfaces.front();
        for (auto* moment : {&moved.moments->rms_height, &moved.moments->rms_slope, &moved.moments->rms_curvature})
            *moment = {drawn(*moment), 0.0, "given"};
        const auto surface = analyse_surface(moved, study.analysis, {1});
        ASSERT_FALSE(surface.failed()) << surface.error;
        const double modulus = drawn(study.elastomers.front().youngs_modulus) / 0.75,
                     gamma = drawn(study.elastomers.front().surface_energy);
        const double intrinsic = drawn(*study.work_of_adhesion),
                     stored = modulus * surface.average.parameters.elastic_energy_per_modulus;
        work.add(adhesion::modified_balance(intrinsic, gamma, {surface.area_ratio(), stored}).raw);
        energy.add(stored);
        loss.add(intrinsic * surface.area_ratio() * pi * contact_radius * contact_radius);
    }
    EXPECT_NEAR(pair.modified->estimate.standard_error / work.deviation(), 1.0, 0.047);
    EXPECT_NEAR(pair.stored_energy.standard_error / energy.deviation(), 1.0, 0.047);
    EXPECT_NEAR(pair.predicted_loss->standard_error() / loss.deviation(), 1.0, 0.047);
}

// E_loss = W_int r π a² with a of (1) at W_app, no loop measured
TEST(Prediction, OfAPairWithoutExperimentsHasItsLoop) {
    auto study = uncertain_study();
    study.published.clear();
    auto& elastomer = study.elastomers.front();
    elastomer.sphere_radius = Estimate{1.25e-3, 0.0};
    EXPECT_FALSE(run_study(study, {1}).pairs.at(0).predicted_loss) << "no force is given";
    elastomer.preload = 1e-3;
    const auto result = run_study(study, {1});
    const auto& pair = result.pairs.at(0);
    ASSERT_TRUE(pair.loop && pair.predicted_loss);
    const double R = 1.25e-3, K = elastomer.youngs_modulus.value / 0.75, W = pair.modified->work.raw,
                 pull = 3.0 * pi * R * W,
                 a = std::cbrt(0.75 * R / K * (1e-3 + pull + std::sqrt(2.0 * pull * 1e-3 + pull * pull)));
    EXPECT_NEAR(pair.loop->contact_radius.value, a, 1e-9 * a);
    EXPECT_NEAR(pair.predicted_loss->value, 0.037 * pair.area_ratio * pi * a * a, 1e-9 * pair.predicted_loss->value);
    EXPECT_GT(pair.predicted_loss->standard_error(), 0.0);
}

TEST(Prediction, ListsItsVarianceByInput) {
    const auto result = run_study(uncertain_study(), {1});
    const auto& pair = result.pairs.at(0);
    const auto& b = *pair.budget;
    const double sum = b.spectrum * b.spectrum + b.modulus * b.modulus + b.surface_energy * b.surface_energy +
                       b.work_of_adhesion * b.work_of_adhesion;
    EXPECT_NEAR(pair.modified->estimate.variance() / sum, 1.0, 1e-12);
    EXPECT_NEAR(b.modulus,
                0.03e6 / 0.75 * pair.seen.energy * result.surfaces[0].average.parameters.elastic_energy_per_modulus,
                1e-6 * b.modulus);
    EXPECT_LT(pair.seen.energy, 1.0);  // waves longer than its contact
    EXPECT_NEAR(b.surface_energy, (pair.area_ratio - 1.0) * 0.002, 1e-12);
    EXPECT_NEAR(b.work_of_adhesion, pair.area_ratio * 0.0015, 1e-12);
}

TEST(Prediction, HasTheDegreesOfFreedomOfItsInputs) {
    auto study = uncertain_study();
    EXPECT_FALSE(run_study(study, {1}).pairs.at(0).modified->estimate.degrees_of_freedom);
    study.work_of_adhesion->degrees_of_freedom = 3.0;
    const auto pair = run_study(study, {1}).pairs.at(0);
    const auto& b = *pair.budget;
    // only the work is known with few: ν = 3 (Σ v)²/v_W²
    EXPECT_NEAR(*pair.modified->estimate.degrees_of_freedom,
                3.0 * std::pow(pair.modified->estimate.variance(), 2) / std::pow(b.work_of_adhesion, 4), 1e-9);
}

TEST(Prediction, IsListedForEachMethodInTables) {
    auto result = run_study(uncertain_study(), {1});
    const auto pairs = output::pair_table(result).rows.size(), surfaces = output::surface_table(result).rows.size();
    result.by_average = static_cast<const Conclusions&>(result);
    result.by_average->of_averages = true;
    auto& surface = result.surfaces.front();
    surface.reconstructed = false;
    surface.measurements.resize(1);
    surface.likelihood = surface.average;
    surface.method = SpectrumMethod::likelihood;
    const auto table = output::pair_table(result);
    ASSERT_EQ(table.rows.size(), 2 * pairs);
    EXPECT_EQ(std::get<std::string>(table.rows.front()[2]), "likelihood");
    EXPECT_EQ(std::get<std::string>(table.rows.back()[2]), "average");
    EXPECT_EQ(output::surface_table(result).rows.size(), 2 * surfaces);
}

}  // namespace
}  // namespace setae::study::prediction_test
