// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <map>

#include "setae/adhesion/balance_comparison.hpp"
#include "setae/contact/elasticity.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/output/json.hpp"
#include "setae/roughness/true_area.hpp"
#include "setae/spectra/self_affine.hpp"
#include "setae/study/study_result.hpp"

namespace setae::numbers_test {
namespace {

const study::StudyResult& published() {
    static const auto result = study::run_study(study::read_study("examples/nanodiamond/published.toml"));
    return result;
}

study::StudyResult published_with_short_wavevector(double wavevector) {
    auto study = study::read_study("examples/nanodiamond/published.toml");
    for (auto& surface : study.surfaces) surface.moments->short_wavevector = {wavevector};
    return study::run_study(study);
}

struct Expected {
    const char* surface;
    double hurst, rolloff_um, energy_nm;
};

void expect_reconstructions(const study::StudyResult& result, double wavevector, const std::vector<Expected>& expected,
                            double energy_digit) {
    for (const auto& e : expected) {
        const auto& moments = *result.study.surface(e.surface)->moments;
        const auto model = spectra::self_affine_with_moments(moments.rms_height.value, moments.rms_slope.value,
                                                             moments.rms_curvature.value, wavevector);
        EXPECT_NEAR(model.hurst_exponent, e.hurst, 5e-4) << e.surface;
        if (e.rolloff_um > 0.0) {
            EXPECT_NEAR(2e6 * pi / model.rolloff_wavevector, e.rolloff_um, 5e-3) << e.surface;
        }
        EXPECT_NEAR(1e9 * result.surface(e.surface).used().parameters.elastic_energy_per_modulus, e.energy_nm,
                    energy_digit)
            << e.surface;
    }
}

TEST(PublishedTables, ContactModuliOnDiamondMatch) {
    const std::vector<std::pair<double, double>> expected{
        {0.69e6, 0.91999923e6}, {1.03e6, 1.37333162e6}, {1.91e6, 2.54666079e6}, {10.03e6, 13.37317133e6}};
    for (const auto& [E, contact_modulus] : expected)
        EXPECT_NEAR(contact::contact_modulus({E, 0.5}, {1100e9, 0.06}), contact_modulus, 0.005) << E;
}

TEST(PublishedTables, TrueAreaRatiosMatch) {
    const std::map<std::string, double> expected{
        {"PUNCD", 1.07125}, {"UNCD", 1.68822}, {"NCD", 1.47496}, {"MCD", 1.42306}};
    for (const auto& [surface, ratio] : expected)
        EXPECT_NEAR(published().surface(surface).area_ratio(), ratio, 5e-6) << surface;
}

TEST(PublishedTables, SurfacesKeepTheirThreeMoments) {
    for (const auto& surface : published().surfaces) {
        const auto& moments = *published().study.surface(surface.name)->moments;
        EXPECT_NEAR(surface.used().parameters.rms_height / moments.rms_height.value, 1.0, 1e-6);
        EXPECT_NEAR(surface.used().parameters.rms_slope / moments.rms_slope.value, 1.0, 1e-9);
        EXPECT_NEAR(surface.used().parameters.rms_curvature / moments.rms_curvature.value, 1.0, 1e-9);
    }
}

TEST(PublishedTables, ReconstructionWithTheCutoffOfThePaperMatches) {
    expect_reconstructions(published(), 1.6e10,
                           {{"PUNCD", 0.883, 0.287, 0.177},
                            {"UNCD", 0.977, 0.282, 4.16},
                            {"NCD", 0.879, 3.76, 9.57},
                            {"MCD", 0.896, 3.81, 9.97}},
                           5.1e-3);
    EXPECT_NEAR(1e9 * published().surface("PUNCD").used().parameters.elastic_energy_per_modulus, 0.177, 5e-4);
}

TEST(PublishedTables, ReconstructionToFourAngstromMatches) {
    const double wavevector = 2.0 * pi / 4e-10;
    const auto result = published_with_short_wavevector(wavevector);
    expect_reconstructions(result, wavevector,
                           {{"PUNCD", 0.874, 0.0, 0.173},
                            {"UNCD", 0.971, 0.0, 4.10},
                            {"NCD", 0.872, 0.0, 9.24},
                            {"MCD", 0.890, 0.0, 9.66}},
                           5.1e-3);
    EXPECT_NEAR(1e3 * result.modified->work_of_adhesion.value, 36.9, 0.05);
    EXPECT_NEAR(result.modified->r_squared, 0.503, 5e-4);
    EXPECT_NEAR(1e3 * result.persson_tosatti->work_of_adhesion.value, 25.6, 0.05);
}

TEST(PublishedTables, FitOfTheFullContactBalanceMatches) {
    const auto& fit = *published().modified;
    EXPECT_NEAR(1e3 * fit.work_of_adhesion.value, 37.1, 0.05);
    EXPECT_NEAR(fit.r_squared, 0.51, 5e-3);
    EXPECT_EQ(fit.degrees_of_freedom, 15);
    EXPECT_NEAR(fit.weighted->chi_squared, 680.0, 1.0);
    ASSERT_TRUE(fit.likelihood && fit.likelihood->interval);
    EXPECT_LT(fit.likelihood->interval->lower, 0.037);
    EXPECT_GT(fit.likelihood->interval->upper, 0.037);
}

TEST(PublishedTables, FitOfPerssonTosattiBalanceMatches) {
    EXPECT_NEAR(1e3 * published().persson_tosatti->work_of_adhesion.value, 25.75, 5e-3);
}

TEST(PublishedTables, FreeEnergiesGiveTheBestPossibleFit) {
    EXPECT_NEAR(1e3 * published().free_energies->work_of_adhesion, 37.67, 5e-3);
    EXPECT_NEAR(published().free_energies->r_squared, 0.733, 5e-4);
}

/// Pairs of one balance of energies free for each surface.
adhesion::FreeEnergyFit free_energies_with(double (*area_ratio)(double), double surface_energy) {
    std::vector<adhesion::FreeEnergyPoint> points;
    for (const auto& pair : published().pairs) {
        const double r = area_ratio(published().surface(pair.surface).used().parameters.rms_slope);
        points.push_back({.pair = {.surface = pair.surface,
                                   .measured = *pair.approach,
                                   .slope = r,
                                   .offset = surface_energy * (r - 1.0)},
                          .contact_modulus = published().elastomer(pair.elastomer).contact_modulus.value});
    }
    return adhesion::fit_with_free_energies(points);
}

// R² of (S13) is 0.13 and the paper's 0.29, as that of (7) is 0.51 and the paper's 0.67. No stored energies at all give
// more than 0.33 with the slopes of Table S1, and 0.73: the paper's are under its bound both times, so that its own
// spectra, which it does not print, make the difference.
TEST(PublishedTables, PerssonTosattiIsBelowTheBoundOfAnySpectrum) {
    EXPECT_NEAR(published().persson_tosatti->r_squared, 0.133, 5e-4);
    const auto best = free_energies_with([](double slope) { return 1.0 + 0.5 * slope * slope; }, 0.0);
    EXPECT_NEAR(best.r_squared, 0.335, 1e-3);
    EXPECT_GT(best.r_squared, 0.29);
    EXPECT_NEAR(free_energies_with(roughness::gaussian_area_ratio, 0.025).r_squared,
                published().free_energies->r_squared, 1e-12);
}

// Of the sixteen pairs: ln L and leave-one-surface-out residuals support Eq. 7, not Eq. S13, by 4.6 in ln L; with waves
// shorter than 100 nm excluded the two agree.
TEST(PublishedTables, ComparisonOfBalancesMatches) {
    const auto find = [&](const std::string& balance, double cut) {
        for (const auto& b : published().balances)
            if (b.balance == balance && b.shortest_wavelength == cut && b.surface_energy_factor == 1.0) return b.score;
        throw InternalError("no such row");
    };
    EXPECT_NEAR(find("modified", 0.0).log_likelihood - find("persson_tosatti", 0.0).log_likelihood, 4.56, 5e-3);
    EXPECT_NEAR(find("modified", 0.0).left_out_deviation, 0.01141, 1e-5);
    EXPECT_NEAR(find("persson_tosatti", 0.0).left_out_deviation, 0.01603, 1e-5);
    EXPECT_NEAR(find("modified", 1e-7).r_squared, 0.616, 5e-4);
    EXPECT_NEAR(find("persson_tosatti", 1e-7).r_squared, 0.588, 5e-4);
    const auto& interface = *published().strained_interface;
    EXPECT_LT(std::abs(interface.interface_change.value), 2.0 * interface.interface_change.standard_error);
}

TEST(PublishedTables, ReconstructionFloorsThreePairsAtTenMegapascal) {
    int floored = 0;
    for (const auto& pair : published().pairs)
        if (!pair.modified->work.conforms) {
            EXPECT_EQ(pair.elastomer, "E10");
            EXPECT_NE(pair.surface, "PUNCD");
            ++floored;
        }
    EXPECT_EQ(floored, 3);
}

TEST(PublishedTables, LossOfTheSmoothSphereMatches) {
    const std::map<std::string, double> expected{{"E0.7", 0.46}, {"E1.0", 0.31}, {"E1.9", 0.23}, {"E10", 0.12}};
    ASSERT_EQ(published().references.size(), 4u);
    for (const auto& reference : published().references)
        EXPECT_NEAR(1e9 * *reference.ideal_loss, expected.at(reference.elastomer), 5e-3) << reference.elastomer;
}

TEST(PublishedTables, LoopFitIsNullWithAReason) {
    const auto json = output::to_json(published());
    EXPECT_TRUE(json["fits"]["loop"].is_null());
    EXPECT_FALSE(json["fits"]["loop_reason"].get<std::string>().empty());
    EXPECT_NEAR(json["fits"]["modified"]["work_of_adhesion"]["value"].get<double>(), 0.0371, 5e-5);
    EXPECT_EQ(json["fits"]["modified"]["work_of_adhesion"]["unit"], "J/m2");
    EXPECT_EQ(json["pairs"].size(), 16u);
}

TEST(PublishedTables, CutoffAtTheContactSizeHasAlmostNoEffect) {
    // THEORY §2: U_el 1.3·10⁻⁵, h_rms 0.04 %, which is MCD reconstructed up to 2π/4 Å (up to 1.6·10¹⁰: 1.15·10⁻⁵, 0.034
    // %)
    const auto whole = published_with_short_wavevector(2.0 * pi / 4e-10);
    auto study = whole.study;
    study.analysis.longest_wavelength = Estimate{.value = 100e-6};
    const auto cut = study::run_study(study);
    const auto &all = whole.surface("MCD").used().parameters, &rest = cut.surface("MCD").used().parameters;
    EXPECT_NEAR(1.0 - rest.elastic_energy_per_modulus / all.elastic_energy_per_modulus, 1.3e-5, 5e-7);
    EXPECT_NEAR(1.0 - rest.rms_height / all.rms_height, 4e-4, 5e-5);
}

TEST(PublishedTables, GiveTheSameBytesOnOneAndThreeThreads) {
    const auto study = study::read_study("examples/nanodiamond/published.toml");
    EXPECT_EQ(output::to_json(study::run_study(study, {1})).dump(),
              output::to_json(study::run_study(study, {3})).dump());
}

TEST(LaterNcdModel, HasItsPublishedMoments) {
    const spectra::SelfAffine model{5.000e-27, 2.0 * pi / 2.000e-6, 0.8, 2.0 * pi / 72.2e-9};
    EXPECT_NEAR(1e9 * spectra::rms_height(model), 93.9, 0.05);
    EXPECT_NEAR(spectra::rms_slope(model), 0.7465, 5e-5);
    EXPECT_NEAR(1e-6 * spectra::rms_curvature(model), 15.19, 5e-3);
    EXPECT_NEAR(spectra::moment(model, 1.0) / (2.0 * pi), 4.374e-8, 5e-12);
}

}  // namespace
}  // namespace setae::numbers_test
