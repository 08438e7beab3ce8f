// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "setae/contact/jkr.hpp"

namespace setae::contact::jkr::jkr_property_test {
namespace {

/// A number whose logarithm is evenly spread between two powers of ten.
double power_of_ten(int lowest, int highest) {
    return std::pow(10.0, 1e-3 * *rc::gen::inRange(1000 * lowest, 1000 * highest));
}

/// From atomic tips to hand-sized lenses, from gels to diamond.
Contact any_contact() {
    return {
        .radius = power_of_ten(-9, 0), .contact_modulus = power_of_ten(2, 12), .work_of_adhesion = power_of_ten(-6, 1)};
}

// The square root at a fold turns rounding of 1e-16 in force or displacement into 1e-8 in radius, so radii stay 1 %
// away.
RC_GTEST_PROP(JkrProperty, RadiusInvertsForceAndDisplacementOutsideTheFold, ()) {
    const Contact contact = any_contact();
    const double excess = 1.0 + power_of_ten(-2, 6);
    const double at_load = excess * pull_off_at_fixed_load(contact).contact_radius;
    RC_ASSERT(std::abs(contact_radius_at_force(force(at_load, contact), contact) / at_load - 1.0) < 1e-12);
    const double at_grips = excess * pull_off_at_fixed_grips(contact).contact_radius;
    RC_ASSERT(std::abs(contact_radius_at_displacement(displacement(at_grips, contact), contact) / at_grips - 1.0) <
              1e-12);
}

RC_GTEST_PROP(JkrProperty, RadiusInvertsForceAndDisplacementInsideTheFold, ()) {
    const Contact contact = any_contact();
    const double share = 1e-3 * *rc::gen::inRange(1, 990);
    const double at_load = share * pull_off_at_fixed_load(contact).contact_radius;
    const double from_force = contact_radius_at_force(force(at_load, contact), contact, Branch::inner);
    RC_ASSERT(std::abs(from_force / at_load - 1.0) < 1e-12);
    const double at_grips = share * pull_off_at_fixed_grips(contact).contact_radius;
    const double from_displacement =
        contact_radius_at_displacement(displacement(at_grips, contact), contact, Branch::inner);
    RC_ASSERT(std::abs(from_displacement / at_grips - 1.0) < 1e-11);
}

RC_GTEST_PROP(JkrProperty, IsUniversalInMaugisUnits, ()) {
    const Contact contact = any_contact();
    const MaugisUnits scales = maugis_units(contact);
    const double radius = power_of_ten(-1, 2);
    const double scaled_force = radius * radius * radius - std::sqrt(6.0 * radius * radius * radius);
    const double scaled_displacement = radius * radius - 2.0 / 3.0 * std::sqrt(6.0 * radius);
    const double size = radius * radius * radius + 1.0;
    RC_ASSERT(std::abs(force(radius * scales.length, contact) / scales.force - scaled_force) < 1e-12 * size);
    RC_ASSERT(std::abs(displacement(radius * scales.length, contact) / scales.height - scaled_displacement) <
              1e-12 * size);
}

}  // namespace
}  // namespace setae::contact::jkr::jkr_property_test
