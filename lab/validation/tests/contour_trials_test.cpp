// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/validation/contour_trials.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "contour_comparison.hpp"
#include "curve_distance.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/random_numbers.hpp"
#include "setae/validation/contour_summary.hpp"

namespace setae::validation::contour_trials_test {
namespace {

/// A trace of one segment.
imaging::ContourTrace trace_of(const Array1D& x, const Array1D& y, double standard_error = 0.3) {
    imaging::ContourSegment segment{.x = x, .y = y, .standard_error = Array1D::Constant(x.size(), standard_error)};
    segment.length = length_along({x, y}).tail(1)[0];
    return {.segments = {segment}};
}

/// What a curve's points within the picture would be as a trace, each moved along its normal into vacuum.
imaging::ContourTrace moved(const RenderedContour& rendered, const std::function<double(Index)>& into_vacuum) {
    const auto& curve = rendered.truth.curve;
    std::vector<double> x, y;
    for (Index i = 4; i + 4 < curve.x.size(); i += 4) {
        if (curve.x[i] < 0.0 || curve.x[i] > static_cast<double>(rendered.width - 1)) continue;
        const double along_x = curve.x[i + 1] - curve.x[i - 1], along_y = curve.y[i + 1] - curve.y[i - 1],
                     length = std::hypot(along_x, along_y);
        const double by = into_vacuum(i);
        x.push_back(curve.x[i] + by * along_y / length);
        y.push_back(curve.y[i] - by * along_x / length);
    }
    return trace_of(Eigen::Map<const Array1D>(x.data(), static_cast<Index>(x.size())),
                    Eigen::Map<const Array1D>(y.data(), static_cast<Index>(y.size())));
}

RenderedContour contour(int bulges = 0, double rms_height = 16.0) {
    return {simulation::rough_curve({.width = 800,
                                     .height = 800,
                                     .rms_height = rms_height,
                                     .rolloff_wavelength = 800.0,
                                     .bulges = bulges,
                                     .key = {11, 0}}),
            800, 800, 10.0};
}

/// Places of the edge in columns of a picture without noise: how much of each column is vacuum.
imaging::ContourTrace column_sums(const imaging::FramePixels& pixels) {
    Array1D y(pixels.cols());
    for (Index column = 0; column < y.size(); ++column) y[column] = pixels.col(column).cast<double>().sum() - 0.5;
    return trace_of(Array1D::LinSpaced(y.size(), 0.0, static_cast<double>(y.size() - 1)), y);
}

TEST(CurveDistance, IsTheDistanceToTheNearestSegment) {
    const auto curve = contour(4).truth.curve;
    const CurveIndex index(curve);
    for (std::uint64_t i = 0; i < 40; ++i) {
        const double x = 1000.0 * numerics::uniform_number({1, 1}, 2 * i) - 100.0,
                     y = 1000.0 * numerics::uniform_number({1, 1}, 2 * i + 1) - 100.0;
        // points are at most 0.3 px apart
        const double of_points = std::sqrt(((curve.x - x).square() + (curve.y - y).square()).minCoeff());
        const auto found = index.nearest(x, y);
        EXPECT_LE(std::abs(found.distance), of_points + 1e-12);
        EXPECT_GE(std::abs(found.distance), of_points - 0.2);
        EXPECT_NEAR(std::hypot(found.x - x, found.y - y), std::abs(found.distance), 1e-12);
        if (std::abs(y - 400.0) > 100.0) {
            EXPECT_EQ(found.distance > 0.0, y < 400.0) << x << ' ' << y;
        }
    }
}

TEST(ContourComparison, FindsNoErrorInTheTrueCurve) {
    const auto rendered = contour();
    const auto trial = compared(moved(rendered, [](Index) { return 0.0; }), rendered);
    EXPECT_LT(trial.rms_error, 0.02);  // straight between every fourth point, 1 px: radius of curvature above 5 px
    EXPECT_EQ(trial.completeness, 1.0);
    EXPECT_EQ(trial.within_two_errors, 1.0);
    EXPECT_NEAR(trial.rms_height_ratio, 1.0, 1e-3);
    for (std::size_t band = 0; band < 4; ++band) EXPECT_NEAR(trial.spectrum_ratio[band], 1.0, 0.03) << band;
    EXPECT_EQ(trial.overhangs_false, 0);
}

TEST(ContourComparison, MeasuresAnOffsetWithItsSign) {
    const auto rendered = contour();
    const auto trial = compared(moved(rendered, [](Index) { return 0.4; }), rendered);
    EXPECT_NEAR(trial.offset, 0.4, 0.01);
    EXPECT_NEAR(trial.rms_error, 0.4, 0.01);
    EXPECT_EQ(trial.within_two_errors, 1.0);
    EXPECT_EQ(compared(moved(rendered, [](Index) { return -0.7; }), rendered).within_two_errors, 0.0);
}

TEST(ContourComparison, DetectsATraceWithSampleAndVacuumExchanged) {
    const auto rendered = contour();
    auto trace = moved(rendered, [](Index) { return 0.0; });
    EXPECT_FALSE(compared(trace, rendered).vacuum_mistaken);
    for (auto* places : {&trace.segments.front().x, &trace.segments.front().y}) places->reverseInPlace();
    const auto trial = compared(trace, rendered);
    EXPECT_TRUE(trial.vacuum_mistaken);
    EXPECT_NEAR(trial.rms_height_ratio, 1.0, 1e-3);
}

TEST(ContourComparison, MeasuresScatterAndItsDensity) {
    const auto rendered = contour();
    const auto noise = numerics::normal_numbers({5, 0}, 0, rendered.truth.curve.x.size());
    auto trace = moved(rendered, [&](Index i) { return 0.3 * noise[i]; });
    trace.segments.front().noise_density = 0.09;  // variance times the distance of points, about 1 px of the level line
    const auto trial = compared(trace, rendered);
    EXPECT_NEAR(trial.rms_error, 0.3, 0.03);            // of 800 points: 2.5 %; nearest distances are a little less
    EXPECT_NEAR(trial.within_two_errors, 0.954, 0.03);  // 0.7 % of 800 points
    EXPECT_NEAR(trial.floor_ratio, 1.0, 0.75);  // 12 modes, fewer behind a window: 3 · 0.35 of it at most; seen 1.1
    EXPECT_TRUE(std::isfinite(trial.spectrum_ratio[1]));
    EXPECT_TRUE(std::isnan(trial.spectrum_ratio[4]));  // below the curve's shortest waves
}

TEST(ContourComparison, CountsOverhangsFoundAndMissed) {
    const auto rendered = contour(5, 6.0);
    const auto whole = compared(moved(rendered, [](Index) { return 0.0; }), rendered);
    EXPECT_EQ(whole.overhangs, 10);
    EXPECT_EQ(whole.overhangs_found, 10);
    EXPECT_EQ(whole.overhangs_false, 0);
    EXPECT_NEAR(whole.overhang_depth_ratio, 1.0, 0.05);
    // a trace that runs straight over every place where the curve turns back
    const auto& curve = rendered.truth.curve;
    std::vector<double> x, y;
    for (Index i = 0; i < curve.x.size(); ++i)
        if (curve.x[i] >= 0.0 && curve.x[i] <= 799.0 && (x.empty() || curve.x[i] > x.back() + 0.5)) {
            x.push_back(curve.x[i]);
            y.push_back(curve.y[i]);
        }
    const auto cut = compared(trace_of(Eigen::Map<const Array1D>(x.data(), static_cast<Index>(x.size())),
                                       Eigen::Map<const Array1D>(y.data(), static_cast<Index>(y.size()))),
                              rendered);
    EXPECT_EQ(cut.overhangs_found, 0);
    EXPECT_GT(cut.largest_error, 3.0);
}

TEST(ContourComparison, CountsAMissingStretchAsIncomplete) {
    const auto rendered = contour();
    auto trace = moved(rendered, [](Index) { return 0.0; });
    auto& segment = trace.segments.front();
    const Index half = segment.x.size() / 2;
    segment.x = Array1D(segment.x.head(half));
    segment.y = Array1D(segment.y.head(half));
    segment.standard_error = Array1D(segment.standard_error.head(half));
    const auto trial = compared(trace, rendered);
    EXPECT_NEAR(trial.completeness, 0.5, 0.03);
    EXPECT_GT(trial.largest_error, 300.0);
}

ContourTrialOptions small_trials() {
    return {.runs = 2, .size = 240, .kinds = {"clean", "SNR 2 + overhangs"}, .tracer = column_sums, .threads = {1}};
}

TEST(ContourTrials, WithColumnSumsFindTheEdgeInCleanPictures) {
    const auto trials = contour_trials(small_trials());
    ASSERT_EQ(trials.size(), 4u);
    for (int run = 0; run < 2; ++run) {
        const auto& trial = trials[static_cast<std::size_t>(run)];
        EXPECT_EQ(trial.run, run);
        // a column's mean is that of its pixel's width, blurred by 0.8 px: short of waves of 10 px by (2π/10)² (0.8² +
        // 1/12)/2 = 14 %
        EXPECT_LT(trial.rms_error, 0.2);
        EXPECT_LT(std::abs(trial.offset), 0.02);
        EXPECT_NEAR(trial.rms_height_ratio, 1.0, 0.005);
        EXPECT_NEAR(trial.spectrum_ratio[1], 1.0, 0.02);
    }
    EXPECT_GT(trials[2].overhangs, 0);
    EXPECT_GT(trials[2].rms_error, 1.0);  // noise of half the step, summed over a column
}

TEST(ContourTrials, AreTheSameForAnyNumberOfThreads) {
    auto options = small_trials();
    const auto one = contour_trials_csv(contour_trials(options));
    options.threads = {3};
    EXPECT_EQ(contour_trials_csv(contour_trials(options)), one);
}

TEST(ContourTrials, WritePicturesOnRequest) {
    const auto folder = std::filesystem::temp_directory_path() / "setae_contour_pictures";
    std::filesystem::remove_all(folder);
    auto options = small_trials();
    options.runs = 1;
    options.kinds = {"SNR 2, upright"};
    options.pictures = folder.string();
    (void)contour_trials(options);
    EXPECT_TRUE(std::filesystem::exists(folder / "SNR_2__upright_000.png"));
    EXPECT_TRUE(std::filesystem::exists(folder / "SNR_2__upright_000_bare.png"));
    EXPECT_TRUE(std::filesystem::exists(folder / "SNR_2__upright_000_truth.csv"));
    std::filesystem::remove_all(folder);
}

TEST(ContourTrials, CountPicturesThatTheTracerRefuses) {
    auto options = small_trials();
    options.tracer = [](const imaging::FramePixels&) -> imaging::ContourTrace { throw UndefinedDataError("no edge"); };
    const auto rows = contour_summary(contour_trials(options));
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].refused, 2);
    EXPECT_FALSE(contour_verdicts(rows).front().passed);
}

