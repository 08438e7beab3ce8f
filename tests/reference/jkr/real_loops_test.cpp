// SPDX-License-Identifier: GPL-3.0-or-later
// Origins and digits: README.md beside this file.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "reference_data.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/loops/analysis.hpp"
#include "setae/loops/machine_stiffness.hpp"
#include "setae/tables/mapping.hpp"

namespace setae::loops::real_loops_test {
namespace {

constexpr const char* mapping_file = "examples/mappings/eoh.toml";

LensAndCounterBody glass_sphere_on_rubber() {
    return {.radius = 7.5e-6, .lens_poisson_ratio = 0.5, .counter_youngs_modulus = 71e9, .counter_poisson_ratio = 0.17};
}

Loop read_loop(const std::filesystem::path& path) {
    return loop_from_table(tables::read_mapped_table(path.string(), tables::read_mapping(mapping_file)));
}

LoopAnalysis analysed(const std::filesystem::path& path) {
    return analyse(read_loop(path), glass_sphere_on_rubber(), {}, path.filename().string());
}

/// One baseline, ordinary least squares in depth, the whole of the retraction.
const AnalysisOptions as_the_independent_program{.segments = {.baseline_share = 0.05, .drift = DriftModel::constant},
                                                 .effective_variance = false,
                                                 .leave_pinned_out = false};

bool has_alert(const LoopAnalysis& analysis, const std::string& code) {
    return std::any_of(analysis.alerts.begin(), analysis.alerts.end(),
                       [&](const Alert& alert) { return alert.code == code; });
}

struct Expected {
    const char* file;
    double largest_force, smallest_force, pull_off_force, pull_off_work;  // nN, nN, nN, mJ/m²
    double loading_modulus, loading_work, rms_residual;                   // MPa, mJ/m², nm
    double unloading_modulus, unloading_work;
    double loop;  // fJ
};

// The smallest of the samples lies below the pull-off force by their noise: pull-off is the vertex of a parabola.
constexpr Expected table[] = {
    {"jkr/pdms_a.txt", 1432, -2115.1, -2106.2, 59.59, 1.85, 38.9, 2.7, 1.99, 56.6, 1615},
    {"jkr/pdms_b.txt", 2075, -2094.0, -2088.7, 59.10, 1.79, 40.2, 2.2, 1.90, 58.4, 1651},
    {"jkr/pdms_c.txt", 3171, -2119.1, -2114.2, 59.82, 1.78, 41.0, 2.1, 1.89, 59.1, 1719},
    {"jkr/pdms_10-1_d.txt", 949, -2797.0, -2783.8, 78.77, 1.49, 32.5, 1.6, 1.48, 77.6, 2969},
};

void expect_within(double value, double expected, double share) { EXPECT_NEAR(value / expected, 1.0, share) << value; }

class RealLoop : public testing::TestWithParam<Expected> {};

TEST_P(RealLoop, MatchesTheIndependentProgram) {
    const Expected& expected = GetParam();
    SETAE_REQUIRE_REFERENCE_DATA(path, expected.file);
    const LoopAnalysis analysis =
        analyse(read_loop(path), glass_sphere_on_rubber(), as_the_independent_program, path.filename().string());
    EXPECT_NEAR(analysis.loading.range.force_last / units::nN, expected.largest_force, 0.5);
    const Estimate& pull_off = analysis.pull_off->force;
    EXPECT_NEAR(pull_off.value / units::nN, expected.pull_off_force, 0.5);  // mean and median of a zero, two windows
    EXPECT_GT(pull_off.standard_error / units::nN, 0.5);
    EXPECT_GT((pull_off.value / units::nN - expected.smallest_force), 3.0);
    EXPECT_NEAR(analysis.pull_off->work_of_adhesion.value / units::mJ_per_m2, expected.pull_off_work, 0.02);
    const JkrFit& loading = analysis.loading.primary();
    EXPECT_TRUE(loading.converged);
    expect_within(loading.contact_modulus.value / units::MPa, expected.loading_modulus, 0.03);
    expect_within(loading.work_of_adhesion.value / units::mJ_per_m2, expected.loading_work, 0.03);
    expect_within(loading.rms_residual / units::nm, expected.rms_residual, 0.03);
    expect_within(loading.youngs_modulus.value, 0.75 * loading.contact_modulus.value, 1e-4);
    ASSERT_TRUE(analysis.unloading);
    const JkrFit& unloading = analysis.unloading->primary();
    EXPECT_TRUE(unloading.converged);
    expect_within(unloading.contact_modulus.value / units::MPa, expected.unloading_modulus, 0.03);
    expect_within(unloading.work_of_adhesion.value / units::mJ_per_m2, expected.unloading_work, 0.03);
    expect_within(analysis.loop->energy / units::fJ, expected.loop, 0.01);
    EXPECT_LT(analysis.loop->standard_error.total, 0.01 * analysis.loop->energy);
    EXPECT_EQ(analysis.cycles.size(), 1u);
    EXPECT_FALSE(has_alert(analysis, "POOR_FIT"));
}

// As users get them. Drift is linear between the two baselines, the pinned edge is left out, errors of force count: E*,
// W of loading and the loop's energy move by less than what the two programs' choices make of them.
TEST_P(RealLoop, WithDefaultsIsCloseToTheIndependentProgram) {
    const Expected& expected = GetParam();
    SETAE_REQUIRE_REFERENCE_DATA(path, expected.file);
    const LoopAnalysis analysis = analysed(path);
    const JkrFit& loading = analysis.loading.primary();
    EXPECT_TRUE(loading.converged);
    expect_within(loading.contact_modulus.value / units::MPa, expected.loading_modulus, 0.015);
    expect_within(loading.work_of_adhesion.value / units::mJ_per_m2, expected.loading_work, 0.03);
    EXPECT_LT(std::abs(loading.work_of_adhesion.value / units::mJ_per_m2 - expected.loading_work),
              loading.work_of_adhesion.standard_error / units::mJ_per_m2);
    ASSERT_TRUE(analysis.unloading);
    // without the pinned edge unloading and pull-off agree
    expect_within(analysis.unloading->primary().work_of_adhesion.value / units::mJ_per_m2, expected.pull_off_work,
                  0.015);
    expect_within(analysis.unloading->primary().contact_modulus.value, loading.contact_modulus.value, 0.06);
    expect_within(analysis.loop->energy / units::fJ, expected.loop, 0.002);
}

TEST_P(RealLoop, RetractsWithAnInitiallyPinnedEdge) {
    SETAE_REQUIRE_REFERENCE_DATA(path, GetParam().file);
    const LoopAnalysis analysis = analysed(path);
    const LoopAnalysis whole = analyse(read_loop(path), glass_sphere_on_rubber(), {.leave_pinned_out = false});
    ASSERT_TRUE(analysis.pinned);
    EXPECT_FALSE(whole.pinned);
    // a flat punch of the largest radius: dF = 2E*a dδ within what E* of this branch is known to
    const Loop loop = read_loop(path);
    const IndexRange& pinned = *analysis.pinned;
    const double slope = (loop.force[pinned.last] - loop.force[pinned.first]) /
                         (loop.displacement[pinned.last] - loop.displacement[pinned.first]);
    const double punch =
        2.0 * analysis.loading.primary().contact_modulus.value * analysis.context.largest_contact_radius;
    EXPECT_NEAR(slope / punch, 1.0, 0.1);
    EXPECT_EQ(analysis.unloading->range.n + pinned.count(), whole.unloading->range.n);
}

TEST_P(RealLoop, LastPointsGiveThePullOffWork) {
    SETAE_REQUIRE_REFERENCE_DATA(path, GetParam().file);
    const LoopAnalysis analysis = analysed(path);
    ASSERT_TRUE(analysis.retraction);
    EXPECT_EQ(analysis.retraction->n, 6);
    // (S1) and (S2) describe the same points
    expect_within(analysis.retraction->work_of_adhesion.value, analysis.pull_off->work_of_adhesion.value, 0.03);
    // the force sensor's stiffness, 3.01 N/m, is the slope of its jump
    expect_within(analysis.pull_off->machine_stiffness, 3.01, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Pdms, RealLoop, testing::ValuesIn(table), [](const auto& parameter) {
    std::string name = std::filesystem::path(parameter.param.file).stem().string();
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

void expect_sensitivity(const LoopAnalysis& analysis, const std::vector<double>& work) {
    ASSERT_EQ(analysis.loading.sensitivity.size(), work.size());
    for (std::size_t i = 0; i < work.size(); ++i)
        EXPECT_NEAR(analysis.loading.sensitivity[i].fit->work_of_adhesion.value / units::mJ_per_m2, work[i], 0.05);
}

TEST(RealLoops, ReportSensitivityToTheFitRange) {
    SETAE_REQUIRE_REFERENCE_DATA(first, "jkr/pdms_a.txt");
    SETAE_REQUIRE_REFERENCE_DATA(third, "jkr/pdms_c.txt");
    const LoopAnalysis sensitive = analyse(read_loop(first), glass_sphere_on_rubber(), as_the_independent_program);
    expect_sensitivity(sensitive, {35.4, 38.9, 46.3, 69.4});
    EXPECT_TRUE(has_alert(sensitive, "RANGE_SENSITIVE"));
    expect_sensitivity(analyse(read_loop(third), glass_sphere_on_rubber(), as_the_independent_program),
                       {39.6, 41.0, 43.4, 46.5});
}

TEST(RealLoops, ReportAPoorFit) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "jkr/poor_fit_earlier_sensor.txt");
    const LoopAnalysis analysis = analysed(path);
    EXPECT_TRUE(has_alert(analysis, "POOR_FIT"));
    EXPECT_GT(analysis.loading.primary().rms_residual, 16e-9);
    EXPECT_LT(analysis.loading.primary().rms_residual, 26e-9);
}

TEST(RealLoops, ReportAContactTooStiffForTheSensor) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "jkr/sapphire_control.txt");
    EXPECT_TRUE(has_alert(analysed(path), "STIFFNESS_UNRESOLVED"));
}

TEST(RealLoops, MeasureMachineStiffnessOnSapphire) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "jkr/sapphire_control.txt");
    // the stage's own position: the spring of the sensor, 3.01 N/m, is what gives way
    const std::filesystem::path by_stage = std::filesystem::path(testing::TempDir()) / "stage.toml";
    std::ofstream(by_stage)
        << "[file]\nencoding = \"latin-1\"\nseparator = \"tab\"\ndecimal = \"comma\"\nheader_end = \"eoh\"\n"
           "[constants]\nspring_constant = \"3.01 N/m\"\n"
           "[columns.piezo]\nheader = \"Piezo position\"\nunit = \"um\"\n[columns.mems]\nheader = \"MEMS displ.\"\n"
           "[table]\nforce = \"spring_constant * mems\"\ndisplacement = \"piezo\"\n";
    const Loop loop =
        loop_from_table(tables::read_mapped_table(path.string(), tables::read_mapping(by_stage.string())));
    const MachineStiffness found = machine_stiffness_from_rigid_contact(loop);
    // sensor and contact give way in series: 1/k = 1/(3.01 N/m) + 1/k_contact, whose force against piezo − mems is far
    // less straight
    const Loop contact = read_loop(path);
    const MachineStiffness rest =
        machine_stiffness_from_rigid_contact(contact, find_segments(contact), 0, {.largest_nonlinearity = 10.0});
    expect_within(1.0 / found.stiffness.value, 1.0 / 3.01 + 1.0 / rest.stiffness.value, 0.01);
    EXPECT_LT(found.stiffness.value, 3.01);
    EXPECT_GT(rest.stiffness.value, 10.0 * 3.01);
    EXPECT_LT(found.stiffness.standard_error, 0.05);
    EXPECT_LT(std::abs(found.nonlinearity), 0.05);
    // rubber in its place gives way itself
    SETAE_REQUIRE_REFERENCE_DATA(soft, "jkr/pdms_c.txt");
    EXPECT_THROW((void)machine_stiffness_from_rigid_contact(
                     loop_from_table(tables::read_mapped_table(soft.string(), tables::read_mapping(mapping_file)))),
                 UndefinedDataError);
}

