// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/imaging/contact_radius.hpp"

#include "recordings.hpp"
#include "rendered_contact.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/tables/clocks.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::imaging::tests::contact_radius_test {
namespace {

constexpr double pixel_size = 1.82e-6;

/// 0 for the first two frames, then growing.
double true_radius(std::size_t frame) { return frame < 2 ? 0.0 : 8.0 + 2.35 * static_cast<double>(frame - 2); }

std::vector<FramePixels> growing(std::size_t n) {
    std::vector<FramePixels> frames;
    for (std::size_t k = 0; k < n; ++k) {
        RenderedContact contact{.width = 90,
                                .height = 80,
                                .centre_x = 44.2,
                                .centre_y = 40.6,
                                .semi_major = std::max(1.0, true_radius(k)),
                                .noise = 6,
                                .seed = static_cast<unsigned>(k + 1)};
        if (true_radius(k) == 0) {
            contact.contrast = 0;
            contact.inside = 140;
        }
        frames.push_back(contact.make());
    }
    return frames;
}

FrameOptions options() { return {.pixel_size = pixel_size, .frame_rate = 20}; }

TEST(ContactRadii, FollowAGrowingContact) {
    const Folder folder;
    write_bytes(folder / "stack.tif", PlainTiff{}.bytes(growing(9)));
    const auto radii = measure_contact_radii(FrameSource(folder / "stack.tif", options()));
    ASSERT_EQ(radii.frames.size(), 9U);
    for (std::size_t k = 0; k < 9; ++k) {
        EXPECT_NEAR(radii.frames[k].radius, true_radius(k) * pixel_size, 0.12 * pixel_size) << k;
        EXPECT_DOUBLE_EQ(radii.frames[k].time, static_cast<double>(k) / 20);
    }
    EXPECT_EQ(radii.summary.measured, 7U);
    EXPECT_EQ(radii.summary.no_contact, 2U);
    EXPECT_EQ(radii.polarity, Polarity::dark);
}

TEST(ContactRadii, AreTheSameForAnyNumberOfThreads) {
    const Folder folder;
    write_bytes(folder / "stack.tif", PlainTiff{}.bytes(growing(6)));
    const FrameSource source(folder / "stack.tif", options());
    EXPECT_EQ(as_csv(measure_contact_radii(source, {.threads = {1}})),
              as_csv(measure_contact_radii(source, {.threads = {3}})));
}

TEST(ContactRadii, KeepBadAndExcludedFramesWithTheirReasons) {
    const Folder folder;
    auto frames = growing(7);
    frames[4].setConstant(50);
    const auto bytes = PlainTiff{}.bytes(frames);
    write_bytes(folder / "stack.tif", bytes.substr(0, bytes.size() - 100));
    const auto radii =
        measure_contact_radii(FrameSource(folder / "stack.tif", options()), {.excluded = {{4, "glare, left"}}});
    EXPECT_EQ(radii.frames[3].contact.state, FrameState::excluded);
    EXPECT_EQ(radii.frames[3].contact.reason, "glare, left");
    EXPECT_EQ(radii.frames[4].contact.state, FrameState::bad_frame);
    EXPECT_EQ(radii.frames[6].contact.state, FrameState::bad_frame);
    EXPECT_TRUE(std::isnan(radii.frames[4].radius));
    EXPECT_NEAR(radii.frames[5].radius, true_radius(5) * pixel_size, 0.12 * pixel_size);
    EXPECT_EQ(radii.summary.bad, 2U);
    EXPECT_EQ(radii.summary.excluded, 1U);
    EXPECT_NE(as_csv(radii).find("# frame 4: excluded: glare, left\n"), std::string::npos);
}

TEST(ContactRadii, UseThePolarityOfTheMajorityOfFrames) {
    const Folder folder;
    std::vector<FramePixels> frames;
    for (int k = 0; k < 4; ++k) {
        auto frame = RenderedContact{.width = 110,
                                     .height = 80,
                                     .centre_x = 32.3,
                                     .centre_y = 40.6,
                                     .semi_major = 15,
                                     .noise = 6,
                                     .seed = static_cast<unsigned>(k + 1)}
                         .make();
        for (long i = 0; k == 2 && i < 80; ++i)
            for (long j = 56; j < 110; ++j)
                if (std::hypot(static_cast<double>(j) - 82, static_cast<double>(i) - 40) < 20)
                    frame(i, j) += 90;  // a reflection, brighter and larger
        frames.push_back(frame);
    }
    write_bytes(folder / "stack.tif", PlainTiff{}.bytes(frames));
    ASSERT_EQ(measure_contact_frame(frames[2]).polarity, Polarity::bright);
    const auto radii = measure_contact_radii(FrameSource(folder / "stack.tif", options()));
    EXPECT_EQ(radii.polarity, Polarity::dark);
    EXPECT_NEAR(radii.frames[2].contact.radius, 15, 0.15) << radii.frames[2].contact.reason;
}

TEST(ContactRadii, ReportMissingFramesAndKeepTheirTime) {
    const Folder folder;
    const auto frames = growing(6);
    for (std::size_t k = 0; k < 6; ++k)
        if (k != 3) write_bytes(folder / ("spot_" + std::to_string(k + 8) + ".png"), encoded(frames[k], ".png"));
    const auto radii = measure_contact_radii(FrameSource(folder.path(), options()));
    EXPECT_EQ(radii.summary.missing, 1U);
    EXPECT_DOUBLE_EQ(radii.frames[3].time, 4.0 / 20);
    EXPECT_NE(radii.notes.back().find("missing from the sequence: 11;"), std::string::npos) << radii.notes.back();
}

TEST(ContactRadii, AreReadBackAndMergedWithAForceRecord) {
    const Folder folder;
    write_bytes(folder / "stack.tif", PlainTiff{}.bytes(growing(6)));
    const auto radii =
        measure_contact_radii(FrameSource(folder / "stack.tif", options()), {.excluded = {{5, "glare"}}});
    bytes::write_whole_file(folder / "a.csv", as_csv(radii));
    const auto table = tables::read_table(folder / "a.csv");
    const auto written = as_table(radii);
    for (const auto* name : {"time", "contact_radius", "contact_radius_standard_error", "roundness"})
        for (Index i = 0; i < 6; ++i) {
            const double expected = written.at(name)[i];
            if (std::isnan(expected)) EXPECT_TRUE(std::isnan(table.at(name)[i])) << name << i;
            else EXPECT_DOUBLE_EQ(table.at(name)[i], expected) << name << i;
        }
    Table force;
    force.columns = {{"time", "s", Array1D::LinSpaced(101, 0.0, 0.5)},
                     {"force", "N", Array1D::Zero(101)},
                     {"displacement", "m", Array1D::Zero(101)}};
    const auto merged = tables::merged_by_time(force, table, 0.0);
    EXPECT_DOUBLE_EQ(merged.at("contact_radius")[30], radii.frames[3].radius);
}

TEST(ContactRadii, AreInCoordinatesOfTheWholePicture) {
    const Folder folder;
    write_bytes(folder / "stack.tif", PlainTiff{}.bytes(growing(6)));
    auto part = options();
    part.region = PictureRegion{14, 12, 62, 60};
    const auto whole = measure_contact_radii(FrameSource(folder / "stack.tif", options())),
               cut = measure_contact_radii(FrameSource(folder / "stack.tif", part));
    EXPECT_NEAR(cut.frames[5].contact.ellipse.centre_x, 44.2, 0.15);
    EXPECT_NEAR(cut.frames[5].contact.ellipse.centre_y, whole.frames[5].contact.ellipse.centre_y, 0.01);
}

TEST(ContactRadii, RequireAPixelSizeAndReasonsForExclusion) {
    const Folder folder;
    write_bytes(folder / "stack.tif", PlainTiff{}.bytes(growing(3)));
    EXPECT_THROW((void)measure_contact_radii(FrameSource(folder / "stack.tif", {.frame_rate = 20})), InvalidArgument);
    const FrameSource source(folder / "stack.tif", options());
    EXPECT_THROW((void)measure_contact_radii(source, {.excluded = {{2, " "}}}), InvalidArgument);
    EXPECT_THROW((void)measure_contact_radii(source, {.excluded = {{12, "glare"}}}), InvalidArgument);
}

TEST(Overlay, DrawsTheContactInColour) {
    const Folder folder;
    write_bytes(folder / "stack.tif", PlainTiff{}.bytes(growing(5)));
    const FrameSource source(folder / "stack.tif", options());
    const auto radii = measure_contact_radii(source);
    write_overlay(folder / "frame.png", source, 4, radii.frames[4]);
    const auto picture = png_pixels(folder / "frame.png");
    ASSERT_EQ(picture.cols, 8 * 90);
    const auto& ellipse = radii.frames[4].contact.ellipse;
    int coloured = 0;
    for (int k = 0; k < 90; ++k) {
        const double angle = 0.0698 * k;
        const auto place = [](double x) { return static_cast<int>(std::lround(8 * (x + 0.5) - 0.5)); };
        const auto at = picture(place(ellipse.centre_y + ellipse.semi_major * std::sin(angle)),
                                place(ellipse.centre_x + ellipse.semi_major * std::cos(angle)));
        coloured += at[2] > at[0] + 60 ? 1 : 0;
    }
    EXPECT_GT(coloured, 80);
}

}  // namespace
}  // namespace setae::imaging::tests::contact_radius_test