TEST(ContourTrials, RequireRunsKindsAndATracer) {
    auto options = small_trials();
    options.runs = 0;
    EXPECT_THROW((void)contour_trials(options), InvalidArgument);
    options = small_trials();
    options.kinds = {"SNR 1000"};
    EXPECT_THROW((void)contour_trials(options), InvalidArgument);
    options = small_trials();
    options.size = 100;
    EXPECT_THROW((void)contour_trials(options), InvalidArgument);
}

TEST(ContourSummary, VerdictsUseTheWorstRunAndTheMeanSpectrum) {
    ContourTrial good{.run = 0,
                      .kind = "a",
                      .segments = 1,
                      .completeness = 1.0,
                      .rms_error = 0.3,
                      .largest_error = 1.0,
                      .within_two_errors = 0.95,
                      .rms_height_ratio = 1.01,
                      .floor_ratio = 1.0};
    good.spectrum_ratio = {1.0, 1.05, undefined, undefined, undefined};
    auto bad = good;
    bad.run = 1;
    bad.rms_error = 0.6;
    bad.spectrum_ratio = {1.3, 1.05, undefined, undefined, undefined};
    const auto rows = contour_summary({good, bad});
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_DOUBLE_EQ(rows[0].rms_error.mean, 0.45);
    EXPECT_EQ(rows[0].rms_error.worst_run, 1);
    EXPECT_NEAR(rows[0].spectrum_ratio[0].standard_error, 0.15, 1e-12);
    std::vector<std::string> failed;
    for (const auto& verdict : contour_verdicts(rows))
        if (!verdict.passed) failed.push_back(verdict.criterion);
    EXPECT_EQ(failed, (std::vector<std::string>{"rms error below 0.5 px in every run",
                                                "C1D of waves of 1000 to 316 px within 10 % on average"}));
    EXPECT_NE(contour_table(rows).find("5 of 7 criteria met"), std::string::npos);
}

}  // namespace
}  // namespace setae::validation::contour_trials_test