TEST(RealLoops, HaveFiveContactPointsOrMore) {
    for (const Expected& expected : table) {
        SETAE_REQUIRE_REFERENCE_DATA(path, expected.file);
        const LoopAnalysis analysis = analysed(path);
        ASSERT_TRUE(analysis.contact_points) << analysis.contact_points.reason;
        const auto& estimates = analysis.contact_points->estimates;
        const auto found = std::count_if(estimates.begin(), estimates.end(),
                                         [](const ContactPointEstimate& e) { return bool(e.contact_point); });
        EXPECT_GE(found, 5) << expected.file;
        for (const ContactPointEstimate& e : estimates)
            if (e.contact_point) EXPECT_TRUE(e.fit) << contact_point_name(e.method) << e.fit.reason;
            else EXPECT_NE(e.contact_point.reason, "");
    }
}

TEST(RealLoops, CountNineReleases) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "jkr/nine_cycles.txt");
    const LoopAnalysis analysis = analysed(path);
    ASSERT_EQ(analysis.cycles.size(), 9u);
    for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(analysis.cycles[i].cycle.ends_in_pull_off, i == 8);
    // the partial releases go back and forth along one line; their loss is nothing beside the whole loop's
    for (std::size_t i = 0; i < 8; ++i) EXPECT_LT(std::abs(*analysis.cycles[i].energy), 0.002 * analysis.loop->energy);
    EXPECT_TRUE(analysis.cycles[8].unloading);
    // the last release closes the outer loop, and all nine together are the whole
    double sum = 0.0;
    for (const CycleAnalysis& cycle : analysis.cycles) sum += *cycle.energy;
    EXPECT_NEAR(sum / analysis.loop->energy, 1.0, 1e-12);
}

