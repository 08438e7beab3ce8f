// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/texture/profile_parameters.hpp"
#include "texture/profile_parts.hpp"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "samples.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::texture::profile_parameters_test {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

/// n points of A sin(2π x/λ + phase), a step apart.
LineScan sine(Index n, double step, double wavelength, double amplitude, double phase = 0.3) {
    const Array1D x = Array1D::LinSpaced(n, 0.0, static_cast<double>(n - 1)) * step;
    return {(x * (2.0 * pi / wavelength) + phase).sin() * amplitude, static_cast<double>(n) * step, false, {}};
}

std::map<std::string, TextureParameter> by_symbol(const std::vector<TextureParameter>& rows) {
    std::map<std::string, TextureParameter> map;
    for (const auto& row : rows) map[row.quantity.symbol] = row;
    return map;
}

double value(const std::map<std::string, TextureParameter>& rows, const std::string& symbol) {
    return rows.at(symbol).quantity.estimate.value;
}

TEST(ProfileParameters, OfASineMatchClosedForms) {
    const double A = 2e-6, wavelength = 50e-6, step = 0.5e-6;
    auto scan = sine(8000, step, wavelength, A);
    scan.periodic = true;  // 80 waves
    const auto rows = by_symbol(profile_parameters(scan, {.section_length = 0.8e-3}));
    EXPECT_NEAR(value(rows, "Ra") / A, 2.0 / pi, 1e-3);
    EXPECT_NEAR(value(rows, "Rq") / A, std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(value(rows, "Rsk"), 0.0, 1e-10);
    EXPECT_NEAR(value(rows, "Rku"), 1.5, 1e-10);
    EXPECT_NEAR(value(rows, "Rz") / A, 2.0, 1e-3);
    EXPECT_NEAR(value(rows, "Rt") / A, 2.0, 1e-3);
    EXPECT_NEAR(value(rows, "Rp") / A, 1.0, 1e-3);
    EXPECT_NEAR(value(rows, "Rv") / A, 1.0, 1e-3);
    EXPECT_NEAR(value(rows, "RSm") / wavelength, 1.0, 1e-5);
    EXPECT_NEAR(value(rows, "RSmq") / wavelength, 0.0, 1e-3);
    EXPECT_NEAR(value(rows, "Rc") / A, 2.0, 1e-3);
    const double q = 2.0 * pi / wavelength, phase = q * step;
    EXPECT_NEAR(value(rows, "Rdq"),
                A / std::sqrt(2.0) * (45.0 * std::sin(phase) - 9.0 * std::sin(2.0 * phase) + std::sin(3.0 * phase)) /
                    (30.0 * step),
                2e-6 * A * q);
    EXPECT_NEAR(value(rows, "Rdq") / (A * q), std::sqrt(0.5), 1e-5);
    EXPECT_NEAR(value(rows, "Rda") / (A * q), 2.0 / pi, 1e-3);
    EXPECT_NEAR(value(rows, "Rdt") / (A * q), 1.0, 1e-3);
    EXPECT_NEAR(value(rows, "Ral"), std::acos(0.2) / q, 1e-5 / q);
    EXPECT_NEAR(value(rows, "Rmr(c)"), 0.5, 1e-6);
    EXPECT_NEAR(value(rows, "Rmc(p)") / A, 0.0, 1e-5);
}

TEST(ProfileParameters, OfATrianglePolylineAreExact) {
    Profile profile{Array1D(9), Array1D(9), {}};
    for (Index k = 0; k < 9; ++k) {
        profile.positions[k] = 1e-6 * static_cast<double>(k);
        profile.heights[k] = (k % 4 == 1 ? 1.0 : k % 4 == 3 ? -1.0 : 0.0) * 1e-7;
    }
    const auto rows = by_symbol(profile_parameters(profile));
    EXPECT_NEAR(value(rows, "Ra"), 0.5e-7, 1e-20);
    EXPECT_NEAR(value(rows, "Rq"), 1e-7 / std::sqrt(3.0), 1e-20);
    EXPECT_NEAR(value(rows, "Rku"), 1.8, 1e-12);
    EXPECT_NEAR(value(rows, "Rdq"), 0.1, 1e-14);
    EXPECT_NEAR(value(rows, "Rda"), 0.1, 1e-14);
    EXPECT_NEAR(value(rows, "Rdt"), 0.1, 1e-14);
    EXPECT_NEAR(value(rows, "Rdr"), std::sqrt(1.01) - 1.0, 1e-14);
    EXPECT_NEAR(value(rows, "Rdl"), 8e-6 * std::sqrt(1.01), 1e-18);
    EXPECT_NEAR(value(rows, "Rvmc"), 1e-7 * 0.63, 1e-12 * 1e-7 + 1e-15);
    EXPECT_EQ(rows.at("Ral").quantity.alerts.front().code, "RAL_UNDEFINED");
    EXPECT_NEAR(value(rows, "Rt"), 2e-7, 1e-20);
    EXPECT_NEAR(value(rows, "Rk"), 2e-7, 1e-15);
    EXPECT_NEAR(value(rows, "RSm"), 4e-6, 1e-18);
}

TEST(ProfileElements, IgnoreSmallWavesAtTheMeanLine) {
    // a strong wave with a weak fast one: without discrimination every wiggle near the mean line is an element
    auto scan = sine(4000, 1.0, 400.0, 1.0, 0.0);
    scan.heights += sine(4000, 1.0, 13.0, 0.05, 1.0).heights;
    EXPECT_NEAR(profile_elements(scan, 0.2, 10.0, 0.0).RSm, 400.0, 2.0);
    EXPECT_LT(profile_elements(scan, 0.0, 0.0, 0.0).RSm, 350.0);
    EXPECT_NEAR(profile_elements(scan, 0.2, 10.0, 0.0).Rc, 2.1, 0.05);
}

TEST(ProfileElements, AreEmptyWithoutMeanLineCrossings) {
    const LineScan ramp{Array1D::LinSpaced(10, 1.0, 2.0), 10.0};
    const auto none = profile_elements(ramp, 0.1, 0.1, 0.0);
    EXPECT_EQ(none.elements, 0);
    EXPECT_TRUE(std::isnan(none.RSm));
}

TEST(ProfileElements, RequireEveryHeightAndALine) {
    LineScan scan = sine(100, 1.0, 10.0, 1.0);
    scan.heights[5] = undefined;
    EXPECT_THROW((void)profile_elements(scan, 0.1, 0.1, 0.0), UndefinedDataError);
    EXPECT_THROW((void)profile_elements(HeightMap{tests::random_map(4, 4), {1.0, 1.0}}, 0.1, 0.1, 0.0),
                 InvalidArgument);
}

TEST(Sections, GiveMeansOfExtremesPerSection) {
    LineScan scan{Array1D::Zero(40), 40.0};
    for (Index k = 0; k < 4; ++k) {
        scan.heights[10 * k + 3] = 1.0 + static_cast<double>(k);
        scan.heights[10 * k + 7] = -2.0;
    }
    ProfileOptions options{.section_length = 10.0, .mean_line = MeanLine::zero};
    const auto rows = by_symbol(profile_parameters(scan, options));
    EXPECT_NEAR(value(rows, "Rp"), 2.5, 1e-15);
    EXPECT_NEAR(value(rows, "Rv"), 2.0, 1e-15);
    EXPECT_NEAR(value(rows, "Rz"), 4.5, 1e-15);
    EXPECT_NEAR(value(rows, "Rzx"), 6.0, 1e-15);
    EXPECT_NEAR(value(rows, "Rt"), 6.0, 1e-15);
    EXPECT_NEAR(rows.at("Rp").quantity.estimate.standard_error, std::sqrt(5.0 / 12.0), 1e-14);
    EXPECT_EQ(rows.at("Rp").quantity.estimate.method, "sections");
}

TEST(Sections, FitTheLengthToOnePercentAndRefuseTooLongSections) {
    const auto scan = sine(6664, 1.5e-6, 4e-4, 1e-6);
    EXPECT_EQ(sections(scan, 2.5e-3).size(), 4u);
    EXPECT_EQ(std::get<LineScan>(sections(scan, 2.5e-3)[3]).heights.size(), 1666);
    EXPECT_THROW((void)sections(scan, 0.02), InvalidArgument);
    EXPECT_THROW((void)sections(scan, 0.0), InvalidArgument);
    const auto polyline = tests::random_profile(100);
    const auto parts = sections(polyline, polyline.size() / 3.0);
    ASSERT_EQ(parts.size(), 3u);
    EXPECT_NEAR(std::get<Profile>(parts[1]).positions[0], std::get<Profile>(parts[0]).positions.tail(1)[0], 1e-12);
}

TEST(ProfileSlopes, OfAStraightLineAreItsSlope) {
    const auto slopes = profile_slopes(LineScan{Array1D::LinSpaced(20, 3.0, 22.0) * 0.1, 40.0});
    EXPECT_NEAR(slopes.Rdq, 0.05, 1e-14);
    EXPECT_NEAR(slopes.Rda, 0.05, 1e-14);
    EXPECT_NEAR(slopes.Rdq_2, 0.05, 1e-14);
    EXPECT_TRUE(std::isnan(profile_slopes(LineScan{Array1D::Zero(6), 6.0}).Rdq));
}

TEST(ProfileSlopes, WrapInPeriodicLinesAndSkipHoles) {
    auto scan = sine(64, 1.0, 64.0 / 3.0, 1.0);
    scan.periodic = true;
    const double phase = 2.0 * pi * 3.0 / 64.0;
    EXPECT_NEAR(profile_slopes(scan).Rdq_2, std::sqrt(2.0) * std::sin(0.5 * phase), 1e-13);
    EXPECT_NEAR(profile_slopes(scan).Rdq,
                std::sqrt(0.5) * (45.0 * std::sin(phase) - 9.0 * std::sin(2.0 * phase) + std::sin(3.0 * phase)) / 30.0,
                1e-13);
    scan.heights[10] = undefined;
    EXPECT_TRUE(std::isfinite(profile_slopes(scan).Rdq));
}

TEST(ProfileParameters, FiltersSeparateRoughnessFromWaviness) {
    auto scan = sine(8000, 1e-6, 4e-3, 5e-6);  // waviness
    scan.heights += sine(8000, 1e-6, 40e-6, 1e-6).heights;
    const Filters filters{.l_filter = 0.4e-3};
    const auto R = by_symbol(profile_parameters(scan, {.filters = filters}));
    const auto W = by_symbol(
        profile_parameters(scan, {.kind = ProfileKind::waviness, .filters = filters, .section_length = 8e-3}));
    const auto P = by_symbol(profile_parameters(scan, {.kind = ProfileKind::primary, .section_length = 8e-3}));
    EXPECT_NEAR(value(R, "Rq"), 1e-6 / std::sqrt(2.0),
                0.02e-6);  // the wave passes with 2^−(0.4/4)² = 0.7 %: 25 nm of rms in addition to 707
    EXPECT_NEAR(value(W, "Wq"), 5e-6 / std::sqrt(2.0), 0.05e-6);
    EXPECT_NEAR(value(P, "Pq"), std::sqrt(13.0) * 1e-6, 0.01e-6);
    EXPECT_EQ(R.at("Rq").filter, "Gaussian L-filter 400 µm");
    EXPECT_NEAR(R.at("Rq").quantity.band->lower, 2.0 * pi / 0.4e-3, 1e-9);
    EXPECT_NEAR(W.at("Wq").quantity.band->upper, 2.0 * pi / 0.4e-3, 1e-9);
    EXPECT_EQ(P.at("Pq").filter, "none");
}

TEST(ProfileParameters, RefuseInvalidOptions) {
    const auto scan = sine(1000, 1e-6, 4e-5, 5e-6);
    EXPECT_THROW((void)profile_parameters(HeightMap{tests::random_map(4, 4), {1.0, 1.0}}), InvalidArgument);
    EXPECT_THROW((void)profile_parameters(tests::random_profile(50), {.filters = {.l_filter = 5.0}}), InvalidArgument);
    EXPECT_THROW((void)profile_parameters(scan, {.kind = ProfileKind::waviness}), InvalidArgument);
    EXPECT_THROW((void)profile_parameters(scan, {.filters = {.s_filter = 1e-4, .l_filter = 1e-5}}), InvalidArgument);
    EXPECT_THROW((void)profile_parameters(scan, {.filters = {.s_filter = -1.0}}), InvalidArgument);
    Profile back{Array1D(3), Array1D::Zero(3), {}};
    back.positions << 0.0, 2.0, 1.0;
    EXPECT_THROW((void)profile_parameters(back), InvalidArgument);
}

TEST(ProfileParameters, WithHolesHaveNoElementsAndGiveAWarning) {
    auto scan = sine(1000, 1e-6, 4e-5, 5e-6);
    scan.heights.segment(100, 50).setConstant(undefined);
    const auto rows = by_symbol(profile_parameters(scan));
    EXPECT_TRUE(std::isnan(value(rows, "RSm")));
    EXPECT_FALSE(rows.at("Rq").ok());
    EXPECT_EQ(rows.at("Rq").quantity.alerts.front().code, "UNDEF");
    EXPECT_EQ(*rows.at("Rq").quantity.n, 950);
}

TEST(DefaultSetting, FollowsTheTableOfTheStandard) {
    EXPECT_EQ(default_setting(0.05e-6).section_length, 0.25e-3);
    EXPECT_EQ(default_setting(1e-6).section_length, 0.8e-3);
    EXPECT_EQ(default_setting(1e-6).s_filter, 2.5e-6);
    EXPECT_EQ(default_setting(3.3e-6).section_length, 2.5e-3);  // as the SurfTest of tests/reference/texture was set
    EXPECT_EQ(default_setting(3.3e-6).s_filter, 8e-6);
    EXPECT_EQ(default_setting(50e-6).section_length, 8e-3);
    EXPECT_THROW((void)default_setting(-1.0), InvalidArgument);
}

TEST(DefaultSetting, OfALineFollowsFromItsRoughness) {
    auto fine = sine(10000, 1e-6, 30e-6, 0.05e-6);  // Ra = 32 nm: 0.25 mm
    EXPECT_EQ(default_setting(fine).section_length, 0.25e-3);
    fine.heights += sine(10000, 1e-6, 9e-3, 5e-6).heights;  // waviness has no effect
    EXPECT_EQ(default_setting(fine).section_length, 0.25e-3);
    EXPECT_EQ(default_setting(sine(10000, 1e-6, 100e-6, 5e-6)).section_length, 2.5e-3);
    EXPECT_EQ(default_setting(sine(1000, 1e-6, 100e-6, 5e-6)).section_length, 0.8e-3);  // 2.5 mm do not fit into 1 mm
    EXPECT_THROW((void)default_setting(sine(50, 1e-6, 10e-6, 1e-6)), InvalidArgument);
    EXPECT_THROW((void)default_setting(tests::random_profile(50)), InvalidArgument);
}

TEST(ProfileParameters, ChosenEqualThoseOfTheFullList) {
    const topography::LineScan line{tests::random_map(300, 1).col(0), 3.0};
    const auto all = profile_parameters(line, {.kind = ProfileKind::primary});
    for (const auto& expected : all) {
        const auto only = chosen_parameters(expected.quantity.symbol, Standard::iso21920, 'P');
        const auto found = profile_parameters(line, {.kind = ProfileKind::primary, .only = only});
        ASSERT_EQ(found.size(), 1u) << expected.quantity.symbol;
        EXPECT_EQ(found[0].quantity.symbol, expected.quantity.symbol);
        const double value = found[0].quantity.estimate.value, whole = expected.quantity.estimate.value;
        EXPECT_TRUE(value == whole || (std::isnan(value) && std::isnan(whole))) << expected.quantity.symbol;
    }
}

}  // namespace
}  // namespace setae::texture::profile_parameters_test
