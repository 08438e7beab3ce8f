// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact_line/line_roughness.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "lines.hpp"
#include "setae/core/errors.hpp"

namespace setae::contact_line::line_roughness_test {
namespace {

// true exponents are recovered with a standard error that covers the scatter of 24 records
TEST(LineRoughness, RecoversTrueExponents) {
    for (const double exponent : {0.35, 0.5, 0.7}) {
        const int records = 24;
        double sum = 0.0, squares = 0.0, deviates = 0.0;
        for (int record = 0; record < records; ++record) {
            // noise as strong as the line at mode 40 of 64
            const double noise = std::sqrt(256.0 * 1e-6 * std::pow(40.0, -1.0 - 2.0 * exponent));
            const auto line = rough_lines(12, 256, exponent, 1e-6, noise, 100 + static_cast<std::uint64_t>(record));
            const auto found = line_roughness(line).exponent;
            sum += found.value;
            squares += std::pow(found.value - exponent, 2);
            deviates += std::pow((found.value - exponent) / found.standard_error, 2);
        }
        const double scatter = std::sqrt(squares / records);
        EXPECT_NEAR(sum / records, exponent, 3.0 * scatter / std::sqrt(records));
        EXPECT_LT(scatter, 0.05);
        EXPECT_GT(std::sqrt(deviates / records), 0.7);
        EXPECT_LT(std::sqrt(deviates / records), 1.5);
    }
}

TEST(LineRoughness, UnstatedNoiseLowersTheExponent) {
    auto line = rough_lines(24, 256, 0.5, 1e-6, std::sqrt(256.0 * 1e-6 * std::pow(20.0, -2.0)), 7);
    const double right = line_roughness(line).exponent.value;
    line.place_error = 0.0;
    EXPECT_LT(line_roughness(line).exponent.value, right - 0.15);
}

TEST(LineRoughness, StructureFunctionIsTheMeanSquareOfDifferences) {
    const auto line = line_of(Array1D::LinSpaced(2, 0.0, 1.0), 30, [](double angle, double time) {
        return 1.0 + 0.1 * std::cos(angle) + 0.02 * std::cos(4.0 * angle + time) + 0.01 * std::sin(15.0 * angle + 0.3) +
               (1.0 + time) * 0.005 * std::sin(7.0 * angle);
    });
    const auto result = line_roughness(line, {3, 15});
    ASSERT_EQ(result.structure.size(), 15);
    for (Index k = 1; k <= 15; ++k) {
        double sum = 0.0;
        for (Index i = 0; i < 2; ++i)
            for (Index j = 0; j < 30; ++j) {
                const auto rest = [&](Index at) {
                    return line.radius(i, at % 30) - 0.1 * std::cos(2.0 * pi * static_cast<double>(at % 30) / 30.0);
                };
                sum += std::pow(rest(j + k) - rest(j), 2);
            }
        EXPECT_NEAR(result.structure[k - 1], std::sqrt(sum / 60.0), 1e-14);
    }
    EXPECT_NEAR(result.power[3], 0.25 * 0.02 * 0.02, 1e-16);  // |r_4|², half the amplitude each side
}

TEST(LineRoughness, WithoutRoughnessOrModesIsRefused) {
    auto line = rough_lines(4, 64, 0.5, 1e-6, 0.0, 3);
    EXPECT_THROW((void)line_roughness(line, {3, 33}), InvalidArgument);
    EXPECT_THROW((void)line_roughness(line, {3, 5}), InvalidArgument);
    EXPECT_THROW((void)line_roughness(line, {0, 9}), InvalidArgument);
    line.place_error = 1.0;
    EXPECT_THROW((void)line_roughness(line), UndefinedDataError);
}

}  // namespace
}  // namespace setae::contact_line::line_roughness_test
