// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "setae/core/errors.hpp"
#include "setae/spectra/jackknife.hpp"

namespace setae::spectra::jackknife_test {
namespace {

/// Measurements given by their values in three bins; NaN if one has none.
BinnedSpectra made_of(const std::vector<std::array<double, 3>>& values, std::vector<std::string> instruments) {
    BinnedSpectra binned;
    binned.wavevector = Array1D::NullaryExpr(3, [&](Index b) { return binned.grid.centre(b); });
    binned.C1D.resize(static_cast<Index>(values.size()), 3);
    for (std::size_t i = 0; i < values.size(); ++i)
        for (std::size_t b = 0; b < 3; ++b) binned.C1D(static_cast<Index>(i), static_cast<Index>(b)) = values[i][b];
    binned.relative_variance = Array2D::Ones(binned.C1D.rows(), 3);
    binned.instruments = std::move(instruments);
    return binned;
}

constexpr double none = std::numeric_limits<double>::quiet_NaN();

TEST(Jackknife, OfOneInstrumentGivesTheStandardErrorOfTheMean) {
    const auto binned =
        made_of({{1.0, 2.0, 3.0}, {4.0, 2.5, 1.0}, {2.0, 7.0, 5.0}, {3.0, 1.0, 2.0}}, {"afm", "afm", "afm", "afm"});
    const auto left_out = jackknife(binned);
    ASSERT_EQ(left_out.C1D.size(), 1u);
    const Array2D& curves = left_out.C1D.front();
    const auto combined = combine(binned);
    for (Index b = 0; b < 3; ++b) {
        const double centre = curves.col(b).mean();
        EXPECT_NEAR(centre, combined.density[b], 1e-14);  // a mean is linear: no bias
        EXPECT_NEAR(std::sqrt(0.75 * (curves.col(b) - centre).square().sum()), combined.standard_error[b], 1e-14);
    }
}

TEST(Jackknife, FillsBinsCoveredOnlyByTheOmittedMeasurement) {
    const auto binned = made_of({{1.0, 1.0, none}, {3.0, 3.0, none}, {none, 2.0, 8.0}, {none, 2.0, none}},
                                {"stylus", "stylus", "afm", "afm"});
    const auto left_out = jackknife(binned);
    ASSERT_EQ(left_out.C1D.size(), 2u);
    // without the third: bin 1 is the mean of 1, 3, 2, as with it, so the missing bin keeps its value
    EXPECT_NEAR(left_out.C1D[0](0, 2), 8.0, 1e-14);
    // without the first: bin 1 rises to 7/3, there is no single bin next to the missing one, so nothing else changes
    EXPECT_NEAR(left_out.C1D[1](0, 0), 3.0, 1e-14);
    EXPECT_NEAR(left_out.C1D[1](0, 1), 7.0 / 3.0, 1e-14);
    EXPECT_NEAR(left_out.C1D[1](0, 2), 8.0, 1e-14);
}

TEST(Jackknife, MergesStrataOfOneMeasurement) {
    const auto members_of = [](const std::vector<std::string>& instruments) {
        const auto binned =
            made_of(std::vector<std::array<double, 3>>(instruments.size(), {1.0, 1.0, 1.0}), instruments);
        std::vector<Index> sizes;
        for (const auto& curves : jackknife(binned).C1D) sizes.push_back(curves.rows());
        return sizes;
    };
    EXPECT_EQ(members_of({"a", "a", "a", "b", "b", "c"}), (std::vector<Index>{4, 2}));  // c joins the largest
    EXPECT_EQ(members_of({"a", "a", "b", "c"}), (std::vector<Index>{2, 2}));            // b and c together
    EXPECT_EQ(members_of({"a"}), std::vector<Index>{});
}

TEST(Jackknife, OmitsOneCopyOfAMeasurementDrawnTwice) {
    const auto binned = made_of({{1.0, 1.0, 1.0}, {4.0, 4.0, 4.0}, {100.0, 100.0, 100.0}}, {"afm", "afm", "afm"});
    const auto left_out = jackknife(binned, Weighting::equal, {2, 1, 0});
    ASSERT_EQ(left_out.C1D.size(), 1u);
    ASSERT_EQ(left_out.C1D[0].rows(), 3);
    EXPECT_NEAR(left_out.C1D[0](0, 0), 2.5, 1e-14);
    EXPECT_NEAR(left_out.C1D[0](1, 0), 2.5, 1e-14);
    EXPECT_NEAR(left_out.C1D[0](2, 0), 1.0, 1e-14);
    EXPECT_THROW((void)jackknife(binned, Weighting::equal, {1, 1}), InvalidArgument);
}

TEST(Jackknife, ShiftsSingleMeasurementBinsByTheirModeScatter) {
    auto binned = made_of({{1.0, 1.0, none}, {3.0, 3.0, none}, {none, 2.0, 8.0}}, {"stylus", "stylus", "afm"});
    binned.relative_variance(2, 2) = 0.01;
    const auto moved = moved_single_bins(binned);
    ASSERT_EQ(moved.plus.rows(), 1);
    // ψ'(100) = 0.0100502
    EXPECT_NEAR(moved.plus(0, 2) / 8.0, std::exp(std::sqrt(0.01005017)), 1e-6);
    EXPECT_NEAR(moved.minus(0, 2) / 8.0, std::exp(-std::sqrt(0.01005017)), 1e-6);
    EXPECT_DOUBLE_EQ(moved.plus(0, 1), 2.0);
    EXPECT_EQ(moved_single_bins(made_of({{1.0, 1.0, 1.0}, {3.0, 3.0, 2.0}}, {"afm", "afm"})).plus.rows(), 0);
}

}  // namespace
}  // namespace setae::spectra::jackknife_test
