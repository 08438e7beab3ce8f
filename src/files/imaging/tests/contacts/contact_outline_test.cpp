// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/imaging/contact_outline.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "recordings.hpp"
#include "rendered_contact.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::imaging::contact_outline_test {
namespace {

using tests::RenderedContact;

/// Waves of 2 px and less on an edge of 60 px.
double waves(double angle) {
    return 2.0 * std::cos(3.0 * angle + 0.2) + 1.2 * std::sin(7.0 * angle) + 0.5 * std::cos(19.0 * angle + 1.0);
}

RenderedContact rough_contact() {
    RenderedContact rendered;
    rendered.width = rendered.height = 200;
    rendered.centre_x = 99.7;
    rendered.centre_y = 100.4;
    rendered.semi_major = 60;
    rendered.ripple = waves;
    rendered.largest_ripple = 4;
    return rendered;
}

ContactOutline traced(const RenderedContact& rendered, Index angles = 256) {
    const auto pixels = rendered.make();
    return trace_contact_outline(pixels, measure_contact_frame(pixels), rendered.centre_x, rendered.centre_y, angles);
}

Array1D errors_of(const ContactOutline& outline) {
    Array1D error(outline.radius.size());
    for (Index j = 0; j < error.size(); ++j)
        error[j] =
            outline.radius[j] - 60.0 - waves(2.0 * pi * static_cast<double>(j) / static_cast<double>(error.size()));
    return error;
}

TEST(ContactOutline, FollowsANonEllipticalEdge) {
    const auto error = errors_of(traced(rough_contact()));
    EXPECT_LT(std::abs(error.mean()), 0.03);  // the blur moves a convex edge inwards by w²/(2a)
    EXPECT_LT(std::sqrt(error.square().mean()), 0.1);
    EXPECT_LT(error.abs().maxCoeff(), 0.3);
    auto bright = rough_contact();
    bright.inside = 140;
    bright.contrast = -60;
    EXPECT_LT(errors_of(traced(bright)).abs().maxCoeff(), 0.3);
}

// the contribution of noise to the error agrees with the stated one, for three contrasts
TEST(ContactOutline, ReportsTheNoiseOfItsPositions) {
    const auto clean = errors_of(traced(rough_contact()));
    for (const double noise : {3.0, 6.0, 12.0}) {
        double ratio = 0.0;
        for (unsigned seed = 1; seed <= 6; ++seed) {
            auto rendered = rough_contact();
            rendered.noise = noise;
            rendered.seed = seed;
            const auto outline = traced(rendered);
            const Array1D added = errors_of(outline) - clean;
            ratio += std::sqrt(added.square().mean()) / outline.place_error / 6.0;
        }
        EXPECT_GT(ratio, 0.75) << noise;
        EXPECT_LT(ratio, 1.35) << noise;
    }
}

TEST(ContactOutline, FindsVoidsInTheContact) {
    auto rendered = rough_contact();
    EXPECT_TRUE(traced(rendered).voids.empty());
    rendered.void_x = 120.0;
    rendered.void_y = 90.0;
    rendered.void_radius = 5.0;
    rendered.noise = 6;
    const auto outline = traced(rendered);
    ASSERT_EQ(outline.voids.size(), 1u);
    EXPECT_NEAR(outline.voids[0].x, 120.0, 0.3);
    EXPECT_NEAR(outline.voids[0].y, 90.0, 0.3);
    EXPECT_NEAR(outline.voids[0].area, 25.0 * pi, 6.0);
    EXPECT_LT(errors_of(outline).abs().maxCoeff(), 1.0);  // the edge does not jump to it
}

TEST(ContactOutline, RefusesRangesWithoutVisibleEdge) {
    const auto rendered = rough_contact();
    const auto pixels = rendered.make();
    auto contact = measure_contact_frame(pixels);
    EXPECT_THROW((void)trace_contact_outline(pixels, contact, 40.0, 100.0, 256), InvalidArgument);
    EXPECT_THROW((void)trace_contact_outline(pixels, contact, 99.7, 100.4, 15), InvalidArgument);
    contact.partial = true;
    EXPECT_THROW((void)trace_contact_outline(pixels, contact, 99.7, 100.4, 256), InvalidArgument);
    contact = {};
    EXPECT_THROW((void)trace_contact_outline(pixels, contact, 99.7, 100.4, 256), InvalidArgument);
}

/// Root mean square of an edge without its mean and its first and second harmonics: those of its centre and of an
/// ellipse.
double deviation_from_ellipse(const Array1D& edge) {
    const Array1D angle =
        Array1D::LinSpaced(edge.size(), 0.0, 2.0 * pi * (1.0 - 1.0 / static_cast<double>(edge.size())));
    double variance = (edge - edge.mean()).square().mean();
    for (const double turns : {1.0, 2.0})
        variance -= 2.0 * (std::pow((edge * (turns * angle).cos()).mean(), 2) +
                           std::pow((edge * (turns * angle).sin()).mean(), 2));
    return std::sqrt(variance);
}

/// A recording of an edge that shrinks from 60 px, with the waves of the first frame.
TEST(RecordedLine, ContainsTheEdgeOfEveryCompleteFrame) {
    const tests::Folder folder;
    std::vector<FramePixels> frames;
    for (int k = 0; k < 4; ++k) {
        auto rendered = rough_contact();
        rendered.semi_major = 60.0 - 2.0 * k;
        rendered.noise = 3;
        rendered.seed = static_cast<unsigned>(k);
        if (k == 2) rendered.contrast = 0;
        frames.push_back(rendered.make());
    }
    tests::write_bytes(folder / "shrinking.tif", tests::PlainTiff{}.bytes(frames));
    FrameOptions options;
    options.pixel_size = 2e-6;
    options.frame_rate = 10.0;
    const FrameSource source(folder / "shrinking.tif", options);
    const auto radii = measure_contact_radii(source);
    const auto recorded = measure_contact_line(source, radii);
    EXPECT_EQ(recorded.frames, (std::vector<long>{1, 2, 4}));
    ASSERT_EQ(recorded.time.size(), 3);
    EXPECT_EQ(recorded.radius.cols(), 2 * static_cast<Index>(std::ceil(pi * radii.frames[0].contact.radius / 2.0)));
    EXPECT_NEAR(recorded.time[2], 0.3, 1e-12);
    EXPECT_NEAR(recorded.radius.row(0).mean(), 120e-6, 0.2e-6);
    EXPECT_NEAR(recorded.radius.row(2).mean(), 108e-6, 0.2e-6);
    const Array1D edge = recorded.radius.row(0).transpose();
    EXPECT_NEAR(deviation_from_ellipse(edge), 2e-6 * std::sqrt(0.5 * (2.0 * 2.0 + 1.2 * 1.2 + 0.5 * 0.5)), 0.1e-6);
    LineOptions one_thread;
    one_thread.threads.count = 1;
    EXPECT_TRUE((measure_contact_line(source, radii, one_thread).radius == recorded.radius).all());
}

}  // namespace
}  // namespace setae::imaging::contact_outline_test
