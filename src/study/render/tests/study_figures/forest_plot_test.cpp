// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study_figures/forest_plot.hpp"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"
#include "simulated_replicates.hpp"

namespace forest_plot_test {

using namespace setae;
using namespace setae::statistics;
using study_figures::forest_plot;

const figures::Series& series_named(const figures::Figure& figure, const std::string& label) {
    for (const auto& series : figure.panels.at(0).series)
        if (series.label == label) return series;
    throw InternalError("no series " + label);
}

TEST(ForestPlot, ShowsEveryRowWithItsInterval) {
    const auto data = simulated({.surfaces = 2, .lenses = 3, .spots = 2, .repeats = 2, .fit_error = 1.0});
    const auto model = mixed_model(data);
    const auto figure = forest_plot(data, model, {.quantity = "*W*", .unit = "mJ/m2", .factor = 1e3});
    const auto& rows = series_named(figure, "S0");
    ASSERT_EQ(rows.x.size(), 12);
    EXPECT_NEAR(rows.x[0], 1e3 * data.rows[0].value, 1e-9);
    EXPECT_NEAR(rows.right[0] - rows.x[0], 1e3 * normal_quantile(0.975) * data.rows[0].standard_error, 1e-9);
    EXPECT_EQ(rows.names[0], data.rows[0].name);
    // headings, rows and means
    const auto& labels = figure.panels[0].y.tick_labels;
    ASSERT_EQ(labels.size(), 24U + 2U + 2U);
    EXPECT_EQ(labels.back(), "S0");
    EXPECT_EQ(labels.front(), "mean");
    EXPECT_EQ(labels[labels.size() - 2], "lens L0 · spot P0 (1)");
    EXPECT_EQ(rows.y[0], static_cast<double>(labels.size() - 2));
}

TEST(ForestPlot, DiamondHasTheWidthOfTheInterval) {
    const auto data = simulated({.surfaces = 1, .lenses = 4, .spots = 3, .repeats = 2, .fit_error = 1.0});
    const auto model = mixed_model(data);
    const auto figure = forest_plot(data, model);
    const auto& mean = series_named(figure, "S0, mean");
    EXPECT_EQ(mean.x.minCoeff(), model.surfaces[0].mean.interval->lower);
    EXPECT_EQ(mean.x.maxCoeff(), model.surfaces[0].mean.interval->upper);
    EXPECT_EQ(series_named(figure, "S0, mean, prediction").x[1], model.surfaces[0].prediction->upper);
}

TEST(ForestPlot, ShowsExcludedRowsHollowWithTheirReason) {
    auto data = simulated({.surfaces = 1, .lenses = 3, .spots = 2, .repeats = 1, .fit_error = 1.0});
    data.exclusions = {{1, "dust on the lens"}};
    const auto figure = forest_plot(data, mixed_model(data));
    const auto& excluded = series_named(figure, "S0, excluded");
    EXPECT_TRUE(excluded.hollow);
    ASSERT_EQ(excluded.x.size(), 1);
    EXPECT_EQ(excluded.x[0], data.rows[1].value);
    EXPECT_EQ(excluded.names[0], data.rows[1].name + ", excluded: dust on the lens");
    ASSERT_EQ(figure.panels[0].notes.size(), 1U);
    EXPECT_EQ(figure.panels[0].notes[0].text, "dust on the lens");
    EXPECT_EQ(series_named(figure, "S0").x.size(), 5);
    EXPECT_NO_THROW((void)series_named(figure, "S0, mean with excluded"));
}

TEST(ForestPlot, HeightIncreasesWithRowsWithinBounds) {
    const auto height = [](int spots) {
        const auto data = simulated({.surfaces = 1, .lenses = 2, .spots = spots, .repeats = 1});
        return forest_plot(data, mixed_model(data, {.influence = false})).height_mm;
    };
    EXPECT_GE(height(1), 40.0);
    EXPECT_NEAR(height(20) - height(10), 20 * 4.2, 1e-9);
    EXPECT_LE(height(100), 500.0);
}

TEST(ForestPlot, KeepsRowsLegibleNextToAVeryWideInterval) {
    // two lenses: Student's t of one degree of freedom
    const auto data = simulated({.surfaces = 1, .lenses = 2, .spots = 2, .repeats = 1, .fit_error = 1.0});
    const auto model = mixed_model(data);
    const auto figure = forest_plot(data, model);
    const auto& rows = series_named(figure, "S0");
    const double spread = rows.right.maxCoeff() - rows.left.minCoeff();
    EXPECT_LE(*figure.panels[0].x.to - *figure.panels[0].x.from, 4.5 * spread);
}

TEST(ForestPlot, RefusesAModelOfOtherData) {
    const auto data = simulated({.surfaces = 1, .lenses = 3, .spots = 2, .repeats = 1});
    const auto other = simulated({.surfaces = 1, .lenses = 4, .spots = 2, .repeats = 1});
    EXPECT_THROW((void)forest_plot(data, mixed_model(other)), InvalidArgument);
}

}  // namespace forest_plot_test
