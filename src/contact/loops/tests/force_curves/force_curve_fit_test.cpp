// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/force_curve_summary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>

#include "setae/contact/dmt.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/errors.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::force_curve_fit_test {
namespace {

using contact::AdhesiveContact;

constexpr AdhesiveContact gel{.radius = 5e-6, .contact_modulus = 8e3, .work_of_adhesion = 1e-4};
constexpr double first_touch = 1.3e-6;

LensAndCounterBody tip_on_gel() {
    return {.radius = gel.radius,
            .lens_poisson_ratio = 0.5,
            .counter_youngs_modulus = std::numeric_limits<double>::infinity()};
}

/// Approach from 1.3 µm above, retraction along another law; a constant and a slope under both.
Table curve(const std::function<double(double)>& approach, const std::function<double(double)>& retract,
            double noise = 0.0, Index n = 600) {
    std::mt19937_64 generator(4);
    const Array1D way = Array1D::LinSpaced(n, 0.0, 2.1e-6);
    Array1D displacement(2 * n), force(2 * n), segment(2 * n);
    displacement << way, way.reverse();
    segment << Array1D::Zero(n), Array1D::Ones(n);
    for (Index i = 0; i < 2 * n; ++i) force[i] = (i < n ? approach : retract)(displacement[i] - first_touch);
    if (noise > 0.0) force = tests::with_noise(force, noise, generator);
    force += 3e-10 + 1e-4 * displacement;
    return {.columns = {{"force", "N", force}, {"displacement", "m", displacement}, {"segment", "1", segment}},
            .metadata = {{"segments", "extend, retract"}}};
}

double dry_force(double depth) {
    return depth > 0.0 ? 4.0 / 3.0 * gel.contact_modulus * std::sqrt(gel.radius) * std::pow(depth, 1.5) : 0.0;
}

double sticky_force(double depth) {
    const double force = contact::jkr::force_at_displacement(depth, gel);
    return std::isnan(force) ? 0.0 : force;
}

TEST(ForceCurve, SplitsIntoSegmentsAndSubtractsTheBaseline) {
    const std::vector<CurveSegment> segments = segments_of_curve(curve(dry_force, sticky_force));
    ASSERT_EQ(segments.size(), 2U);
    EXPECT_EQ(segments[0].name, "extend");
    EXPECT_EQ(segments[1].name, "retract");
    EXPECT_NEAR(segments[0].baseline.slope / 1e-4, 1.0, 1e-6);
    EXPECT_LT(segments[0].force.head(100).abs().maxCoeff(), 1e-18);
    const double step = 2.1e-6 / 599.0;
    EXPECT_NEAR(segments[0].contact_point, first_touch, 2.0 * step);
    EXPECT_EQ(segments[0].smallest_force, 0.0);
    const auto pull_off = contact::jkr::pull_off_at_fixed_load(gel);
    EXPECT_NEAR(segments[1].smallest_force / pull_off.force, 1.0, 0.01);  // between two samples
}

TEST(ForceCurve, WithoutSegmentsIsSplitAtTheLargestForce) {
    Table table = curve(dry_force, sticky_force);
    table.columns.pop_back();
    table.metadata.clear();
    const std::vector<CurveSegment> segments = segments_of_curve(table);
    ASSERT_EQ(segments.size(), 2U);
    EXPECT_EQ(segments[0].name, "approach");
    EXPECT_EQ(segments[1].name, "retract");
}

TEST(ForceCurve, HertzIsRecoveredFromNoiseFreeApproach) {
    const CurveSegment segment = segments_of_curve(curve(dry_force, sticky_force)).front();
    const ForceCurveFit fit = fit_force_curve(segment, tip_on_gel());
    EXPECT_TRUE(fit.converged);
    EXPECT_NEAR(fit.contact_modulus.value / gel.contact_modulus, 1.0, 1e-8);
    EXPECT_NEAR(fit.youngs_modulus.value / (0.75 * gel.contact_modulus), 1.0, 1e-8);
    EXPECT_NEAR(fit.contact_point.value / first_touch, 1.0, 1e-8);
    EXPECT_NEAR(static_cast<double>(fit.n), 600.0 * 1.6 / 2.1, 2.0);  // as far before contact as into it
    const ForceCurveFit held =
        fit_force_curve(segment, tip_on_gel(), {.contact_point = first_touch, .fit_contact_point = false});
    EXPECT_NEAR(held.contact_modulus.value / gel.contact_modulus, 1.0, 1e-8);
    EXPECT_EQ(held.contact_point.standard_error, 0.0);
    EXPECT_EQ(held.parameters, std::vector<std::string>{"contact_modulus"});
}

TEST(ForceCurve, ConeAndPyramidAreRecovered) {
    for (const auto& [shape, factor] :
         {std::pair(TipShape::cone, 2.0 / pi), std::pair(TipShape::three_sided_pyramid, 0.887)}) {
        const double angle = 0.6;
        const auto force = [&](double depth) {
            return depth > 0.0 ? factor * std::tan(angle) * gel.contact_modulus * depth * depth : 0.0;
        };
        const CurveSegment segment = segments_of_curve(curve(force, force)).front();
        const ForceCurveFit fit = fit_force_curve(segment, tip_on_gel(), {.shape = shape, .half_angle = angle});
        EXPECT_NEAR(fit.contact_modulus.value / gel.contact_modulus, 1.0, 1e-8) << to_string(shape);
        EXPECT_THROW((void)fit_force_curve(segment, tip_on_gel(), {.shape = shape, .half_angle = 0.0}),
                     InvalidArgument);
        EXPECT_THROW((void)fit_force_curve(segment, tip_on_gel(),
                                           {.shape = shape, .half_angle = angle, .model = ContactModel::jkr}),
                     InvalidArgument);
    }
}

TEST(ForceCurve, JkrIsRecoveredFromNoiseFreeRetraction) {
    const CurveSegment segment = segments_of_curve(curve(dry_force, sticky_force)).back();
    const ForceCurveFit fit = fit_force_curve(segment, tip_on_gel(), {.model = ContactModel::jkr});
    EXPECT_TRUE(fit.converged);
    EXPECT_NEAR(fit.contact_modulus.value / gel.contact_modulus, 1.0, 1e-8);
    EXPECT_NEAR(fit.work_of_adhesion->value / gel.work_of_adhesion, 1.0, 1e-8);
    EXPECT_NEAR(fit.contact_point.value / first_touch, 1.0, 1e-8);
    EXPECT_LT(fit.n, 600);  // free flight is left out
    ASSERT_TRUE(fit.model_fit);
    EXPECT_EQ(fit.model_fit->model, ContactModel::jkr);
}

TEST(ForceCurve, DmtIsRecoveredFromNoiseFreeRetraction) {
    const auto force = [](double depth) {
        return depth >= 0.0 ? contact::dmt::force_at_displacement(depth, gel) : 0.0;
    };
    const CurveSegment segment = segments_of_curve(curve(dry_force, force)).back();
    const ForceCurveFit fit = fit_force_curve(segment, tip_on_gel(), {.model = ContactModel::dmt});
    EXPECT_NEAR(fit.contact_modulus.value / gel.contact_modulus, 1.0, 1e-8);
    EXPECT_NEAR(fit.work_of_adhesion->value / gel.work_of_adhesion, 1.0, 1e-8);
}

TEST(ForceCurve, RangeSelectsSamplesByIndentationForceOrShare) {
    const CurveSegment segment = segments_of_curve(curve(dry_force, sticky_force)).front();
    const double top = segment.force.maxCoeff();
    using Measure = CurveRange::Measure;
    for (const CurveRange& range :
         {CurveRange{Measure::indentation, 0.1e-6, 0.5e-6}, CurveRange{Measure::force, 0.1 * top, 0.6 * top},
          CurveRange{Measure::share_of_indentation, 0.2, 0.7}}) {
        const ForceCurveFit fit =
            fit_force_curve(segment, tip_on_gel(), {.range = range, .contact_point = first_touch});
        EXPECT_NEAR(fit.contact_modulus.value / gel.contact_modulus, 1.0, 1e-7);
        EXPECT_GT(fit.indentation_from, 0.05e-6);
        EXPECT_LT(fit.indentation_to, 0.62e-6);
    }
    EXPECT_THROW((void)fit_force_curve(segment, tip_on_gel(), {.range = {Measure::force, 2.0 * top, 3.0 * top}}),
                 UndefinedDataError);
}

TEST(ForceCurve, StandardErrorsFollowTheNoise) {
    constexpr double noise = 5e-12;
    const ForceCurveFit fit = fit_force_curve(segments_of_curve(curve(dry_force, sticky_force, noise)).front(),
                                              tip_on_gel(), {.fit_force_offset = true});
    EXPECT_NEAR(fit.rms_residual / noise, 1.0, 0.1);
    EXPECT_LT(std::abs(fit.contact_modulus.value - gel.contact_modulus), 3.0 * fit.contact_modulus.standard_error);
    EXPECT_LT(fit.contact_modulus.standard_error, 0.02 * gel.contact_modulus);
    EXPECT_EQ(fit.parameters.size(), 3U);
}

TEST(ForceCurve, FitsEverySegmentOfATableExceptPauses) {
    const std::vector<NamedCurveFit> fits = fit_force_curve(curve(dry_force, dry_force), tip_on_gel());
    ASSERT_EQ(fits.size(), 2U);
    ASSERT_TRUE(fits[1].fit) << fits[1].fit.reason;
    EXPECT_NEAR(fits[1].fit->contact_modulus.value / gel.contact_modulus, 1.0, 1e-8);
    Table flat = curve([](double) { return 0.0; }, [](double) { return 0.0; });
    for (const NamedCurveFit& fit : fit_force_curve(flat, tip_on_gel())) EXPECT_FALSE(fit.fit) << fit.name;
}

TEST(ForceCurve, ShapeNamesConvertToShapesAndBack) {
    for (const TipShape shape : {TipShape::paraboloid, TipShape::cone, TipShape::three_sided_pyramid})
        EXPECT_EQ(tip_shape_named(to_string(shape)), shape);
    EXPECT_THROW((void)tip_shape_named("con"), InvalidArgument);
}

/// ∮F dδ of a dry approach and a sticky retraction over the whole way.
double hysteresis() {
    constexpr Index n = 400000;
    const double from = -first_touch, step = 2.1e-6 / static_cast<double>(n);
    double energy = 0.0;
    for (Index i = 0; i < n; ++i) {
        const double depth = from + (static_cast<double>(i) + 0.5) * step;
        energy += (dry_force(depth) - sticky_force(depth)) * step;
    }
    return energy;
}

TEST(ForceCurveSummary, GivesModulusPullOffWorkAndLoss) {
    const ForceCurveSummary found = summary_of_force_curve(curve(dry_force, sticky_force), tip_on_gel());
    EXPECT_EQ(found.fitted_segment, "extend");
    EXPECT_NEAR(found.contact_modulus->value / gel.contact_modulus, 1.0, 1e-4);
    EXPECT_NEAR(found.pull_off_force->value / contact::jkr::pull_off_at_fixed_load(gel).force, 1.0, 0.01);
    EXPECT_NEAR(found.work_of_adhesion->value / gel.work_of_adhesion, 1.0, 0.01);
    EXPECT_TRUE(found.work_by_pull_off);
    EXPECT_NEAR(found.energy_loss->value / hysteresis(), 1.0, 0.01);
}

TEST(ForceCurveSummary, WithAdhesionUsesModulusAndWorkOfTheRetraction) {
    const ForceCurveSummary found =
        summary_of_force_curve(curve(dry_force, sticky_force), tip_on_gel(), {.model = ContactModel::jkr});
    EXPECT_EQ(found.fitted_segment, "retract");
    EXPECT_FALSE(found.work_by_pull_off);
    EXPECT_NEAR(found.work_of_adhesion->value / gel.work_of_adhesion, 1.0, 0.02);
}

TEST(ForceCurveSummary, ErrorOfTheLossIsItsScatter) {
    constexpr int runs = 200;
    constexpr double noise = 2e-11;
    double sum = 0.0, squares = 0.0, errors = 0.0;
    for (int run = 0; run < runs; ++run) {
        std::mt19937_64 generator(run);
        Table table = curve(dry_force, sticky_force);
        for (Column& column : table.columns)
            if (column.name == "force") column.values = tests::with_noise(column.values, noise, generator);
        const ForceCurveSummary found = summary_of_force_curve(table, tip_on_gel());
        sum += found.energy_loss->value / runs;
        squares += found.energy_loss->value * found.energy_loss->value / runs;
        errors += found.energy_loss->standard_error / runs;
    }
    // 200 runs determine a standard deviation to 5 %
    EXPECT_NEAR(errors / std::sqrt(squares - sum * sum), 1.0, 0.2);
}

TEST(ForceCurveSummary, MissingValuesHaveAReason) {
    const auto attached = [](double depth) { return dry_force(depth) - 2e-2 * std::max(-depth, 0.0) * depth / 1e-6; };
    EXPECT_NE(summary_of_force_curve(curve(dry_force, attached, 1e-11), tip_on_gel())
                  .energy_loss.reason.find("retract segment does not return to free flight"),
              std::string::npos);
    Table table = curve(dry_force, dry_force, 1e-11);
    EXPECT_NE(summary_of_force_curve(table, tip_on_gel()).pull_off_force.reason.find("no attraction exceeds the noise"),
              std::string::npos);
    for (Column& column : table.columns) column.values = Array1D(column.values.head(600));
    const ForceCurveSummary approach = summary_of_force_curve(table, tip_on_gel());
    EXPECT_TRUE(approach.contact_modulus);
    EXPECT_EQ(approach.energy_loss.reason, "the curve has no retraction");
    EXPECT_EQ(summary_of_force_curve(table, tip_on_gel(), {.model = ContactModel::jkr}).contact_modulus.reason,
              "the curve has no retraction");
    const ForceCurveSummary cone = summary_of_force_curve(curve(dry_force, sticky_force), tip_on_gel(),
                                                          {.shape = TipShape::cone, .half_angle = 0.5});
    EXPECT_EQ(cone.work_of_adhesion.reason, "the pull-off force of a cone does not give W");
}

}  // namespace
}  // namespace setae::loops::force_curve_fit_test
