// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and their origins: README.md.
#include "setae/statistics/mixed_model.hpp"

#include <cmath>
#include <fstream>
#include <numeric>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "setae/core/constants.hpp"

namespace mixed_model_test {

using namespace setae;
using namespace setae::statistics;

constexpr const char* folder = "tests/reference/statistics/";

nlohmann::json case_named(const std::string& name) {
    std::ifstream file(std::string(folder) + "expected.json");
    return nlohmann::json::parse(file).at(name);
}

ReplicateData data_of(const nlohmann::json& rows) {
    ReplicateData data;
    for (const auto& row : rows)
        data.rows.push_back({row[3], row[4].is_null() ? undefined : row[4].get<double>(), {row[0], row[1], row[2]}});
    return data;
}

void expect_case(const std::string& name, double tolerance) {
    const auto expected = case_named(name);
    const auto model = mixed_model(data_of(expected["rows"]), {.influence = false});
    ASSERT_EQ(model.fits.size(), 1U);
    EXPECT_TRUE(model.fits[0].converged);
    ASSERT_EQ(model.fits[0].components.size(), expected["variances"].size());
    for (std::size_t k = 0; k < expected["variances"].size(); ++k)
        EXPECT_NEAR(model.fits[0].components[k].variance / expected["variances"][k].get<double>(), 1.0, tolerance)
            << name << " " << k;
    for (std::size_t s = 0; s < expected["means"].size(); ++s) {
        EXPECT_NEAR(model.surfaces[s].mean.value / expected["means"][s].get<double>(), 1.0, 0.1 * tolerance) << name;
        if (expected.contains("standard_errors")) {
            EXPECT_NEAR(model.surfaces[s].mean.standard_error / expected["standard_errors"][s].get<double>(), 1.0,
                        tolerance)
                << name;
        }
    }
}

ReplicateData batches(const std::vector<std::vector<double>>& yields) {
    ReplicateData data{.levels = {"product", "batch"}};
    for (std::size_t b = 0; b < yields.size(); ++b)
        for (const double yield : yields[b]) data.rows.push_back({yield, undefined, {"dyestuff", std::to_string(b)}});
    return data;
}

/// Rounded as published.
double rounded(double value, int digits) { return std::round(value * std::pow(10.0, digits)) / std::pow(10.0, digits); }

TEST(MixedModelReference, UnbalancedNestedValuesAgreeWithStatsmodels) { expect_case("statsmodels", 3e-3); }

TEST(MixedModelReference, UnequalStandardErrorsAgreeWithDenseMatrices) { expect_case("dense", 1e-5); }

TEST(MixedModelReference, OneVarianceWithUnequalStandardErrorsAgreesWithPymare) { expect_case("pymare", 1e-6); }

TEST(MixedModelReference, DistrictsAndSchoolsAgreeWithMetafor) {
    std::ifstream file(std::string(folder) + "konstantopoulos2011.txt");
    ReplicateData schools{.levels = {"all", "district"}};
    std::string district, school;
    double value = 0.0, variance = 0.0;
    while (file >> district >> school >> value >> variance)
        schools.rows.push_back({value, std::sqrt(variance), {"all", district}});
    ASSERT_EQ(schools.rows.size(), 56U);
    const auto model = mixed_model(schools, {.influence = false});
    const auto& components = model.fits[0].components;
    ASSERT_EQ(components.size(), 2U);
    EXPECT_DOUBLE_EQ(rounded(model.surfaces[0].mean.value, 3), 0.185);
    EXPECT_DOUBLE_EQ(rounded(model.surfaces[0].mean.standard_error, 3), 0.085);
    EXPECT_DOUBLE_EQ(rounded(components[0].variance, 3), 0.065);
    EXPECT_DOUBLE_EQ(rounded(components[1].variance, 3), 0.033);
    EXPECT_DOUBLE_EQ(rounded(components[0].variance / (components[0].variance + components[1].variance), 3), 0.665);
    // metafor's likelihood keeps the constants: −(n − 1)/2 ln 2π + ½ ln n
    EXPECT_DOUBLE_EQ(rounded(model.fits[0].log_likelihood - 27.5 * std::log(2.0 * pi) + 0.5 * std::log(56.0), 4),
                     -7.9587);

    for (auto& row : schools.rows) row.groups = {"all"};
    schools.levels = {"all"};
    const auto plain = mixed_model(schools, {.influence = false});
    EXPECT_DOUBLE_EQ(rounded(plain.surfaces[0].mean.value, 3), 0.128);
    EXPECT_DOUBLE_EQ(rounded(plain.surfaces[0].mean.standard_error, 3), 0.044);
    EXPECT_DOUBLE_EQ(rounded(plain.fits[0].components[0].variance, 3), 0.088);
    EXPECT_DOUBLE_EQ(rounded(plain.fits[0].components[0].standard_error, 3), 0.020);
}

TEST(MixedModelReference, DyestuffAgreesWithLme4) {
    const auto model = mixed_model(batches({{1545, 1440, 1440, 1520, 1580},
                                            {1540, 1555, 1490, 1560, 1495},
                                            {1595, 1550, 1605, 1510, 1560},
                                            {1445, 1440, 1595, 1465, 1545},
                                            {1595, 1630, 1515, 1635, 1625},
                                            {1520, 1455, 1450, 1480, 1445}}),
                                   {.influence = false});
    EXPECT_NEAR(model.surfaces[0].mean.value, 1527.5, 1e-9);
    EXPECT_DOUBLE_EQ(rounded(model.surfaces[0].mean.standard_error, 2), 19.38);
    EXPECT_DOUBLE_EQ(rounded(std::sqrt(model.fits[0].components[0].variance), 2), 42.00);
    EXPECT_DOUBLE_EQ(rounded(std::sqrt(model.fits[0].components[1].variance), 2), 49.51);
    EXPECT_NEAR(*model.surfaces[0].mean.degrees_of_freedom, 5.0, 1e-6);  // of six batches
}

TEST(MixedModelReference, Dyestuff2HasNoVarianceBetweenBatchesAsInLme4) {
    const auto model = mixed_model(batches({{7.298, 3.846, 2.434, 9.566, 7.990},
                                            {5.220, 6.556, 0.608, 11.788, -0.892},
                                            {0.110, 10.386, 13.434, 5.510, 8.166},
                                            {2.212, 4.852, 7.092, 9.288, 4.980},
                                            {0.282, 9.014, 4.458, 9.446, 7.198},
                                            {1.722, 4.782, 8.106, 0.758, 3.758}}),
                                   {.influence = false});
    EXPECT_TRUE(model.fits[0].components[0].at_bound);
    EXPECT_EQ(model.fits[0].components[0].variance, 0.0);
    EXPECT_DOUBLE_EQ(rounded(model.fits[0].components[1].variance, 2), 13.81);
    EXPECT_DOUBLE_EQ(rounded(model.surfaces[0].mean.value, 4), 5.6656);
    EXPECT_DOUBLE_EQ(rounded(model.surfaces[0].mean.standard_error, 4), 0.6784);
}

}  // namespace mixed_model_test
