// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/segments.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "setae/core/errors.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::segments_test {
namespace {

using tests::from;
using tests::piece;
using tests::SyntheticLoop;
using tests::with_noise;

Loop joined(const Loop& first, const Loop& second) {
    const auto both = [](const Array1D& a, const Array1D& b) {
        Array1D all(a.size() + b.size());
        all << a, b;
        return all;
    };
    return {.force = both(first.force, second.force),
            .displacement = both(first.displacement, second.displacement),
            .contact_radius = both(first.contact_radius, second.contact_radius)};
}

Loop without_radius(Loop loop) {
    loop.contact_radius = Array1D();
    return loop;
}

/// The message of what find_segments refuses.
template <class Exception>
std::string refusal(const Loop& loop, const SegmentOptions& options = {}) {
    try {
        (void)find_segments(loop, options);
    } catch (const Exception& error) {
        return error.what();
    }
    return "";
}

TEST(Segments, OfAnIdealLoopEndAtItsJumps) {
    const SyntheticLoop ideal{.samples = 400};
    for (const Loop& loop : {ideal.make(), without_radius(ideal.make())}) {
        const Segments segments = find_segments(loop);
        ASSERT_EQ(segments.contacts.size(), 1u);
        const ContactSegments& contact = segments.contacts[0];
        EXPECT_EQ(*contact.jump_in, (IndexRange{400, 401}));
        EXPECT_EQ(contact.loading, (IndexRange{401, 801}));
        EXPECT_EQ(contact.unloading->first, 801);
        ASSERT_TRUE(contact.pull_off.has_value());
        Index lowest = 0;
        loop.force.minCoeff(&lowest);
        EXPECT_EQ(contact.pull_off->first, lowest);
        EXPECT_EQ(contact.pull_off->last, 1203);
        EXPECT_FALSE(contact.hold.has_value());
        EXPECT_TRUE(segments.after.has_value());
        ASSERT_EQ(segments.cycles.size(), 1u);
        EXPECT_TRUE(segments.cycles[0].ends_in_pull_off);
    }
}

TEST(Segments, MeasureTheNoiseOfFreeFlight) {
    std::mt19937_64 generator(1);
    Loop loop = SyntheticLoop{.samples = 20000}.make();
    const Array1D deflection = with_noise(Array1D::Zero(loop.force.size()), 2e-9, generator);
    loop.force += 50.0 * deflection + 3e-4;
    loop.displacement -= deflection;
    const Baseline baseline = find_segments(loop).before;
    EXPECT_NEAR(baseline.force, 3e-4, 1e-8);
    EXPECT_NEAR(baseline.force_noise / 1e-7, 1.0, 0.05);
    EXPECT_NEAR(baseline.displacement_noise / 2e-9, 1.0, 0.05);
    EXPECT_NEAR(baseline.force_displacement_covariance / -2e-16, 1.0, 0.1);
}

TEST(Segments, FindAHold) {
    const Loop loop = SyntheticLoop{.samples = 400}.make();
    Loop held = piece(loop, 0, 802);
    Loop pause;
    pause.force = Array1D::Constant(100, held.force[801]);
    pause.displacement = Array1D::Constant(100, held.displacement[801]);
    pause.contact_radius = Array1D::Constant(100, held.contact_radius[801]);
    const Segments segments = find_segments(joined(joined(held, pause), from(loop, 802)));
    ASSERT_TRUE(segments.contacts[0].hold.has_value());
    EXPECT_LE(segments.contacts[0].hold->first, 801);
    EXPECT_GE(segments.contacts[0].hold->last, 901);
}

TEST(Segments, CountPartialReleasesAsCycles) {
    // up to the largest radius, back to 80 %, up again, then off
    SyntheticLoop shape{.samples = 400};
    const Loop whole = shape.make();
    tests::detail::Series middle;
    tests::detail::add_branch(middle, shape.approach, shape.largest_radius, 0.8 * shape.largest_radius, 100, false);
    tests::detail::add_branch(middle, shape.approach, 0.8 * shape.largest_radius, shape.largest_radius, 100, false);
    const Loop partial{.force = tests::detail::Series::array(middle.force),
                       .displacement = tests::detail::Series::array(middle.displacement),
                       .contact_radius = tests::detail::Series::array(middle.radius)};
    const Segments segments =
        find_segments(without_radius(joined(joined(piece(whole, 0, 802), partial), from(whole, 802))));
    ASSERT_EQ(segments.contacts.size(), 1u);
    ASSERT_EQ(segments.cycles.size(), 2u);
    EXPECT_FALSE(segments.cycles[0].ends_in_pull_off);
    EXPECT_TRUE(segments.cycles[1].ends_in_pull_off);
    EXPECT_NEAR(static_cast<double>(segments.cycles[0].unloading.last), 902.0, 1.0);
}

TEST(Segments, DistinguishASlipFromARelease) {
    Loop loop = without_radius(SyntheticLoop{.samples = 400}.make());
    // the contact slips at half the loading: force drops while the displacement goes on
    for (Index i = 650; i <= 801; ++i) loop.force[i] -= 0.1 * loop.force[801];
    EXPECT_EQ(find_segments(loop).cycles.size(), 1u);
}

TEST(Segments, SeparateSeveralContacts) {
    const Loop loop = SyntheticLoop{.samples = 400}.make();
    for (const Loop& record : {joined(loop, loop), without_radius(joined(loop, loop))}) {
        const Segments segments = find_segments(record);
        ASSERT_EQ(segments.contacts.size(), 2u);
        EXPECT_EQ(segments.cycles.size(), 2u);
        EXPECT_EQ(segments.contacts[1].loading.first - segments.contacts[0].loading.first, loop.force.size());
        EXPECT_EQ(segments.contacts[1].extent.first, segments.contacts[0].extent.last + 1);
        EXPECT_TRUE(segments.contacts[0].pull_off && segments.contacts[1].pull_off);
    }
}

TEST(Segments, HandleARecordWithoutRetraction) {
    const Segments segments = find_segments(without_radius(piece(SyntheticLoop{.samples = 400}.make(), 0, 802)));
    EXPECT_FALSE(segments.contacts[0].unloading.has_value());
    EXPECT_FALSE(segments.after.has_value());
    EXPECT_TRUE(segments.cycles.empty());
}

TEST(Segments, UseTheGivenZeroIfAllSamplesAreInContact) {
    const Loop loop = SyntheticLoop{.samples = 400}.make();
    const Segments segments = find_segments(piece(loop, 401, 801));
    EXPECT_FALSE(segments.before.range.has_value());
    EXPECT_EQ(segments.contacts[0].loading.first, 0);
}

TEST(Segments, RefuseAConstantForce) {
    Loop loop = SyntheticLoop{}.make();
    loop.force.setConstant(2e-4);
    EXPECT_NE(refusal<UndefinedDataError>(loop).find("constant"), std::string::npos);
}

TEST(Segments, RefuseNoiseOnly) {
    std::mt19937_64 generator(5);
    Loop loop = without_radius(SyntheticLoop{}.make());
    loop.force = with_noise(Array1D::Zero(loop.force.size()), 1e-7, generator);
    EXPECT_NE(refusal<UndefinedDataError>(loop).find("noise"), std::string::npos);
}

TEST(Segments, RefuseASlowDrift) {
    std::mt19937_64 generator(6);
    Loop loop = without_radius(SyntheticLoop{}.make());
    const Index n = loop.force.size();
    const Array1D drift = Array1D::LinSpaced(n, 0.0, 1.0).square() * 1e-3;
    loop.displacement = Array1D::LinSpaced(n, 0.0, 1e-5);
    loop.force = with_noise(drift, 1e-8, generator);
    EXPECT_NE(refusal<UndefinedDataError>(loop).find("no adhesive contact"), std::string::npos);
}

TEST(Segments, RefuseADisplacementEqualToTheDeflection) {
    // the stage stands still: the displacement is the deflection with its sign turned
    Loop loop = without_radius(SyntheticLoop{}.make());
    loop.displacement = -loop.force / 3.0;
    EXPECT_NE(refusal<UndefinedDataError>(loop).find("check the signs"), std::string::npos)
        << refusal<UndefinedDataError>(loop);
}

TEST(Segments, RefuseAStartInContact) {
    const Loop loop = without_radius(SyntheticLoop{.samples = 400}.make());
    EXPECT_NE(refusal<UndefinedDataError>(from(loop, 500), {.baseline_share = 0.2}).find("not free flight"),
              std::string::npos);
}

TEST(Segments, RefuseARadiusThatIsNeverPositive) {
    Loop loop = SyntheticLoop{}.make();
    loop.contact_radius.setZero();
    EXPECT_NE(refusal<UndefinedDataError>(loop).find("never > 0"), std::string::npos);
}

TEST(Segments, RefuseImpossibleSeries) {
    Loop loop = SyntheticLoop{}.make();
    loop.displacement.conservativeResize(10);
    EXPECT_NE(refusal<InvalidArgument>(loop).find("displacement has 10 samples"), std::string::npos);
    loop = SyntheticLoop{}.make();
    loop.force[17] = undefined;
    EXPECT_NE(refusal<InvalidArgument>(loop).find("sample 17"), std::string::npos);
    EXPECT_NE(refusal<InvalidArgument>(piece(SyntheticLoop{}.make(), 0, 3)).find("at least"), std::string::npos);
    const std::string missing = refusal<InvalidArgument>({.force = Array1D::Zero(100)});
    EXPECT_NE(missing.find("displacement or contact radius"), std::string::npos);
}

TEST(LoopFromTable, UsesTheStandardColumns) {
    const Table table{.columns = {{"force", "N", Array1D::Ones(3)}, {"contact_radius", "m", Array1D::Ones(3)}}};
    const Loop loop = loop_from_table(table);
    EXPECT_EQ(loop.contact_radius.size(), 3);
    EXPECT_EQ(loop.displacement.size(), 0);
    EXPECT_THROW((void)loop_from_table({.columns = {{"force", "N", Array1D::Ones(3)}}}), InvalidArgument);
    EXPECT_THROW((void)loop_from_table({.columns = {{"displacement", "m", Array1D::Ones(3)}}}), InvalidArgument);
}

}  // namespace
}  // namespace setae::loops::segments_test
