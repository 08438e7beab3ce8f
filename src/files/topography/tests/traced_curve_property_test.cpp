// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "setae/topography/traced_curve.hpp"

namespace setae::topography::traced_curve_property_test {
namespace {

/// Whether two segments have a point in common that is not the joint of neighbours.
bool crosses_itself(const TracedCurve& curve) {
    const auto side = [&](Index a, Index b, Index c) {
        return (curve.x[b] - curve.x[a]) * (curve.y[c] - curve.y[a]) -
                   (curve.y[b] - curve.y[a]) * (curve.x[c] - curve.x[a]) >
               0.0;
    };
    for (Index i = 0; i + 1 < curve.x.size(); ++i)
        for (Index j = i + 2; j + 1 < curve.x.size(); ++j)
            if (side(i, i + 1, j) != side(i, i + 1, j + 1) && side(j, j + 1, i) != side(j, j + 1, i + 1)) return true;
    return false;
}

TracedCurve walk(std::uint64_t seed, Index points) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(-1.0, 1.0);
    TracedCurve curve;
    curve.x = curve.y = Array1D::Zero(points);
    for (Index i = 1; i < points; ++i) {
        const bool inside = i > 3 && i + 3 < points;
        curve.x[i] = curve.x[i - 1] + 0.6 + (inside ? 0.9 : 0.3) * part(random);
        curve.y[i] = 0.9 * curve.y[i - 1] + part(random);
    }
    return curve;
}

/// A walk to the right that turns back at times and does not cross itself.
TracedCurve wandering(std::uint64_t seed, Index points) {
    auto curve = walk(seed, points);
    while (crosses_itself(curve)) curve = walk(++seed, points);
    return curve;
}

TracedCurve turned(TracedCurve curve, double angle) {
    const Array1D x = curve.x, y = curve.y;
    curve.x = x * std::cos(angle) - y * std::sin(angle) + 5.0;
    curve.y = x * std::sin(angle) + y * std::cos(angle) - 2.0;
    return curve;
}

double height_at(const Profile& profile, double x) {
    const auto above =
        std::upper_bound(profile.positions.begin() + 1, profile.positions.end() - 1, x) - profile.positions.begin();
    const double t = (x - profile.positions[above - 1]) / (profile.positions[above] - profile.positions[above - 1]);
    return profile.heights[above - 1] + t * (profile.heights[above] - profile.heights[above - 1]);
}

RC_GTEST_PROP(Levelled, IsInvariantUnderRotation, ()) {
    const auto curve = wandering(*rc::gen::arbitrary<std::uint64_t>(), *rc::gen::inRange(20, 60));
    const double angle = 0.01 * *rc::gen::inRange(-314, 314);
    for (const auto reentrance : {Reentrance::envelope, Reentrance::cut}) {
        const auto one = levelled(curve, reentrance), other = levelled(turned(curve, angle), reentrance);
        RC_ASSERT(one.profile.positions.size() == other.profile.positions.size());
        RC_ASSERT((one.profile.positions - other.profile.positions).abs().maxCoeff() < 1e-9);
        RC_ASSERT((one.profile.heights - other.profile.heights).abs().maxCoeff() < 1e-9);
        RC_ASSERT(std::abs(one.reentrant_share - other.reentrant_share) < 1e-9);
    }
}

RC_GTEST_PROP(Envelope, IsTheMaximumOfTheCurveAwayFromJumps, ()) {
    const Index points = *rc::gen::inRange(20, 60);
    const auto curve = wandering(*rc::gen::arbitrary<std::uint64_t>(), points);
    const auto level = levelled(curve, Reentrance::envelope);
    const auto& profile = level.profile;
    validate(profile);
    RC_ASSERT(level.reentrant_share >= 0.0 && level.reentrant_share <= 1.0);
    // the curve after the same rotation; the profile begins at its first visible x
    const double c = std::cos(level.rotation), s = std::sin(level.rotation);
    const Array1D x = curve.x * c - curve.y * s, y = curve.x * s + curve.y * c;
    const auto highest = [&](double at) {
        double highest_there = -1e300;
        for (Index i = 0; i + 1 < points; ++i)
            if (std::min(x[i], x[i + 1]) <= at && at <= std::max(x[i], x[i + 1]) && x[i] != x[i + 1])
                highest_there = std::max(highest_there, y[i] + (y[i + 1] - y[i]) * ((at - x[i]) / (x[i + 1] - x[i])));
        return highest_there;
    };
    // heights are about the centroid of the length of the curve; the summit of the profile is a point of the curve
    const Index n = points - 1;
    const Array1D length = ((x.tail(n) - x.head(n)).square() + (y.tail(n) - y.head(n)).square()).sqrt();
    const double shift_y = (0.5 * (y.tail(n) + y.head(n)) * length).sum() / length.sum();
    Index summit = 0, point = 0;
    const double top = profile.heights.maxCoeff(&summit) + shift_y;
    RC_PRE((y - top).abs().minCoeff(&point) < 1e-9);  // no summit is removed with an end
    const double shift_x = x[point] - profile.positions[summit];
    // each overhang causes one jump, which is a slope over one mean step of the envelope
    int apart = 0;
    constexpr int places = 200;
    for (int k = 1; k < places; ++k) {
        const double at = profile.size() * k / places,
                     departure = height_at(profile, at) + shift_y - highest(at + shift_x);
        apart += std::abs(departure) > 1e-9 ? 1 : 0;
    }
    const double step = 1.0 / static_cast<double>(profile.positions.size() - 1);
    RC_ASSERT(apart <= 2 + places * 1.5 * step * static_cast<double>(level.reentrant.size()));
}

RC_GTEST_PROP(ParametricStatistics, AreInvariantUnderRotation, ()) {
    const auto curve = wandering(*rc::gen::arbitrary<std::uint64_t>(), *rc::gen::inRange(20, 60));
    const auto one = parametric_statistics(curve),
               other = parametric_statistics(turned(curve, 0.01 * *rc::gen::inRange(-314, 314)));
    RC_ASSERT(std::abs(one.length / other.length - 1.0) < 1e-12);
    RC_ASSERT(std::abs(one.tortuosity / other.tortuosity - 1.0) < 1e-9);
    RC_ASSERT(std::abs(one.rms_normal_distance - other.rms_normal_distance) < 1e-9);
    RC_ASSERT(std::abs(one.rms_angle - other.rms_angle) < 1e-9);
    RC_ASSERT(std::abs(one.rms_curvature / other.rms_curvature - 1.0) < 1e-9);
}

}  // namespace
}  // namespace setae::topography::traced_curve_property_test
