// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "setae/contact/crack_speed.hpp"
#include "setae/contact/dmt.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/contact/large_strain.hpp"
#include "setae/contact/maugis_dugdale.hpp"
#include "setae/contact/transition.hpp"

namespace setae::contact::adhesion_models_property_test {
namespace {

double power_of_ten(double lowest, double highest) {
    return std::pow(10.0, lowest + (highest - lowest) * 1e-6 * *rc::gen::inRange(0, 1000000));
}

AdhesiveContact any_contact() {
    return {
        .radius = power_of_ten(-9, 0), .contact_modulus = power_of_ten(2, 12), .work_of_adhesion = power_of_ten(-6, 1)};
}

// away from the folds, where inverses lose half the digits, and for a long range from what rounding leaves of the load
RC_GTEST_PROP(MaugisDugdaleProperty, RadiusInvertsForceAndDisplacement, ()) {
    const AdhesiveContact plain = any_contact();
    const double lambda = power_of_ten(-8, 8);
    const maugis_dugdale::Contact contact{.radius = plain.radius,
                                          .contact_modulus = plain.contact_modulus,
                                          .work_of_adhesion = plain.work_of_adhesion,
                                          .cohesive_stress = maugis_dugdale::cohesive_stress(lambda, plain)};
    const double a = jkr::maugis_units(plain).length * power_of_ten(0.1, 3);
    RC_ASSERT(std::abs(maugis_dugdale::contact_radius_at_force(maugis_dugdale::force(a, contact), contact) / a - 1.0) <
              1e-10);
    RC_ASSERT(
        std::abs(maugis_dugdale::contact_radius_at_displacement(maugis_dugdale::displacement(a, contact), contact) / a -
                 1.0) < 1e-10);
}

RC_GTEST_PROP(MaugisDugdaleProperty, PullOffWeakensFromDmtToJkrAsTheRangeShrinks, ()) {
    const double lambda = power_of_ten(-4, 3);
    const double pull_off = maugis_dugdale::reduced_pull_off_at_fixed_load(lambda).force;
    RC_ASSERT(pull_off > -2.0 && pull_off < -1.5);
    RC_ASSERT(pull_off < maugis_dugdale::reduced_pull_off_at_fixed_load(1.1 * lambda).force);
    // the fold of a long range is flat to rounding
    RC_ASSERT(maugis_dugdale::reduced_state(power_of_ten(-3, 1), lambda).force >= pull_off - 1e-14);
}

RC_GTEST_PROP(LargeStrainProperty, RadiusInvertsForceAndDisplacementOutsideTheFold, ()) {
    AdhesiveContact contact = any_contact();
    contact.work_of_adhesion = contact.contact_modulus * contact.radius * power_of_ten(-8, 2);
    const double load_fold = large_strain::pull_off_at_fixed_load(contact).contact_radius;
    const double grips_fold = large_strain::pull_off_at_fixed_grips(contact).contact_radius;
    const double share = 1e-3 * *rc::gen::inRange(50, 990);
    const double at_load = load_fold + share * (contact.radius - load_fold);
    const double at_grips = grips_fold + share * (contact.radius - grips_fold);
    RC_ASSERT(std::abs(large_strain::contact_radius_at_force(large_strain::force(at_load, contact), contact) / at_load -
                       1.0) < 1e-10);
    RC_ASSERT(
        std::abs(large_strain::contact_radius_at_displacement(large_strain::displacement(at_grips, contact), contact) /
                     at_grips -
                 1.0) < 1e-10);
}

RC_GTEST_PROP(DmtProperty, RadiusInvertsForceAndDisplacement, ()) {
    const AdhesiveContact contact = any_contact();
    const double a = jkr::maugis_units(contact).length * power_of_ten(-1, 3);
    RC_ASSERT(std::abs(dmt::contact_radius_at_force(dmt::force(a, contact), contact) / a - 1.0) < 1e-10);
    RC_ASSERT(std::abs(dmt::contact_radius_at_displacement(dmt::displacement(a, contact), contact) / a - 1.0) < 1e-14);
}

RC_GTEST_PROP(TransitionProperty, RadiusInvertsForce, ()) {
    const transition::RadiusCurve curve{.zero_load_radius = power_of_ten(-10, -2),
                                        .pull_off_force = -power_of_ten(-12, 0),
                                        .transition_share = 1e-3 * *rc::gen::inRange(0, 1001)};
    const double alpha = curve.transition_share, at_pull_off = std::pow(alpha / (1.0 + alpha), 2.0 / 3.0);
    const double a = at_pull_off * curve.zero_load_radius + curve.zero_load_radius * power_of_ten(-2, 2);
    RC_ASSERT(std::abs(transition::contact_radius(transition::force(a, curve), curve) / a - 1.0) < 1e-10);
}

RC_GTEST_PROP(CrackSpeedProperty, SpeedInvertsEnergyReleaseRate, ()) {
    const crack_speed::Law law{
        .threshold = power_of_ten(-3, 2), .reference_speed = power_of_ten(-10, -2), .exponent = power_of_ten(-1, 0)};
    const double v = law.reference_speed * power_of_ten(-2, 4);
    RC_ASSERT(std::abs(crack_speed::speed(crack_speed::energy_release_rate(v, law), law) / v - 1.0) < 1e-10);
}

}  // namespace
}  // namespace setae::contact::adhesion_models_property_test
