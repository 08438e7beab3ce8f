// SPDX-License-Identifier: GPL-3.0-or-later
#include "small_studies.hpp"

namespace setae::study_figures::contact_figures_test {
namespace {

using study::StudyResult;

/// Loops on elastomers of 0.7 and 2 MPa, the first surface on both.
StudyResult study_of_loops() {
    StudyResult result;
    result.surfaces = {given_surface("smooth"), given_surface("rough")};
    result.elastomers = {elastomer("soft", 0.7e6), elastomer("hard", 2e6)};
    for (const auto& e : result.elastomers) result.study.elastomers.push_back(e.input);
    result.experiments = {jkr_experiment("smooth", result.elastomers[0], 0.04),
                          jkr_experiment("smooth", result.elastomers[1], 0.04),
                          jkr_experiment("rough", result.elastomers[1], 0.03)};
    return result;
}

/// y of a curve at x, linear between its points.
double at(const figures::Series& curve, double x) {
    for (Index i = 1; i < curve.x.size(); ++i)
        if ((curve.x[i - 1] - x) * (curve.x[i] - x) <= 0.0)
            return curve.y[i - 1] +
                   (curve.y[i] - curve.y[i - 1]) * (x - curve.x[i - 1]) / (curve.x[i] - curve.x[i - 1]);
    return undefined;
}

TEST(Figure2, ShowsTheElastomerClosestToThatOfThePaper) {
    const auto drawn = study_figure(study_of_loops(), "2");
    ASSERT_EQ(drawn.figure.panels.size(), 2u);
    EXPECT_NE(drawn.caption.find("Contact on hard"), std::string::npos) << drawn.caption;
    const auto& panel = drawn.figure.panels[0];
    const auto& loading = series_of(panel, "rough, loading");
    const auto& unloading = series_of(panel, "rough, unloading");
    EXPECT_TRUE(loading.hollow);
    EXPECT_FALSE(unloading.hollow);
    EXPECT_NEAR(loading.x[loading.x.size() - 1], 1.0, 1e-12);  // mN
    // the retraction's contact is the larger
    EXPECT_GT(unloading.y[unloading.y.size() / 2], at(loading, unloading.x[unloading.x.size() / 2]));
}

TEST(Figure2, FitsPassThroughTheFittedLoading) {
    const auto drawn = study_figure(study_of_loops(), "2");
    const auto& fit = series_of(drawn.figure.panels[0], "rough, JKR of loading");
    EXPECT_EQ(fit.dash, 1);
    // a³ = (3R/4E*) 6πRW at F = 0
    const double radius = 1.25e-3, modulus = 2e6 / 0.75, work = 0.03;
    EXPECT_NEAR(at(fit, 0.0), 1e6 * std::cbrt(0.75 * radius / modulus * 6.0 * pi * radius * work), 0.02);
    // it begins at −3/2 πRW
    EXPECT_NEAR(fit.x[0], -1.5e3 * pi * radius * work, 1e-9);
    const auto& loading = series_of(drawn.figure.panels[0], "rough, loading");
    for (Index i = 1; i + 1 < loading.x.size(); ++i) EXPECT_NEAR(at(fit, loading.x[i]), loading.y[i], 0.05) << i;
}

TEST(Figure2, ShadesTheLoopWithTheMaximumLoss) {
    auto result = study_of_loops();
    auto energetic = *result.experiments[2].analysis->loop;
    energetic.energy = 3e-9;
    result.experiments[2].analysis->loop = loops::Outcome<loops::LoopEnergy>(energetic);
    const auto drawn = study_figure(result, "2");
    const auto& shaded = series_of(drawn.figure.panels[1], "rough, lost energy");
    EXPECT_EQ(shaded.mark, figures::Mark::area);
    EXPECT_LE(shaded.x.size(), 400);
    EXPECT_NEAR(shaded.y.maxCoeff(), 1.0, 1e-12);
    EXPECT_NE(drawn.caption.find("loses 3.000 nJ"), std::string::npos) << drawn.caption;
}

TEST(Figure2, RequiresAContactRadius) {
    auto result = study_of_loops();
    for (auto& e : result.experiments) e.analysis->corrected.contact_radius.resize(0);
    EXPECT_EQ(study_figure(result, "2").reason, "no loop on a rough surface has a contact radius");
    for (auto& e : result.experiments) e.analysis.reset();
    EXPECT_EQ(study_figure(result, "S5").reason, "every loop on a rough surface failed");
}

TEST(Figure2, ShowsFramesIfFewerThanSamples) {
    auto result = study_of_loops();
    for (auto& e : result.experiments)
        for (Index i = 0; i < e.analysis->corrected.contact_radius.size(); ++i)
            if (i % 7 != 0) e.analysis->corrected.contact_radius[i] = undefined;
    const auto drawn = study_figure(result, "2");
    const auto& loading = series_of(drawn.figure.panels[0], "rough, loading");
    EXPECT_GE(loading.x.size(), 14);
    EXPECT_TRUE(loading.y.isFinite().all());
}

TEST(FigureS5, HasAPanelForEachElastomerAndTheRetraction) {
    const auto drawn = study_figure(study_of_loops(), "S5");
    ASSERT_EQ(drawn.figure.panels.size(), 2u);
    EXPECT_EQ(drawn.figure.panels[1].title.substr(0, 4), "hard");
    const auto& retraction = series_of(drawn.figure.panels[1], "rough, (S2)");
    // F_po = −3/2 πRW with the W of retraction
    EXPECT_NEAR(retraction.x[0], -1.5e3 * pi * 1.25e-3 * 0.06, 1e-9);
    const auto& unloading = series_of(drawn.figure.panels[1], "rough, unloading");
    const Index last = unloading.x.size() - 1;
    EXPECT_NEAR(at(retraction, unloading.x[last]), unloading.y[last], 0.1);
}

TEST(FigureS6, ShowsReferencesByStage) {
    auto result = study_of_loops();
    for (auto& e : result.experiments) {
        e.input.reference = true;
        e.input.surface.clear();
    }
    result.experiments[1].input.stage = "before";
    result.experiments[2].input.stage = "after";
    EXPECT_EQ(study_figure(result, "2").reason, "the study has no loop on a rough surface");
    const auto drawn = study_figure(result, "S6");
    ASSERT_EQ(drawn.figure.panels.size(), 2u);
    EXPECT_NE(series_of(drawn.figure.panels[1], "before, loading").colour,
              series_of(drawn.figure.panels[1], "after, loading").colour);
    EXPECT_NO_THROW((void)series_of(drawn.figure.panels[1], "after, JKR of loading"));
}

TEST(ContactFigures, OmitFitsWithoutAdhesion) {
    auto result = study_of_loops();
    auto fit = *result.experiments[2].analysis->loading.radius_force;
    fit.work_of_adhesion.value = -0.01;
    result.experiments[2].analysis->loading.radius_force = loops::Outcome<loops::JkrFit>(fit);
    const auto drawn = study_figure(result, "2");
    ASSERT_TRUE(drawn.drawable()) << drawn.reason;
    EXPECT_THROW((void)series_of(drawn.figure.panels[0], "rough, JKR of loading"), std::runtime_error);
    EXPECT_NO_THROW((void)series_of(drawn.figure.panels[0], "smooth, JKR of loading"));
}

}  // namespace
}  // namespace setae::study_figures::contact_figures_test
