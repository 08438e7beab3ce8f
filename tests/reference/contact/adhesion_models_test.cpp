// SPDX-License-Identifier: GPL-3.0-or-later
// Origins and digits: README.md beside this file.
#include <gtest/gtest.h>

#include <cmath>

#include "setae/contact/large_strain.hpp"
#include "setae/contact/layer.hpp"
#include "setae/contact/maugis_dugdale.hpp"
#include "setae/core/constants.hpp"

namespace setae::contact::adhesion_models_test {
namespace {

TEST(MaugisDugdale, GivesTheTabulatedPullOffs) {
    struct Row {
        double lambda, force, radius, displacement;
    };
    for (const Row& row :
         {Row{0.01, -1.998287784322, 0.0209102, -0.149948988}, Row{0.1, -1.950594892123, 0.1991926, -0.430394859},
          Row{0.3, -1.815555827045, 0.4966287, -0.542490411}, Row{0.5, -1.718245274886, 0.6788777, -0.530444837},
          Row{1.0, -1.600734911254, 0.9037686, -0.484236563}, Row{2.0, -1.534603238067, 1.0513770, -0.452930266},
          Row{5.0, -1.506349967716, 1.1262444, -0.439687402}}) {
        const auto state = maugis_dugdale::reduced_pull_off_at_fixed_load(row.lambda);
        EXPECT_NEAR(state.force, row.force, 1e-12) << row.lambda;
        EXPECT_NEAR(state.contact_radius, row.radius, 1e-7) << row.lambda;
        EXPECT_NEAR(state.displacement, row.displacement, 1e-7) << row.lambda;
    }
    // the second table
    EXPECT_NEAR(maugis_dugdale::reduced_pull_off_at_fixed_load(0.01).force, -1.998288, 1e-6);
    EXPECT_NEAR(maugis_dugdale::reduced_pull_off_at_fixed_load(0.1).force, -1.950595, 1e-6);
    EXPECT_NEAR(maugis_dugdale::reduced_pull_off_at_fixed_load(0.3).force, -1.815556, 1e-6);
    EXPECT_NEAR(maugis_dugdale::reduced_pull_off_at_fixed_load(0.5).force, -1.718245, 1e-6);
    EXPECT_NEAR(maugis_dugdale::reduced_pull_off_at_fixed_load(1.0).force, -1.600735, 1e-6);
    EXPECT_NEAR(maugis_dugdale::reduced_pull_off_at_fixed_load(2.0).force, -1.534603, 1e-6);
    EXPECT_NEAR(maugis_dugdale::reduced_pull_off_at_fixed_load(5.0).force, -1.506350, 1e-6);
    EXPECT_NEAR(maugis_dugdale::reduced_pull_off_at_fixed_load(1.0).zone_ratio, 1.4716, 5e-5);
}

TEST(MaugisDugdale, GivesTheTabulatedPullOffsAtFixedGrips) {
    EXPECT_NEAR(maugis_dugdale::reduced_pull_off_at_fixed_grips(0.1).displacement, -0.4693501945136, 1e-12);
    EXPECT_NEAR(maugis_dugdale::reduced_pull_off_at_fixed_grips(0.5).displacement, -0.9145327525557, 1e-12);
    EXPECT_NEAR(maugis_dugdale::reduced_pull_off_at_fixed_grips(1.0).displacement, -0.9917253734973, 1e-12);
    EXPECT_NEAR(maugis_dugdale::reduced_pull_off_at_fixed_grips(2.0).displacement, -0.9386365894984, 1e-12);
    EXPECT_NEAR(maugis_dugdale::reduced_pull_off_at_fixed_grips(5.0).displacement, -0.9139386659422, 1e-12);
    EXPECT_NEAR(maugis_dugdale::reduced_pull_off_at_fixed_grips(5.0).contact_radius, 0.529071317, 1e-7);
}

TEST(MaugisDugdale, GivesTheTabulatedStates) {
    struct Row {
        double lambda, radius, ratio, force, displacement;
    };
    for (const Row& row : {Row{0.01, 0.5, 22.6013581839124, -1.88091712931801, 0.099471834786457},
                           Row{0.1, 1.0, 3.76463146785771, -1.20810486437785, 0.516081731624771},
                           Row{1.0, 0.3, 2.83737424181722, -1.08914847449966, -0.972125611262835},
                           Row{1.0, 2.0, 1.17613727216523, 2.45620778308253, 2.34903635848362},
                           Row{5.0, 1.0, 1.02888517017134, -1.46759069226507, -0.613893751129137},
                           Row{100.0, 0.7, 1.00010713570512, -1.09166611074301, -0.876251093003231},
                           Row{100.0, 3.0, 1.00002499490657, 14.2730829860956, 6.17184334559103}}) {
        const auto state = maugis_dugdale::reduced_state(row.radius, row.lambda);
        EXPECT_NEAR(state.force, row.force, 1e-12 * (1.0 + std::abs(row.force)));
        EXPECT_NEAR(state.displacement, row.displacement, 1e-12 * (1.0 + row.radius));
        EXPECT_NEAR(state.zone_ratio / row.ratio, 1.0, 1e-12);
    }
}

TEST(LargeStrain, GivesTheTabulatedSphere) {
    const large_strain::Contact dry{.radius = 1.0, .contact_modulus = 1.0, .work_of_adhesion = 0.0};
    EXPECT_NEAR(large_strain::force(0.01, dry) / 1.3333866700954921e-6, 1.0, 1e-14);
    EXPECT_NEAR(large_strain::force(0.1, dry) / 0.0013387012083863364, 1.0, 1e-14);
    EXPECT_NEAR(large_strain::force(0.5, dry) / 0.18663268041756856, 1.0, 1e-14);
    EXPECT_NEAR(large_strain::force(0.9, dry) / 1.7647172761456286, 1.0, 1e-14);
    EXPECT_NEAR(large_strain::displacement(0.01, dry) / 0.00010000333353334762, 1.0, 1e-14);
    EXPECT_NEAR(large_strain::displacement(0.9, dry) / 1.3249975406248982, 1.0, 1e-14);
}

TEST(LargeStrain, GivesTheTabulatedPullOffs) {
    struct Row {
        double work, load_radius, force, grips_radius, displacement;
    };
    for (const Row& row : {Row{1e-3, 0.1507725268466, -0.004669123678719, 0.07305556974305, -0.01607814957501},
                           Row{0.1, 0.5841847119231, -0.395009332289, 0.3234888287922, -0.3422939710688},
                           Row{10.0, 0.9527272561588, -12.14598227997, 0.849281968937, -6.240291862134}}) {
        const large_strain::Contact contact{.radius = 1.0, .contact_modulus = 1.0, .work_of_adhesion = row.work};
        EXPECT_NEAR(large_strain::pull_off_at_fixed_load(contact).force / row.force, 1.0, 1e-11);
        EXPECT_NEAR(large_strain::pull_off_at_fixed_load(contact).contact_radius / row.load_radius, 1.0, 1e-11);
        EXPECT_NEAR(large_strain::pull_off_at_fixed_grips(contact).displacement / row.displacement, 1.0, 1e-11);
        EXPECT_NEAR(large_strain::pull_off_at_fixed_grips(contact).contact_radius / row.grips_radius, 1.0, 1e-11);
    }
}

TEST(Layer, GivesTheFactorsOfASolutionInRealSpace) {
    struct Row {
        double poisson_ratio, ratio, stiffness, dry_displacement, dry_force, edge, tolerance;
    };
    for (const Row& row : {Row{0.5, 0.2, 1.28063660581, 0.856314417312, 1.00617886913, 1.2729192956, 2e-11},
                           Row{0.5, 1.0, 3.61873584896, 0.559415485563, 1.41050017438, 2.77210138426, 2e-11},
                           Row{0.5, 2.0, 9.14945045204, 0.454902821558, 2.59812092424, 4.83714884188, 2e-11},
                           Row{0.5, 5.0, 50.1397379677, 0.359124690647, 9.94630300583, 12.5621664936, 1e-8},
                           Row{0.3, 0.2, 1.2065582409, 0.887577697195, 1.00405751634, 1.2017668041, 2e-11},
                           Row{0.3, 2.0, 4.3532442903, 0.573003355636, 1.8789542035, 2.85473413064, 2e-11},
                           Row{0.0, 1.0, 2.22611477554, 0.673387523627, 1.1999591835, 1.92453910781, 2e-11},
                           Row{-0.5, 1.0, 2.24892652733, 0.666761771687, 1.18727738299, 1.95581398932, 2e-11}}) {
        const layer::Factors factors = layer::Layer(1.0, row.poisson_ratio).factors(row.ratio);
        EXPECT_NEAR(factors.stiffness / row.stiffness, 1.0, row.tolerance) << row.poisson_ratio << ' ' << row.ratio;
        EXPECT_NEAR(factors.dry_displacement / row.dry_displacement, 1.0, row.tolerance);
        EXPECT_NEAR(factors.dry_force / row.dry_force, 1.0, row.tolerance);
        EXPECT_NEAR(factors.edge / row.edge, 1.0, row.tolerance);
    }
}

}  // namespace
}  // namespace setae::contact::adhesion_models_test
