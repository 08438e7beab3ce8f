// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/traced_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>
#include <vector>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/topography/contour.hpp"
#include "setae/topography/detrend.hpp"
#include "setae/topography/line_scans.hpp"

namespace setae::topography::traced_curve_test {
namespace {

Array1D array(const std::vector<double>& values) {
    return Eigen::Map<const Array1D>(values.data(), static_cast<Index>(values.size()));
}

TracedCurve curve_of(const std::vector<double>& x, const std::vector<double>& y) {
    TracedCurve curve;
    curve.x = array(x);
    curve.y = array(y);
    return curve;
}

TracedCurve turned(TracedCurve curve, double angle) {
    const Array1D x = curve.x, y = curve.y;
    curve.x = 3.0 + x * std::cos(angle) - y * std::sin(angle);
    curve.y = -1.0 + x * std::sin(angle) + y * std::cos(angle);
    return curve;
}

/// Flat ground with a mushroom: stem from x = 4 to 5, hat from 3 to 6 between y = 1 and 2, ground at 0 from 0 to 9.
TracedCurve mushroom() { return curve_of({0, 4, 4, 3, 3, 6, 6, 5, 5, 9}, {0, 0, 1, 1, 2, 2, 1, 1, 0, 0}); }

/// Many points along a polyline, `step` apart.
TracedCurve densely(const TracedCurve& corners, double step) {
    std::vector<double> x, y;
    for (Index i = 0; i + 1 < corners.x.size(); ++i) {
        const double length = std::hypot(corners.x[i + 1] - corners.x[i], corners.y[i + 1] - corners.y[i]);
        const int pieces = static_cast<int>(std::lround(length / step));
        for (int k = 0; k < pieces; ++k) {
            x.push_back(corners.x[i] + (corners.x[i + 1] - corners.x[i]) * k / pieces);
            y.push_back(corners.y[i] + (corners.y[i + 1] - corners.y[i]) * k / pieces);
        }
    }
    x.push_back(corners.x.tail(1)[0]);
    y.push_back(corners.y.tail(1)[0]);
    return curve_of(x, y);
}

double height_at(const Profile& profile, double x) {
    Index i = 0;
    while (i + 2 < profile.positions.size() && profile.positions[i + 1] < x) ++i;
    const double t = (x - profile.positions[i]) / (profile.positions[i + 1] - profile.positions[i]);
    return profile.heights[i] + t * (profile.heights[i + 1] - profile.heights[i]);
}

TEST(Levelled, RotatesASineFromAnyDirection) {
    const Index n = 2001;
    TracedCurve sine;
    sine.x = Array1D::LinSpaced(n, 0.0, 20.0 * pi);
    sine.y = 0.3 * sine.x.cos();  // symmetric about its middle: the mean line has no slope
    for (const double angle : {0.0, 0.4, pi / 2.0, 2.5, pi, -1.2, -pi / 2.0}) {
        const auto level = levelled(turned(sine, angle), Reentrance::envelope);
        EXPECT_NEAR(std::remainder(level.rotation + angle, 2.0 * pi), 0.0, 1e-12) << angle;
        EXPECT_TRUE(level.alerts.empty());
        ASSERT_EQ(level.profile.positions.size(), n);
        EXPECT_EQ(level.profile.positions[0], 0.0);
        EXPECT_LT((level.profile.positions - sine.x).abs().maxCoeff(), 1e-11) << angle;
        EXPECT_LT((level.profile.heights - sine.y).abs().maxCoeff(), 1e-11) << angle;
    }
}

TEST(Levelled, FitsTheMeanLineByPerpendicularDistance) {
    // a zigzag of half a right angle: the line through the middles of its sides
    const auto level = levelled(turned(curve_of({0, 1, 2, 3, 4}, {0.5, -0.5, 0.5, -0.5, 0.5}), 0.3), Reentrance::cut);
    EXPECT_NEAR(level.rotation, -0.3, 1e-12);
    EXPECT_NEAR(level.profile.heights[0], 0.5, 1e-12);
    EXPECT_NEAR(level.profile.size(), 4.0, 1e-12);
}

TEST(Levelled, SteepHillIsRotatedByItsEnds) {
    const auto level = levelled(turned(curve_of({0, 0.9, 1.1, 2}, {0, 9, 9, 0}), 1.0), Reentrance::cut);
    EXPECT_NEAR(level.rotation, -1.0, 1e-12);
}

TEST(Envelope, OfAMushroomHidesBothUndersidesAndTheStem) {
    const auto level = levelled(densely(mushroom(), 0.1), Reentrance::envelope);
    // left: ground under the hat 1, stem 1, underside 1, its edge is a wall; right the same
    ASSERT_EQ(level.reentrant.size(), 2u);
    EXPECT_NEAR(level.reentrant[0].depth, 1.0, 1e-9);
    EXPECT_NEAR(level.reentrant[1].depth, 1.0, 1e-9);
    EXPECT_NEAR(level.reentrant[0].begin, 3.0, 1e-9);
    EXPECT_NEAR(level.reentrant[0].end, 7.0, 1e-9);  // the edge of the hat is over one x: hidden with the part that it
                                                     // ends
    EXPECT_NEAR(level.reentrant_share, 8.0 / 17.0, 1e-9);
    ASSERT_EQ(level.alerts.size(), 1u);
    EXPECT_EQ(level.alerts[0].code, "REENTRANT");
    EXPECT_NE(level.alerts[0].message.find("47 %"), std::string::npos) << level.alerts[0].message;
    const double ground = height_at(level.profile, 1.0), hat = height_at(level.profile, 4.5);
    EXPECT_NEAR(hat - ground, 2.0, 1e-9);
    EXPECT_NEAR(height_at(level.profile, 3.01) - ground, 2.0, 1e-9);
    EXPECT_NEAR(height_at(level.profile, 5.99) - ground, 2.0, 1e-9);
    // a jump is a slope over one mean step, on the lower side
    EXPECT_NEAR(height_at(level.profile, 2.89) - ground, 0.0, 1e-9);
    EXPECT_NO_THROW(validate(level.profile));
}

TEST(Envelope, HasAPointWhereBranchesCross) {
    // a flank overhangs and returns to a slope below it
    const auto level = levelled(curve_of({0, 4, 3, 5, 8}, {0, 0, 1, 3, -1}), Reentrance::envelope);
    ASSERT_FALSE(level.reentrant.empty());
    const Profile& profile = level.profile;
    EXPECT_NO_THROW(validate(profile));
    // rotated back explicitly: highest over some x of the rotated polyline
    const double c = std::cos(level.rotation), s = std::sin(level.rotation);
    const Array1D x = array({0, 4, 3, 5, 8}), y = array({0, 0, 1, 3, -1});
    const Array1D u = x * c - y * s, v = x * s + y * c;
    const auto highest = [&](double at) {
        double top = -1e9;
        for (Index i = 0; i + 1 < u.size(); ++i)
            if (std::min(u[i], u[i + 1]) <= at && at <= std::max(u[i], u[i + 1]))
                top = std::max(top, v[i] + (v[i + 1] - v[i]) * (at - u[i]) / (u[i + 1] - u[i]));
        return top;
    };
    const double offset = highest(u[0] + 0.5) - height_at(profile, 0.5);
    for (const double at : {0.5, 1.0, 2.0, 4.2, 5.0, 6.0, 7.0})
        EXPECT_NEAR(height_at(profile, at), highest(u[0] + at) - offset, 1e-12) << at;
}

TEST(ReentranceCut, EqualsCleanContour) {
    const auto trace = densely(mushroom(), 0.1);
    const auto level = levelled(trace, Reentrance::cut);
    const auto clean = clean_contour({trace.x, trace.y, {}});
    ASSERT_EQ(level.profile.positions.size(), clean.profile.positions.size());
    EXPECT_LT((level.profile.positions - clean.profile.positions).abs().maxCoeff(), 1e-9);
    EXPECT_NEAR(level.reentrant_share, clean.reentrant_share, 0.02);  // this also removes walls, as repeated points
    EXPECT_NEAR(level.reentrant[0].depth, 1.0, 1e-9);
}

TEST(Levelled, NoiseOnASteepFlankIsNotAnOverhang) {
    // a wall inclined by a twentieth of a step per step, with noise of a third of a step: it turns back frequently
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    auto wall = densely(curve_of({0, 20, 20.5, 40.5}, {0, 0, 10, 10}), 0.2);
    const Index n = wall.x.size();
    for (Index i = 0; i < n; ++i) {
        wall.x[i] += 0.07 * normal(random);
        wall.y[i] += 0.07 * normal(random);
    }
    const auto as_exact = levelled(wall, Reentrance::envelope);
    EXPECT_FALSE(as_exact.reentrant.empty());
    wall.standard_error = Array1D::Constant(n, 0.07);
    for (const auto reentrance : {Reentrance::envelope, Reentrance::cut}) {
        const auto level = levelled(wall, reentrance);
        EXPECT_TRUE(level.reentrant.empty()) << level.reentrant.size();
        EXPECT_TRUE(level.alerts.empty());
        EXPECT_EQ(level.reentrant_share, 0.0);
        EXPECT_NO_THROW(validate(level.profile));
    }
}

TEST(Levelled, OverhangsDeeperThanNoiseAreFoundInNoise) {
    auto trace = densely(mushroom(), 0.05);
    std::mt19937 random(6);
    std::normal_distribution<double> normal;
    for (Index i = 0; i < trace.x.size(); ++i) {
        trace.x[i] += 0.02 * normal(random);
        trace.y[i] += 0.02 * normal(random);
    }
    trace.standard_error = Array1D::Constant(trace.x.size(), 0.02);
    const auto level = levelled(trace, Reentrance::envelope);
    ASSERT_EQ(level.reentrant.size(), 2u);
    EXPECT_NEAR(level.reentrant[0].depth, 1.0, 0.1);             // five standard errors
    EXPECT_NEAR(level.reentrant_share, 7.0 / 17.0, 1.2 / 17.0);  // either edge of the hat may be partly visible
}

TEST(Levelled, ClosedOutlineIsProjectedFromAboveWithoutRotation) {
    TracedCurve circle;
    circle.closed = true;
    const Index n = 400;
    const Array1D angle = Array1D::LinSpaced(n, 1.0, 1.0 - 2.0 * pi * (n - 1) / n);  // clockwise: vacuum outside
    circle.x = 2.0 * angle.cos() + 7.0;
    circle.y = 2.0 * angle.sin();
    const auto level = levelled(circle, Reentrance::envelope);
    EXPECT_EQ(level.rotation, 0.0);
    ASSERT_EQ(level.alerts.size(), 1u);
    EXPECT_EQ(level.alerts[0].code, "CLOSED_OUTLINE");
    EXPECT_NE(level.alerts[0].message.find("50 %"), std::string::npos) << level.alerts[0].message;
    EXPECT_NEAR(level.profile.size(), 4.0, 1e-3);
    // the mean height of a half circle is 2R/π above its middle
    EXPECT_NEAR(height_at(level.profile, 0.5 * level.profile.size()), 2.0 - 4.0 / pi, 1e-3);
    circle.x = circle.x.reverse().eval();
    circle.y = circle.y.reverse().eval();
    const auto pore = levelled(circle, Reentrance::envelope);  // vacuum inside: its floor
    EXPECT_NEAR(height_at(pore.profile, 0.5 * pore.profile.size()), -2.0 + 4.0 / pi, 1e-3);
}

TEST(Levelled, ConvertsErrorsAlongTheNormalToErrorsOfHeight) {
    auto roof = curve_of({0, 1, 2, 3, 4, 5, 6, 7, 8}, {0, 1, 2, 3, 4, 3, 2, 1, 0});
    roof.standard_error = Array1D::Constant(9, 0.01);
    roof.response = TraceResponse{0.3, 0.5, 0.1, 1e-3};
    const auto profile = levelled(roof, Reentrance::cut).profile;
    EXPECT_NEAR(profile.standard_error[0], 0.01 * std::sqrt(2.0), 1e-15);
    EXPECT_NEAR(profile.standard_error[4], 0.01, 1e-15);  // over five points the ridge is level
    ASSERT_TRUE(profile.response);
    EXPECT_NEAR(profile.response->blur, 0.3 / std::sqrt(2.0), 1e-14);
    EXPECT_NEAR(profile.response->smoothing_length, 0.5 / std::sqrt(2.0), 1e-14);
    EXPECT_NEAR(profile.response->step, 0.1 / std::sqrt(2.0), 1e-14);
    EXPECT_NEAR(profile.response->noise_density, 1e-3 * std::sqrt(2.0), 1e-14);
}

TEST(Levelled, LimitsErrorsAtVerticalWalls) {
    auto step = densely(curve_of({0, 10, 10, 20}, {0, 0, 5, 5}), 0.5);
    step.standard_error = Array1D::Constant(step.x.size(), 0.01);
    const auto profile = levelled(step, Reentrance::envelope).profile;
    EXPECT_GT(profile.standard_error.maxCoeff(), 0.02);
    EXPECT_LE(profile.standard_error.maxCoeff(), 0.1 + 1e-15);
}

TEST(Levelled, NoiseAlongNormalsHasTheStatedDensityAlongTheHeight) {
    // a rough curve of rms slope about 0.8, sampled at equal lengths, displaced along its normals
    const auto shape = [](double x) {
        return 0.5 * std::sin(x) + 0.3 * std::sin(2.7 * x + 1.0) + 0.1 * std::sin(5.3 * x + 2.0);
    };
    std::vector<double> xs, ys;
    const double step = 0.05, extent = 120.0;
    double to_next = 0.0;
    for (double x = 0.0; x <= extent; x += 1e-4) {
        to_next -= std::hypot(1e-4, shape(x) - shape(x - 1e-4));
        if (to_next > 0.0) continue;
        xs.push_back(x);
        ys.push_back(shape(x));
        to_next += step;
    }
    auto truth = curve_of(xs, ys);
    const double sigma = 0.004;
    truth.response = TraceResponse{0.0, 0.0, step, sigma * sigma * step};
    const auto exact = levelled(truth, Reentrance::envelope);
    const Index n = truth.x.size();
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    // C1D of the difference between noisy and true heights, over modes far below the step of the points
    double power = 0.0;
    const int runs = 40, modes = 60;
    for (int run = 0; run < runs; ++run) {
        auto noisy = truth;
        for (Index i = 0; i < n; ++i) {
            const Index a = std::max<Index>(0, i - 1), b = std::min(n - 1, i + 1);
            const double dx = truth.x[b] - truth.x[a], dy = truth.y[b] - truth.y[a], shift = sigma * normal(random);
            noisy.x[i] -= shift * dy / std::hypot(dx, dy);
            noisy.y[i] += shift * dx / std::hypot(dx, dy);
        }
        const double length = truth.x[n - 1];
        for (int k = 1; k <= modes; ++k) {
            // ∫ h e^{−iqx} dx along both, by the trapezoidal rule over points: steps are far below 1/q
            std::complex<double> sum;
            const double q = 2.0 * pi * k / length;
            for (Index i = 0; i + 1 < n; ++i) {
                const auto area = [&](const TracedCurve& c) {
                    return 0.5 * (c.y[i] + c.y[i + 1]) * (c.x[i + 1] - c.x[i]) *
                           std::polar(1.0, -q * 0.5 * (c.x[i] + c.x[i + 1]));
                };
                sum += area(noisy) - area(truth);
            }
            power += std::norm(sum) / length;
        }
    }
    power /= runs * modes;
    const double stated = exact.profile.response->noise_density;
    EXPECT_GT(stated / (sigma * sigma * step), 1.2);
    EXPECT_NEAR(power / stated, 1.0, 4.0 / std::sqrt(runs * modes));  // exponential values, independent
}

TEST(Levelled, RefusesInvalidCurves) {
    EXPECT_THROW((void)levelled(curve_of({0, 1}, {0}), Reentrance::cut), InvalidArgument);
    EXPECT_THROW((void)levelled(curve_of({1}, {1}), Reentrance::cut), UndefinedDataError);
    EXPECT_THROW((void)levelled(curve_of({1, 1, 1}, {2, 2, 2}), Reentrance::envelope), UndefinedDataError);
    EXPECT_THROW((void)levelled(curve_of({1, undefined, 1}, {2, 2, undefined}), Reentrance::envelope),
                 UndefinedDataError);
}

TEST(ParametricStatistics, OfAStraightLineAreZero) {
    const auto statistics = parametric_statistics(turned(curve_of({0, 1, 3, 7}, {0, 0, 0, 0}), 2.0));
    EXPECT_NEAR(statistics.length, 7.0, 1e-14);
    EXPECT_NEAR(statistics.tortuosity, 1.0, 1e-14);
    EXPECT_NEAR(statistics.rms_normal_distance, 0.0, 1e-7);  // root of rounding
    EXPECT_NEAR(statistics.rms_angle, 0.0, 1e-12);
    EXPECT_NEAR(statistics.rms_curvature, 0.0, 1e-12);
    EXPECT_EQ(statistics.reentrant_share, 0.0);
}

TEST(ParametricStatistics, OfAZigzagFollowFromItsAngle) {
    std::vector<double> x, y;
    for (int i = 0; i <= 400; ++i) {
        x.push_back(i);
        y.push_back(i % 2 == 0 ? 0.5 : -0.5);
    }
    const auto statistics = parametric_statistics(curve_of(x, y));
    EXPECT_NEAR(statistics.tortuosity, std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(statistics.rms_angle, pi / 4.0, 1e-12);
    EXPECT_NEAR(statistics.rms_normal_distance, 1.0 / std::sqrt(12.0), 1e-12);
    EXPECT_NEAR(statistics.rms_curvature, 0.5 * pi / std::sqrt(2.0), 1e-12);  // a right angle per side
}

TEST(ParametricStatistics, OfACircularArcAreClosedForms) {
    const double radius = 2.0, opening = 0.7;
    const Index n = 4001;
    const Array1D angle = Array1D::LinSpaced(n, 0.5 * pi + opening, 0.5 * pi - opening);
    TracedCurve arc;
    arc.x = radius * angle.cos();
    arc.y = radius * angle.sin();
    const auto statistics = parametric_statistics(turned(arc, -2.0));
    EXPECT_NEAR(statistics.length, 2.0 * opening * radius, 1e-6);
    EXPECT_NEAR(statistics.tortuosity, opening / std::sin(opening), 1e-7);
    EXPECT_NEAR(statistics.rms_angle, opening / std::sqrt(3.0), 1e-6);
    EXPECT_NEAR(statistics.rms_curvature, 1.0 / radius, 1e-7);
    const double mean = std::sin(opening) / opening,
                 mean_square = 0.5 * (1.0 + std::sin(2.0 * opening) / (2.0 * opening));
    EXPECT_NEAR(statistics.rms_normal_distance, radius * std::sqrt(mean_square - mean * mean), 1e-6);
}

TEST(ParametricStatistics, OfAClosedCircleAreClosedForms) {
    TracedCurve circle;
    circle.closed = true;
    const Index n = 1000;
    const Array1D angle = Array1D::LinSpaced(n, 0.0, -2.0 * pi * (n - 1) / n);
    circle.x = 3.0 * angle.cos();
    circle.y = 3.0 * angle.sin();
    const auto statistics = parametric_statistics(circle);
    EXPECT_NEAR(statistics.length, 6.0 * pi, 1e-3);
    EXPECT_TRUE(std::isnan(statistics.tortuosity));
    EXPECT_NEAR(statistics.rms_normal_distance, 3.0 / std::sqrt(2.0), 1e-3);
    EXPECT_NEAR(statistics.rms_curvature, 1.0 / 3.0, 1e-5);
}

TEST(ParametricStatistics, IncludeHiddenStretches) {
    EXPECT_NEAR(parametric_statistics(mushroom()).reentrant_share,
                levelled(mushroom(), Reentrance::envelope).reentrant_share, 0.0);
    EXPECT_GT(parametric_statistics(mushroom()).reentrant_share, 0.3);
}

Profile with_errors() {
    Profile profile{array({0, 1, 2, 3, 4}), array({0, 1, 0, 2, 0}), {}};
    profile.standard_error = array({0.1, 0.2, 0.3, 0.4, 0.5});
    profile.response = TraceResponse{1.0, 2.0, 0.5, 3.0};
    return profile;
}

TEST(ProfileErrors, StayAssignedToTheirPointsAfterCleaning) {
    auto profile = with_errors();
    profile.positions[2] = 0.5;
    profile.positions.reverseInPlace();
    const auto clean = clean_contour(profile).profile;
    ASSERT_EQ(clean.standard_error.size(), 4);
    EXPECT_EQ(clean.standard_error[0], 0.5);
    EXPECT_EQ(clean.standard_error[1], 0.4);
    EXPECT_EQ(clean.standard_error[2], 0.2);
    ASSERT_TRUE(clean.response);
    EXPECT_EQ(clean.response->noise_density, 3.0);
    profile.standard_error = array({1, 2});
    EXPECT_THROW((void)clean_contour(profile), InvalidArgument);
}

TEST(ProfileErrors, AreNotDetrendedButScaled) {
    const auto flat = detrended(with_errors(), Trend::tilt);
    EXPECT_TRUE((flat.standard_error == with_errors().standard_error).all());
    const auto doubled = std::get<Profile>(scaled(flat, -2.0));
    EXPECT_TRUE((doubled.standard_error == 2.0 * flat.standard_error).all());
    EXPECT_EQ(doubled.response->noise_density, 12.0);
    EXPECT_EQ(doubled.response->blur, 1.0);
}

TEST(ProfileErrors, PreventConversionToALineScan) {
    auto profile = with_errors();
    EXPECT_FALSE(to_line_scan(profile));
    profile.standard_error = Array1D();
    EXPECT_FALSE(to_line_scan(profile));
    profile.response.reset();
    EXPECT_TRUE(to_line_scan(profile));
}

TEST(ProfileErrors, AreValidated) {
    EXPECT_NO_THROW(validate(with_errors()));
    auto short_errors = with_errors(), negative = with_errors(), no_step = with_errors();
    short_errors.standard_error = array({1, 2});
    negative.standard_error[3] = -1.0;
    no_step.response->step = 0.0;
    for (const auto& bad : {short_errors, negative, no_step}) EXPECT_THROW(validate(bad), InvalidArgument);
}

}  // namespace
}  // namespace setae::topography::traced_curve_test
