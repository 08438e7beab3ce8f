// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/texture/areal_parameters.hpp"

#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "samples.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/roughness/true_area.hpp"
#include "setae/texture/profile_parameters.hpp"

namespace setae::texture::areal_parameters_test {
namespace {

using topography::HeightMap;

std::map<std::string, TextureParameter> by_symbol(const std::vector<TextureParameter>& rows) {
    std::map<std::string, TextureParameter> map;
    for (const auto& row : rows) map[row.quantity.symbol] = row;
    return map;
}

HeightMap crossed_waves(Index n, double size, double wavelength, double amplitude) {
    HeightMap map{Array2D(n, n), {size, size}};
    const Array1D wave = (Array1D::LinSpaced(n, 0.0, static_cast<double>(n - 1)) *
                          (size / static_cast<double>(n) * 2.0 * pi / wavelength))
                             .sin() *
                         amplitude;
    for (Index i = 0; i < n; ++i) map.heights.row(i) = wave.transpose() + wave[i];
    return map;
}

TEST(ArealParameters, CoverTheTableAndStateTheirBasis) {
    const auto map = crossed_waves(128, 1e-4, 1e-5, 1e-7);
    const auto rows = areal_parameters(map);
    std::set<std::string_view> symbols;
    for (const auto& row : rows) {
        symbols.insert(row.quantity.symbol);
        EXPECT_FALSE(row.quantity.unit.empty());
        ASSERT_TRUE(row.quantity.band.has_value()) << row.quantity.symbol;
        EXPECT_NEAR(row.quantity.band->lower, 2.0 * pi / 1e-4, 1.0);
        EXPECT_NEAR(row.quantity.band->upper, pi * 128 / 1e-4, 1e2);
        EXPECT_EQ(*row.quantity.n, 128 * 128);
        EXPECT_EQ(row.filter, "none");
        EXPECT_NE(row.quantity.source.find("ISO 25178-2"), std::string::npos);
    }
    for (const auto& definition : parameters())
        if (definition.standard == Standard::iso25178) {
            EXPECT_TRUE(symbols.contains(definition.symbol)) << definition.symbol;
        }
    const auto values = by_symbol(rows);
    EXPECT_NEAR(values.at("Sq").quantity.estimate.value, 1e-7, 1e-9);
    EXPECT_NEAR(values.at("Sku").quantity.estimate.value, 2.25, 0.01);
}

TEST(ArealParameters, ProfileParametersCoverTheirTable) {
    const topography::LineScan line{tests::random_heights(1000), 1000.0};
    std::set<std::string_view> symbols;
    const auto rows = profile_parameters(line);
    for (const auto& row : rows) symbols.insert(row.quantity.symbol);
    for (const auto& definition : parameters())
        if (definition.standard == Standard::iso21920) {
            EXPECT_TRUE(symbols.contains(definition.symbol)) << definition.symbol;
        }
}

TEST(ArealParameters, FiltersKeepTheWavesBetweenTheirCutoffs) {
    auto map = crossed_waves(256, 256e-6, 16e-6, 1e-7);
    map.heights += crossed_waves(256, 256e-6, 256e-6, 1e-6).heights;
    const auto rows = by_symbol(areal_parameters(map, {.filters = {.s_filter = 2e-6, .l_filter = 50e-6}}));
    const auto& Sq = rows.at("Sq");
    EXPECT_NEAR(Sq.quantity.estimate.value, 1e-7, 0.15e-7);
    EXPECT_EQ(Sq.filter, "Gaussian S-filter 2 µm, Gaussian L-filter 50 µm");
    EXPECT_NEAR(Sq.quantity.band->lower, 2.0 * pi / 50e-6, 1e-6);
    EXPECT_NEAR(Sq.quantity.band->upper, 2.0 * pi / 2e-6, 1.0);
}

TEST(ArealParameters, StandardErrorsCoverTheScatterOfGaussianMaps) {
    // white noise smoothed over a few pixels: the error from the autocorrelation of one map compared with the spread
    // over many maps
    std::vector<double> values;
    double error = 0.0;
    constexpr int maps = 40;
    for (unsigned seed = 1; seed <= maps; ++seed) {
        HeightMap map{Array2D::Zero(32, 32), {32.0, 32.0}, true, {}};
        const Array2D noise = tests::random_map(32, 32, seed);
        for (Index i = 0; i < 32; ++i)
            for (Index j = 0; j < 32; ++j)
                for (Index k = -2; k <= 2; ++k)
                    for (Index m = -2; m <= 2; ++m)
                        map.heights(i, j) += 0.2 * noise((i + k + 32) % 32, (j + m + 32) % 32);
        const auto Sq = by_symbol(areal_parameters(map)).at("Sq").quantity.estimate;
        values.push_back(Sq.value);
        error += Sq.standard_error / maps;
    }
    const Eigen::Map<const Array1D> all(values.data(), maps);
    const double spread = std::sqrt((all - all.mean()).square().sum() / (maps - 1));
    EXPECT_NEAR(error / spread, 1.0, 0.3);  // the error of a spread of 40 is 11 %
}

TEST(ArealParameters, WarnOfAMapOfFewCorrelationLengths) {
    const auto rows = by_symbol(areal_parameters(crossed_waves(64, 1e-4, 0.8e-4, 1e-7)));
    ASSERT_FALSE(rows.at("Sq").ok());
    EXPECT_EQ(rows.at("Sq").quantity.alerts.front().code, "FEW_PATCHES");
    EXPECT_TRUE(rows.at("Sk").ok());
}

TEST(ArealParameters, OfAConstantMapReportUndefinedValues) {
    const auto rows = by_symbol(areal_parameters(HeightMap{Array2D::Constant(8, 8, 1e-6), {1.0, 1.0}}));
    EXPECT_EQ(rows.at("Sq").quantity.estimate.value, 0.0);
    for (const char* symbol : {"Ssk", "Sal", "Str", "Std"}) {
        EXPECT_TRUE(std::isnan(rows.at(symbol).quantity.estimate.value)) << symbol;
        EXPECT_FALSE(rows.at(symbol).ok()) << symbol;
    }
}

TEST(ArealParameters, OfTwoByTwoPointsAreDefinedWherePossible) {
    const auto rows =
        by_symbol(areal_parameters(HeightMap{(Array2D(2, 2) << 0, 1, 2, 4).finished() * 1e-9, {1e-6, 1e-6}}));
    EXPECT_GT(rows.at("Sq").quantity.estimate.value, 0.0);
    EXPECT_TRUE(std::isnan(rows.at("Sdq_c").quantity.estimate.value));
}

TEST(ArealParameters, WarnOfABluntTipWhereShortWavesContribute) {
    auto map = crossed_waves(128, 1e-6, 1e-7, 2e-8);
    map.metadata.instrument.tip_radius = 1e-6;
    const auto rows = by_symbol(areal_parameters(map));
    for (const char* symbol : {"Sdq", "Sdr", "Spc"}) {
        ASSERT_FALSE(rows.at(symbol).ok()) << symbol;
        EXPECT_EQ(rows.at(symbol).quantity.alerts.back().code, "TIP_CUTOFF");
    }
    EXPECT_TRUE(rows.at("Sz").ok());
    EXPECT_LT(rows.at("Sq").quantity.band->upper, 2.0 * pi / 2e-8);
}

TEST(ArealParameters, OfASmoothGaussianMapHaveTheAreaOfGaussianSlopes) {
    // many waves of one length in all directions: heights and slopes are nearly Gaussian, and Ssk = 0, Sku = 3, Sdr =
    // g(Sdq)
    HeightMap map{Array2D::Zero(256, 256), {256.0, 256.0}};
    constexpr int waves = 150;
    for (int k = 0; k < waves; ++k) {
        const double angle = pi * (k + 0.37) / waves, q = 0.12, phase = 2.399963 * k * k;
        const Array1D x = Array1D::LinSpaced(256, 0.0, 255.0) * (q * std::cos(angle)) + phase,
                      y = Array1D::LinSpaced(256, 0.0, 255.0) * (q * std::sin(angle));
        map.heights +=
            (x.cos().matrix() * y.cos().matrix().transpose() - x.sin().matrix() * y.sin().matrix().transpose()).array();
    }
    const auto rows = by_symbol(areal_parameters(map));
    const auto value = [&rows](const char* symbol) { return rows.at(symbol).quantity.estimate; };
    EXPECT_NEAR(value("Ssk").value, 0.0, 4.0 * value("Ssk").standard_error);
    EXPECT_NEAR(value("Sku").value, 3.0, 4.0 * value("Sku").standard_error);
    EXPECT_NEAR(value("Sa").value / value("Sq").value, std::sqrt(2.0 / pi), 0.02);
    EXPECT_NEAR((value("Sdr").value + 1.0) / roughness::gaussian_area_ratio(value("Sdq").value), 1.0, 0.02);
    EXPECT_NEAR(value("Sal").value, 1.79 / 0.12, 0.15 / 0.12);  // J0(q t) = 0.2 at q t = 1.79
}

TEST(ArealParameters, OfOneRowAreRefusedWithAReason) {
    try {
        (void)areal_parameters(HeightMap{tests::random_map(1, 20), {1.0, 20.0}});
        FAIL();
    } catch (const UndefinedDataError& error) {
        EXPECT_NE(std::string(error.what()).find("four defined corners"), std::string::npos);
    }
}

TEST(ArealParameters, AreUnaffectedByAnOffsetOfTenMillionRms) {
    auto map = crossed_waves(64, 1e-4, 2e-5, 1e-7);
    const auto plain = by_symbol(areal_parameters(map));
    map.heights += 1.0;
    const auto lifted = by_symbol(areal_parameters(map));
    for (const auto& [symbol, row] : plain) {
        const double expected = row.quantity.estimate.value;
        if (std::isnan(expected) || symbol == "Ssk" || symbol == "Smc(p)" || symbol == "Std")
            continue;  // zero, or without direction
        EXPECT_NEAR(lifted.at(symbol).quantity.estimate.value / expected, 1.0, 1e-4) << symbol;
    }
}

TEST(ArealParameters, RefuseALine) {
    EXPECT_THROW((void)areal_parameters(topography::LineScan{Array1D::Zero(5), 5.0}), InvalidArgument);
    EXPECT_THROW((void)parameter("Sqq"), InvalidArgument);
    EXPECT_EQ(parameter("Vmc").unit, "m");
}

TEST(ArealParameters, AreTheSameForAnyNumberOfThreads) {
    const HeightMap map{tests::random_map(100, 90), {1.0, 1.0}};
    const auto one = areal_parameters(map, {}, {1}), three = areal_parameters(map, {}, {3});
    for (std::size_t k = 0; k < one.size(); ++k)
        if (!std::isnan(one[k].quantity.estimate.value)) {
            EXPECT_EQ(one[k].quantity.estimate.value, three[k].quantity.estimate.value) << one[k].quantity.symbol;
        }
}

TEST(ArealParameters, ChosenEqualThoseOfTheFullList) {
    const topography::HeightMap map{tests::random_map(40, 50), {4.0, 5.0}};
    const auto all = areal_parameters(map);
    for (const auto& expected : all) {
        const auto found =
            areal_parameters(map, {.only = chosen_parameters(expected.quantity.symbol, Standard::iso25178)});
        ASSERT_EQ(found.size(), 1u) << expected.quantity.symbol;
        EXPECT_EQ(found[0].quantity.symbol, expected.quantity.symbol);
        EXPECT_EQ(found[0].quantity.estimate.value, expected.quantity.estimate.value) << expected.quantity.symbol;
        EXPECT_EQ(found[0].quantity.alerts, expected.quantity.alerts) << expected.quantity.symbol;
    }
}

TEST(ChosenParameters, AreFoundBySymbolOrName) {
    EXPECT_EQ(chosen_parameters("Sdr, root_mean_square_height", Standard::iso25178),
              (std::vector<std::string>{"Sdr", "Sq"}));
    EXPECT_EQ(chosen_parameters("Pq\tPk", Standard::iso21920, 'P'), (std::vector<std::string>{"Rq", "Rk"}));
    EXPECT_THROW((void)chosen_parameters("Rq", Standard::iso25178), InvalidArgument);
    EXPECT_THROW((void)chosen_parameters("Rq", Standard::iso21920, 'P'), InvalidArgument);
    EXPECT_THROW((void)chosen_parameters(" ,", Standard::iso25178), InvalidArgument);
}

}  // namespace
}  // namespace setae::texture::areal_parameters_test
