// SPDX-License-Identifier: GPL-3.0-or-later
// Alerts of pairs, elastomers and reconstructed spectra: each where it belongs and nowhere else.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "setae/study/study_result.hpp"

namespace setae::study::alerts_test {
namespace {

/// NCD of [D19] against an elastomer of this modulus at W_int = 37.1 mJ/m².
Study ncd_against(double youngs_modulus) {
    Study study;
    SurfaceInput surface;
    surface.name = "NCD";
    surface.moments = PublishedMoments{.rms_height = {121.7e-9, 0.0},
                                       .rms_slope = {1.15, 0.0},
                                       .rms_curvature = {3.19e9, 0.0},
                                       .short_wavevector = {1.6e10}};
    study.surfaces = {surface};
    ElastomerInput elastomer;
    elastomer.name = "E";
    elastomer.youngs_modulus = {youngs_modulus};
    elastomer.surface_energy = {0.025};
    study.elastomers = {elastomer};
    study.counter_youngs_modulus = 1100e9;
    study.counter_poisson_ratio = 0.06;
    study.work_of_adhesion = Estimate{.value = 37.1e-3};
    PublishedPair pair;
    pair.surface = "NCD";
    pair.elastomer = "E";
    pair.approach = Estimate{.value = 20e-3};
    study.published = {pair};
    return study;
}

bool has(const std::vector<Alert>& alerts, const std::string& code) {
    return std::any_of(alerts.begin(), alerts.end(), [&](const Alert& alert) { return alert.code == code; });
}

TEST(PairWarnings, StateHowThePairComesIntoFullContact) {
    using adhesion::Closing;
    const auto soft = run_study(ncd_against(0.69e6), {1}), middle = run_study(ncd_against(1.91e6), {1}),
               stiff = run_study(ncd_against(10.03e6), {1});
    const auto& closes = soft.pairs.at(0);
    EXPECT_EQ(closes.closing(), Closing::spontaneous);
    for (const char* code : {"NEEDS_PRESSURE", "CONFORMAL_INVALID", "WILL_NOT_CONFORM"})
        EXPECT_FALSE(has(closes.alerts, code)) << code;
    const auto& pressed = middle.pairs.at(0);
    EXPECT_EQ(pressed.closing(), Closing::under_pressure);
    EXPECT_TRUE(has(pressed.alerts, "NEEDS_PRESSURE"));
    EXPECT_FALSE(has(pressed.alerts, "CONFORMAL_INVALID"));
    // U/AW = 0.57: 1.36 U/(A h_rms), by patches whose e is 0.5 and 0.6
    const double height = middle.surfaces.at(0).used().parameters.rms_height;
    EXPECT_NEAR(pressed.scales->closing_pressure[0], 1.36 * pressed.stored_energy.value / height,
                0.02 * pressed.scales->closing_pressure[0]);
    const auto& opens = stiff.pairs.at(0);
    EXPECT_EQ(opens.closing(), Closing::opens);
    EXPECT_TRUE(has(opens.alerts, "CONFORMAL_INVALID"));
    EXPECT_TRUE(has(opens.alerts, "WILL_NOT_CONFORM"));
    EXPECT_FALSE(has(opens.alerts, "NEEDS_PRESSURE"));
}

TEST(ElastomerWarnings, ReportAModulusInconsistentWithTheNetwork) {
    auto study = ncd_against(1e6);
    study.elastomers[0].crosslink_molar_mass = 3.0;  // ρRT/M_c = 0.8 MPa
    EXPECT_FALSE(has(run_study(study, {1}).elastomers[0].alerts, "MODULUS_IMPLAUSIBLE"));
    study.elastomers[0].crosslink_molar_mass = 3000.0;  // g/mol typed as kg/mol
    EXPECT_TRUE(has(run_study(study, {1}).elastomers[0].alerts, "MODULUS_IMPLAUSIBLE"));
}

TEST(ReconstructionWarnings, ReportReconstructionsWithIncompleteErrors) {
    const auto exact = run_study(ncd_against(1e6), {1});
    EXPECT_TRUE(has(exact.surfaces[0].alerts, "RECONSTRUCTION"));
    EXPECT_FALSE(has(exact.surfaces[0].alerts, "SPREAD_INCOMPLETE"));
    auto wide = ncd_against(1e6);
    wide.surfaces[0].moments->rms_curvature.standard_error = 3.1e9;  // down to slopes that no self-affine surface has
    EXPECT_TRUE(has(run_study(wide, {1}).surfaces[0].alerts, "SPREAD_INCOMPLETE"));
}

TEST(ReconstructionWarnings, ReportSlopesTooSteepForStoredEnergy) {
    auto study = ncd_against(1e6);  // slope 1.15
    EXPECT_TRUE(has(run_study(study, {1}).surfaces[0].alerts, "STEEP_SLOPES"));
    study.surfaces[0].moments = PublishedMoments{.rms_height = {4.6e-9, 0.0},
                                                 .rms_slope = {0.39, 0.0},
                                                 .rms_curvature = {1.13e9, 0.0},
                                                 .short_wavevector = {1.6e10}};
    EXPECT_FALSE(has(run_study(study, {1}).surfaces[0].alerts, "STEEP_SLOPES"));
}

TEST(PublishedMoments, HaveErrorsCorrelatedThroughOneSpectrum) {
    auto study = ncd_against(1e6);
    // UNCD of Dalvi et al. 2019: slope + 1 standard error needs H > 1
    study.surfaces[0].moments = PublishedMoments{.rms_height = {23.4e-9, 1.3e-9, "given"},
                                                 .rms_slope = {1.46, 0.36, "given"},
                                                 .rms_curvature = {3.37e9, 0.69e9, "given"},
                                                 .short_wavevector = {1.6e10}};
    const auto surface = analyse_surface(study.surfaces[0], study.analysis, {1});
    const auto& spread = surface.average.spread;
    EXPECT_TRUE(spread.sources.empty());
    ASSERT_GT(spread.replicas.size(), 30U);
    for (const auto& p : spread.replicas) EXPECT_GT(p.elastic_energy_per_modulus, 0.0);
    using roughness::SpectralParameters;
    const auto slope = [](const SpectralParameters& p) { return std::log(p.rms_slope); };
    const auto curvature = [](const SpectralParameters& p) { return std::log(p.rms_curvature); };
    EXPECT_GT(spread.covariance(slope, curvature), 0.0);  // independent errors have none
    EXPECT_EQ(surface.average.estimate([](const SpectralParameters& p) { return p.elastic_energy_per_modulus; }).method,
              "admissible spectra on ln");
}

}  // namespace
}  // namespace setae::study::alerts_test
