// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/persson/load_curve.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "self_affine_curve.hpp"
#include "setae/core/errors.hpp"

namespace setae::persson::load_curve_test {
namespace {

TEST(LoadTable, HasTheValuesAtTheFullBand) {
    const auto scales = scales_of(self_affine_curve(), {.contact_modulus = 1e9});
    const Array1D pressure{{1e6, 3e7}};
    const auto table = load_table(pressure, scales);
    EXPECT_EQ(table.find("effective_work"), nullptr);
    for (Index i = 0; i < 2; ++i) {
        const auto along = scale_table(pressure[i], scales);
        for (const char* name : {"area_fraction", "mean_gap", "contact_stiffness", "stored_energy"})
            EXPECT_EQ(table.at(name)[i], along.at(name)[along.rows() - 1]) << name;
    }
    EXPECT_THROW((void)load_table(Array1D{{-1e6}}, scales), InvalidArgument);
}

TEST(LoadTable, AcceptsTensionWithAdhesion) {
    const auto scales = scales_of(self_affine_curve(), {.contact_modulus = 1e6});
    const double work = 5.0 * scales.stored_energy[scales.stored_energy.size() - 1];
    const auto table = load_table(Array1D{{-100.0, 100.0}}, scales, {.work_of_adhesion = work});
    EXPECT_TRUE(std::isnan(table.at("area_fraction")[0]));
    EXPECT_GT(table.at("area_fraction")[1], 0.0);
    EXPECT_GT(table.at("adhesive_area_fraction")[0], 0.5);
    EXPECT_GT(table.at("effective_work")[0], 0.5 * work);
    // rounds that end before they converge leave no numbers
    const auto stopped = scale_table(100.0, scales, {.work_of_adhesion = 0.1 * work, .adhesion = {.max_rounds = 1}});
    EXPECT_TRUE(stopped.at("adhesive_area_fraction").isNaN().all());
}

}  // namespace
}  // namespace setae::persson::load_curve_test
