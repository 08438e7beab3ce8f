// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/half_space/contact_quantities.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace setae::half_space::contact_quantities_test {
namespace {

HardWall problem() {
    return {.grid = {2, 2, 2e-6, 1e-6},
            .body = {.contact_modulus = 1e9, .layer = {}},
            .heights = Array2D::Zero(2, 2),
            .control = MeanPressure{1e6},
            .hardness = {}};
}

HardWallContact contact() {
    HardWallContact made;
    made.pressures = Array2D{{4e6, 0.0}, {0.0, 0.0}};
    made.gaps = Array2D{{0.0, 1e-9}, {1e-9, 2e-9}};
    made.mean_pressure = 1e6;
    made.mean_gap = 1e-9;
    made.stored_energy = 6e-15;
    made.area = contact_area(made.pressures, problem().grid);
    return made;
}

double value_of(const std::vector<Quantity>& list, const std::string& name) {
    const auto found = std::find_if(list.begin(), list.end(), [&](const Quantity& q) { return q.quantity == name; });
    return found == list.end() ? std::numeric_limits<double>::quiet_NaN() : found->estimate.value;
}

TEST(ContactQuantities, MatchTheContact) {
    const auto list = contact_quantities(problem(), contact(), 1e15);
    EXPECT_EQ(value_of(list, "area_fraction"), 0.25);
    EXPECT_EQ(value_of(list, "largest_pressure"), 4e6);
    EXPECT_DOUBLE_EQ(value_of(list, "stored_energy_per_area"), 3e-3);
    EXPECT_EQ(value_of(list, "patches"), 1.0);
    EXPECT_TRUE(std::isnan(value_of(list, "deepest_dent")));
    auto plastic = problem();
    plastic.hardness = 4e6;
    auto dented = contact();
    dented.flowing_area = 0.5e-12;
    dented.deepest_dent = 3e-9;
    const auto more = contact_quantities(plastic, dented, 1e15);
    EXPECT_DOUBLE_EQ(value_of(more, "flowing_fraction"), 0.25);
    EXPECT_EQ(value_of(more, "deepest_dent"), 3e-9);
}

TEST(ContactSentence, StatesAreaPressureGapAndStiffness) {
    EXPECT_EQ(
        contact_sentence(problem(), contact(), 1e15),
        "The surface touches the half-space on 25 % of the map (13.19 % with the correction for the perimeter) in 1 "
        "patch, at a mean pressure of 1.000 MPa. The mean gap is 1.000 nm; an additional pressure of 1.000 MPa brings the surface 1 nm closer.");
    EXPECT_NE(contact_sentence(problem(), contact(), std::numeric_limits<double>::infinity()).find("no further"),
              std::string::npos);
    auto apart = contact();
    apart.area = {};
    EXPECT_EQ(contact_sentence(problem(), apart, 0.0),
              "The surface does not touch the half-space: the mean gap is 1.000 nm.");
}

}  // namespace
}  // namespace setae::half_space::contact_quantities_test