TEST(RealLoops, RefuseADriftWithoutContact) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "jkr/drift_only.txt");
    EXPECT_THROW((void)read_loop(path), FormatError);
    // its columns named by position, the stage at rest
    const std::filesystem::path by_position = std::filesystem::path(testing::TempDir()) / "drift.toml";
    std::ofstream(by_position) << "[file]\nencoding = \"latin-1\"\nseparator = \"tab\"\ndecimal = \"comma\"\n"
                                  "header_end = \"eoh\"\n"
                                  "[constants]\nspring_constant = \"3.01 N/m\"\n"
                                  "[columns.mems]\nposition = 1\nunit = \"nm\"\n"
                                  "[table]\nforce = \"spring_constant * mems\"\ndisplacement = \"-mems\"\n";
    const Loop loop =
        loop_from_table(tables::read_mapped_table(path.string(), tables::read_mapping(by_position.string())));
    EXPECT_THROW((void)analyse(loop, glass_sphere_on_rubber()), UndefinedDataError);
    // nor where the drifting start is not looked at
    EXPECT_THROW((void)analyse(loop, glass_sphere_on_rubber(), {.segments = {.force_baseline = 0.0}}),
                 UndefinedDataError);
}

}  // namespace
}  // namespace setae::loops::real_loops_test
