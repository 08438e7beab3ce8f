// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/imaging/contour_trace.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "enclosed_mask.hpp"
#include "rendered_edge.hpp"
#include "setae/core/errors.hpp"

namespace setae::imaging::contour_trace_test {
namespace {

using tests::EdgePicture;
using tests::Wave;

double line(double x, double y) { return 80.3 + 0.2 * x - y; }  // times cos of the slope, nearly 1

struct Errors {
    double rms = 0, mean = 0, largest = 0, within_two = 0;
};

/// Distances of a segment from the zero of `distance`, away from the sides of the picture.
Errors errors_of(const ContourSegment& segment, const EdgePicture& picture,
                 const std::function<double(double, double)>& distance) {
    Errors found;
    double count = 0;
    for (Index i = 0; i < segment.x.size(); ++i) {
        if (segment.x[i] < 4 || segment.x[i] > static_cast<double>(picture.width) - 5) continue;
        const double d = distance(segment.x[i], segment.y[i]);
        found.rms += d * d;
        found.mean += d;
        count += 1;
        found.largest = std::max(found.largest, std::abs(d));
        found.within_two += std::abs(d) < 2 * segment.standard_error[i] ? 1 : 0;
    }
    found.rms = std::sqrt(found.rms / count);
    found.mean /= count;
    found.within_two /= count;
    return found;
}

bool has(const ContourTrace& trace, const std::string& code) {
    return std::any_of(trace.alerts.begin(), trace.alerts.end(), [&](const auto& alert) { return alert.code == code; });
}

TEST(ContourTrace, OfACleanPictureFollowsTheEdge) {
    const EdgePicture picture;
    const auto tilted = [](double x, double y) { return line(x, y) / std::hypot(1.0, 0.2); };
    const auto trace = trace_contour(rendered(picture, tilted));
    ASSERT_EQ(trace.segments.size(), 1U);
    const auto found = errors_of(trace.segments[0], picture, tilted);
    EXPECT_LT(found.largest, 0.02);
    EXPECT_NEAR(trace.segments[0].edge_width, picture.blur, 0.01 * picture.blur);
    EXPECT_FALSE(trace.segments[0].fringe);
    EXPECT_LT(trace.segments[0].x[0],
              trace.segments[0].x[trace.segments[0].x.size() - 1]);  // vacuum above: to the right
}

TEST(ContourTrace, AtTwiceTheNoiseIsWithinHalfAPixelAndItsErrorIsStated) {
    const Wave wave;
    double squares = 0, share = 0, density = 0;
    constexpr int seeds = 4;
    for (unsigned seed = 1; seed <= seeds; ++seed) {
        const EdgePicture picture{.noise = 50, .seed = seed};
        const auto trace = trace_contour(rendered(picture, wave));
        const auto found = errors_of(trace.segments.at(0), picture, wave);
        EXPECT_LT(found.rms, 0.5);
        squares += found.rms * found.rms / seeds;
        share += found.within_two / seeds;
        density += trace.segments[0].noise_density / seeds;
    }
    // one column determines the edge to σ² 2√π w/step² (Cramér and Rao); a picture measures it to 30 %: sums over 17
    // neighbours, 260 places
    EXPECT_NEAR(density, 0.25 * 2 * std::sqrt(3.14159265) * 0.9, 0.3 * 0.8);
    EXPECT_LT(std::sqrt(squares), 0.4);
    EXPECT_GT(share, 0.88);  // of 95 % for normal errors; about 30 independent places per picture
}

TEST(ContourTrace, DarkVacuumIsDetectedByLackOfStructureOrChosen) {
    const Wave wave;
    EdgePicture picture{.vacuum = 1000, .sample = 1100, .noise = 20};
    auto pixels = rendered(picture, wave);
    for (long row = 0; row < picture.height; ++row)
        for (long column = 0; column < picture.width; ++column)
            if (wave(static_cast<double>(column), static_cast<double>(row)) < -1)
                pixels(row, column) += static_cast<float>(40 * std::cos(1.1 * static_cast<double>(column + row)));
    const auto structured = trace_contour(pixels);
    EXPECT_EQ(structured.vacuum, Vacuum::dark);
    EXPECT_FALSE(has(structured, "VACUUM_ASSUMED"));
    const auto given = trace_contour(rendered(picture, wave), {.vacuum = Vacuum::dark});
    EXPECT_EQ(given.vacuum, Vacuum::dark);
    EXPECT_LT(errors_of(given.segments.at(0), picture, wave).rms, 0.25);
    EXPECT_TRUE(has(trace_contour(rendered(picture, wave)), "VACUUM_ASSUMED"));
}

TEST(ContourTrace, AFresnelFringeDoesNotMoveTheEdge) {
    const Wave wave{.amplitude = 3};
    const EdgePicture picture{.noise = 10, .fringe = 0.5};
    const auto trace = trace_contour(rendered(picture, wave));
    ASSERT_EQ(trace.segments.size(), 1U);
    EXPECT_TRUE(trace.segments[0].fringe);
    const auto found = errors_of(trace.segments[0], picture, wave);
    EXPECT_LT(found.rms, 0.1);
    EXPECT_LT(std::abs(found.mean), 0.03);
}

TEST(ContourTrace, FindsAnEdgeWithoutContrastByFringeAndTexture) {
    const Wave wave{.amplitude = 3};
    EdgePicture picture{.vacuum = 1000.001, .sample = 1000, .noise = 6};
    auto pixels = rendered(picture, wave);
    for (long row = 0; row < picture.height; ++row)
        for (long column = 0; column < picture.width; ++column) {
            const double d = wave(static_cast<double>(column), static_cast<double>(row)), v = d / 3;
            pixels(row, column) += static_cast<float>(45 * v * std::exp(0.5 - 0.5 * v * v));
            if (d < -2)
                pixels(row, column) += static_cast<float>(
                    40 * std::cos(0.9 * static_cast<double>(column) - 0.5 * static_cast<double>(row)));
        }
    const auto trace = trace_contour(pixels);
    const auto found = errors_of(trace.segments.at(0), picture, wave);
    EXPECT_LT(found.rms, 0.3);
    EXPECT_TRUE(trace.segments[0].fringe);
}

TEST(ContourTrace, ADiscIsAClosedOutlineOfItsRadius) {
    const EdgePicture picture{.width = 220, .height = 200, .noise = 20};
    const auto disc = [](double x, double y) { return std::hypot(x - 110.2, y - 97.7) - 60; };
    const auto trace = trace_contour(rendered(picture, disc));
    ASSERT_EQ(trace.segments.size(), 1U);
    EXPECT_TRUE(trace.segments[0].closed);
    EXPECT_NEAR(trace.segments[0].length, 2 * 3.14159265 * 60, 2);
    EXPECT_LT(errors_of(trace.segments[0], picture, disc).rms, 0.15);
}

TEST(ContourTrace, TwoEdgesAreBothTracedAndReported) {
    const EdgePicture picture{.noise = 20};
    const auto strip = [](double, double y) { return std::abs(y - 100.0) - 25; };
    const auto trace = trace_contour(rendered(picture, strip));
    ASSERT_EQ(trace.segments.size(), 2U);
    EXPECT_TRUE(has(trace, "TWO_EDGES"));
    for (const auto& segment : trace.segments) EXPECT_LT(errors_of(segment, picture, strip).rms, 0.2);
}

TEST(ContourTrace, GivesTheSameBytesTwice) {
    const auto pixels = rendered({.noise = 50}, Wave{});
    const auto first = trace_contour(pixels), second = trace_contour(pixels);
    EXPECT_TRUE((first.segments[0].x == second.segments[0].x).all());
    EXPECT_TRUE((first.segments[0].standard_error == second.segments[0].standard_error).all());
}

TEST(ContourTrace, PassesThroughAnchors) {
    const Wave wave;
    const EdgePicture picture{.noise = 30};
    const std::vector<Anchor> anchors{{20, wave.height(20)}, {100, wave.height(100) + 1.2}, {200, wave.height(200)}};
    const auto trace = trace_contour(rendered(picture, wave), {.anchors = {anchors}});
    ASSERT_EQ(trace.segments.size(), 1U);
    const auto& s = trace.segments[0];
    ASSERT_EQ(s.anchors.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto at = static_cast<Index>(s.anchors[i]);
        double nearest = 1e9;  // of the polyline, not only its points
        for (Index k = std::max<Index>(0, at - 2); k < std::min(s.x.size() - 1, at + 2); ++k) {
            const double ex = s.x[k + 1] - s.x[k], ey = s.y[k + 1] - s.y[k], px = anchors[i].x - s.x[k],
                         py = anchors[i].y - s.y[k];
            const double t = std::clamp((px * ex + py * ey) / (ex * ex + ey * ey), 0.0, 1.0);
            nearest = std::min(nearest, std::hypot(px - t * ex, py - t * ey));
        }
        EXPECT_LT(nearest, 0.01) << "anchor " << i;
    }
    EXPECT_NEAR(s.x[0], 20, 0.5);
    EXPECT_NEAR(s.x[s.x.size() - 1], 200, 0.5);
}

TEST(ContourTrace, AnchorsInEitherOrderKeepVacuumOnTheLeft) {
    const Wave wave;
    const auto pixels = rendered({.noise = 30}, wave);
    const Anchor left{20, wave.height(20)}, right{200, wave.height(200)};
    const auto forth = trace_contour(pixels, {.anchors = {{left, right}}}),
               back = trace_contour(pixels, {.anchors = {{right, left}}});
    EXPECT_LT(forth.segments[0].x[0], forth.segments[0].x[forth.segments[0].x.size() - 1]);
    EXPECT_TRUE((forth.segments[0].x == back.segments[0].x).all());
}

TEST(ContourTrace, PassesTheNearestEdgeThroughOneAnchor) {
    const Wave wave;
    const EdgePicture picture{.noise = 20};
    const auto trace = trace_contour(rendered(picture, wave), {.anchors = {{{130, wave.height(130) - 2}}}});
    const auto& s = trace.segments.at(0);
    const auto at = static_cast<Index>(s.anchors.at(0));
    EXPECT_LT(std::hypot(s.x[at] - 130, s.y[at] - (wave.height(130) - 2)), 0.6);
    EXPECT_GT(s.length, 250);  // the whole edge, not only the part near the anchor
}

TEST(ContourTrace, CrossesHiddenRegionsSmoothly) {
    const EdgePicture picture{.noise = 20};
    auto pixels = rendered(picture, Wave{.amplitude = 0});
    pixels.block(90, 100, 25, 20) = 5000;
    const auto trace = trace_contour(pixels, {.hidden = {{100, 90, 20, 25}}});
    EXPECT_LT(errors_of(trace.segments.at(0), picture, Wave{.amplitude = 0}).largest, 0.8);
}

TEST(ContourTrace, ReplacesSpikesAndIgnoresUndefinedPixels) {
    const Wave wave;
    const EdgePicture picture{.noise = 10};
    auto pixels = rendered(picture, wave);
    for (long k = 0; k < 20; ++k) pixels(5 + 9 * k, 3 + 12 * k) = 9000;
    pixels(50, 60) = std::numeric_limits<float>::quiet_NaN();
    const auto trace = trace_contour(pixels);
    EXPECT_TRUE(has(trace, "SPIKES"));
    EXPECT_TRUE(has(trace, "UNDEF"));
    EXPECT_LT(errors_of(trace.segments.at(0), picture, wave).rms, 0.15);
}

TEST(ContourTrace, DenoisingIncreasesTheReportedEdgeWidth) {
    const EdgePicture picture{.noise = 10};
    const auto flat = [](double, double y) { return 100.3 - y; };
    const auto trace = trace_contour(rendered(picture, flat), {.denoise = 1.2});
    EXPECT_NEAR(trace.segments.at(0).edge_width, std::hypot(0.9, 1.2), 0.05);
}

TEST(ContourTrace, OfAPictureWithoutEdgeIsRefused) {
    for (const double noise : {5.0, 50.0}) {
        const EdgePicture picture{.vacuum = 1000, .sample = 1000, .noise = noise};
        EXPECT_THROW((void)trace_contour(rendered(picture, Wave{})), UndefinedDataError);
    }
    FramePixels ramp(100, 120), lattice(100, 120);
    for (long row = 0; row < 100; ++row)
        for (long column = 0; column < 120; ++column) {
            ramp(row, column) = static_cast<float>(column + 2 * row);
            lattice(row, column) = std::cos(1.0F * static_cast<float>(column) + 0.3F * static_cast<float>(row));
        }
    EXPECT_THROW((void)trace_contour(ramp), UndefinedDataError);
    EXPECT_THROW((void)trace_contour(lattice), UndefinedDataError);
    EXPECT_THROW((void)trace_contour(FramePixels::Constant(64, 64, 7)), UndefinedDataError);
    EXPECT_THROW((void)trace_contour(FramePixels::Constant(64, 64, std::numeric_limits<float>::quiet_NaN())),
                 UndefinedDataError);
}

TEST(ContourTrace, RefusesOptionsOutsideTheirDomain) {
    const auto pixels = rendered({}, Wave{});
    EXPECT_THROW((void)trace_contour(FramePixels::Zero(20, 400)), InvalidArgument);
    EXPECT_THROW((void)trace_contour(pixels, {.anchors = {{{300, 20}, {10, 10}}}}), InvalidArgument);
    EXPECT_THROW((void)trace_contour(pixels, {.anchors = {{{std::nan(""), 20}}}}), InvalidArgument);
    EXPECT_THROW((void)trace_contour(pixels, {.hidden = {{250, 0, 20, 20}}}), InvalidArgument);
    EXPECT_THROW((void)trace_contour(pixels, {.smoothing_length = -1.0}), InvalidArgument);
    EXPECT_THROW((void)trace_contour(pixels, {.denoise = -1.0}), InvalidArgument);
}

TEST(ContourTrace, OfAMaskEnclosesItsPixelsExactly) {
    FramePixels mask = FramePixels::Zero(60, 80);
    const auto disc = [&](double cx, double cy, double radius, float value) {
        for (long row = 0; row < mask.rows(); ++row)
            for (long column = 0; column < mask.cols(); ++column)
                if (std::hypot(static_cast<double>(column) - cx, static_cast<double>(row) - cy) < radius)
                    mask(row, column) = value;
    };
    disc(30, 30, 17, 255);
    disc(34, 30, 6, 0);
    disc(60, 20, 9, 255);
    mask.block(28, 42, 2, 20) = 255;                           // a neck
    mask(50, 70) = 255, mask(51, 71) = 255, mask(51, 70) = 0;  // joined only by a corner
    mask.block(55, 0, 5, 12) = 255;                            // at the sides of the picture
    const auto trace = trace_contour(mask);
    EXPECT_TRUE(trace.binary);
    EXPECT_EQ(trace.vacuum, Vacuum::dark);
    const auto again = tests::enclosed(trace.segments, mask.cols(), mask.rows());
    EXPECT_TRUE(((again == 1) == (mask == 255)).all());
    EXPECT_EQ(std::count_if(trace.segments.begin(), trace.segments.end(), [](const auto& s) { return !s.closed; }), 1);
    for (const auto& s : trace.segments) EXPECT_NEAR(s.standard_error[0], std::sqrt(1.0 / 12), 1e-12);
}

TEST(ContourTrace, OfAnyMaskEnclosesItsPixelsExactly) {
    std::mt19937 engine(7);
    for (int round = 0; round < 20; ++round) {
        FramePixels mask(33, 35);
        for (long i = 0; i < mask.size(); ++i) mask.data()[i] = engine() % 3 == 0 ? 1.0F : 0.0F;
        const auto trace = trace_contour(mask, {.vacuum = round % 2 == 0 ? Vacuum::dark : Vacuum::bright});
        const auto again = tests::enclosed(trace.segments, mask.cols(), mask.rows());
        const std::uint8_t bright = round % 2 == 0 ? 1 : 0;
        EXPECT_TRUE(((again == bright) == (mask == 1.0F)).all()) << round;
    }
}

TEST(ContourTrace, OfAFaintEdgeGivesAWarning) {
    const Wave wave;
    EXPECT_FALSE(has(trace_contour(rendered({.noise = 50}, wave)), "LOW_CONTRAST"));
    const auto faint = trace_contour(rendered({.noise = 150}, wave));
    EXPECT_TRUE(has(faint, "LOW_CONTRAST"));
    EXPECT_LT(faint.segments.at(0).contrast_to_noise, 1.0);
}

TEST(ContourTrace, NotConvergedInItsLastRoundGivesAWarning) {
    const Wave wave;
    EXPECT_TRUE(has(trace_contour(rendered({.noise = 150, .seed = 2}, wave)), "NOT_CONVERGED"));
    EXPECT_FALSE(has(trace_contour(rendered({.noise = 50, .seed = 2}, wave)), "NOT_CONVERGED"));
}

}  // namespace
}  // namespace setae::imaging::contour_trace_test
