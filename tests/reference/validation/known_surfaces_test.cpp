// SPDX-License-Identifier: GPL-3.0-or-later
// Measurements simulated on known surfaces, analysed from their files: true values are recovered.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <unistd.h>

#include "setae/core/errors.hpp"
#include "setae/validation/report.hpp"
#include "setae/validation/validation.hpp"

namespace known_surfaces_test {

using namespace setae;
using namespace setae::validation;

Validation validation_with(ValidationOptions options, const std::string& name) {
    options.runs = 1;
    options.folder =
        (std::filesystem::temp_directory_path() / ("setae_validation_" + name + "_" + std::to_string(::getpid())))
            .string();
    const auto found = run_validation("tests/reference/validation/surfaces.toml", options);
    std::filesystem::remove_all(options.folder);
    EXPECT_TRUE(found.failed.empty()) << found.failed.front().reason;
    return found;
}

const Validation& complete() {
    static const auto found = validation_with({.threads = {1}}, "complete");
    return found;
}

std::vector<Comparison> only(const Validation& validation, const std::string& method) {
    std::vector<Comparison> rows;
    for (const auto& c : validation.comparisons)
        if (c.method == method) rows.push_back(c);
    return rows;
}

/// Σ (deviation/stated)² over the decades of C1D and the rms height, and how many they are.
struct Misfit {
    double chi_squared = 0.0;
    int count = 0;
};
Misfit misfit(const std::vector<Comparison>& rows,
              const std::vector<std::string>& quantities = {"rms_height", "C1D 1e5", "C1D 1e6", "C1D 1e7", "C1D 1e8",
                                                            "C1D 1e9"}) {
    Misfit found;
    for (const auto& c : rows) {
        if (std::find(quantities.begin(), quantities.end(), c.quantity) == quantities.end()) continue;
        found.chi_squared += std::pow(c.deviation() / c.stated_deviation(), 2);
        ++found.count;
    }
    return found;
}

TEST(KnownSurfaces, AreCoveredByIntervalsOfEveryQuantityAndDecade) {
    const auto rows = only(complete(), "likelihood");
    ASSERT_GE(rows.size(), 18u);
    int held = 0;
    for (const auto& c : rows) {
        EXPECT_LT(std::abs(c.deviation()), 3.5 * c.stated_deviation()) << c.item << " " << c.quantity;
        held += c.covered() ? 1 : 0;
    }
    EXPECT_GE(held, static_cast<int>(0.85 * static_cast<double>(rows.size())));
}

// The cutoff of tip-based data and the simulated tip are what makes the decades right: without either they are many
// standard deviations off.
TEST(KnownSurfaces, AreNotRecoveredWithoutCutoffAndTip) {
    const auto with = misfit(only(complete(), "likelihood"));
    const auto without_both = misfit(
        only(validation_with({.tip_factor = false, .tip_band = false, .threads = {2}}, "without"), "likelihood"));
    const std::vector<std::string> where_tips_end{"C1D 1e6", "C1D 1e8"};  // the stylus, the AFM
    const auto with_cutoff = misfit(only(complete(), "likelihood"), where_tips_end);
    const auto without_cutoff = misfit(
        only(validation_with({.tip_band = false, .threads = {2}}, "without_cutoff"), "likelihood"), where_tips_end);
    EXPECT_LT(with.chi_squared, 2.5 * with.count);
    EXPECT_GT(without_both.chi_squared, 20.0 * without_both.count);
    // what a tip adds is part of the model: beyond the cutoff it misleads less than a factor T did, which tripled this
    EXPECT_GT(without_cutoff.chi_squared, 1.5 * with_cutoff.chi_squared);
}

// THEORY §4.2: the paper's route reads slope and curvature low, segments between contour points doing most of it.
TEST(KnownSurfaces, AreNotRecoveredByTheMethodOfThePaper) {
    int curvatures = 0, slopes = 0;
    for (const auto& c : only(complete(), "paper")) {
        if (c.quantity == "rms_curvature") {
            EXPECT_NEAR(c.deviation(), -0.36, 0.08) << c.item;
            ++curvatures;
        } else if (c.quantity == "rms_slope") {
            EXPECT_NEAR(c.deviation(), -0.17, 0.08) << c.item;
            ++slopes;
        }
    }
    EXPECT_GE(curvatures, 2);
    EXPECT_EQ(slopes, curvatures);
}

TEST(KnownSurfaces, GiveTheSameBytesForAnyNumberOfThreads) {
    EXPECT_EQ(comparisons_csv(validation_with({.threads = {2}}, "threads").comparisons),
              comparisons_csv(complete().comparisons));
}

TEST(KnownSurfaces, RefuseInvalidOptions) {
    EXPECT_THROW((void)run_validation("tests/reference/validation/surfaces.toml", {.runs = 0}), InvalidArgument);
    EXPECT_THROW((void)run_validation("no_recipe.toml", {}), FileError);
}

}  // namespace known_surfaces_test
