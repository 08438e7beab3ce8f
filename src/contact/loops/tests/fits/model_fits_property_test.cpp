// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>

#include "setae/contact/jkr.hpp"
#include "setae/loops/global_fit.hpp"
#include "setae/loops/model_fits.hpp"

namespace setae::loops::model_fits_property_test {
namespace {

double between(double lower, double upper) { return lower + (upper - lower) * *rc::gen::inRange(0, 1000001) * 1e-6; }

double decades(double lower, double upper) { return std::pow(10.0, between(std::log10(lower), std::log10(upper))); }

LensAndCounterBody on_rigid(double radius) {
    return {.radius = radius, .counter_youngs_modulus = std::numeric_limits<double>::infinity()};
}

/// A JKR branch whose largest force is some multiple of its pull-off force.
BranchData branch(const contact::jkr::Contact& contact, double multiple, double point) {
    const auto pull_off = contact::jkr::pull_off_at_fixed_load(contact);
    BranchData data;
    data.contact_radius = Array1D::LinSpaced(
        40, 1.05 * pull_off.contact_radius, contact::jkr::contact_radius_at_force(-multiple * pull_off.force, contact));
    data.force = data.displacement = data.contact_radius;
    for (Index i = 0; i < 40; ++i) {
        data.force[i] = contact::jkr::force(data.contact_radius[i], contact);
        data.displacement[i] = contact::jkr::displacement(data.contact_radius[i], contact) + point;
    }
    return data;
}

contact::jkr::Contact any_contact() {
    return {
        .radius = decades(1e-7, 1e-2), .contact_modulus = decades(1e3, 1e11), .work_of_adhesion = decades(1e-4, 1.0)};
}

TEST(ModelFitProperties, JkrIsRecoveredAtEveryScale) {
    EXPECT_TRUE(rc::check([] {
        const contact::jkr::Contact contact = any_contact();
        const double height = contact::jkr::maugis_units(contact).height, point = between(-10.0, 10.0) * height;
        const BranchData data = branch(contact, decades(0.5, 30.0), point);
        for (const Channels channels :
             {Channels::force_radius, Channels::force_displacement, Channels::force_displacement_radius}) {
            const ModelFit fit = fit_model(data, on_rigid(contact.radius), {.channels = channels});
            RC_ASSERT(std::abs(fit.contact_modulus.value / contact.contact_modulus - 1.0) < 1e-8);
            RC_ASSERT(std::abs(fit.work_of_adhesion->value / contact.work_of_adhesion - 1.0) < 1e-8);
            if (channels != Channels::force_radius)
                RC_ASSERT(std::abs(fit.contact_point.value - point) < 1e-8 * height);
        }
    }));
}

TEST(ModelFitProperties, AreInvariantUnderSampleOrderAndDisplacementZero) {
    EXPECT_TRUE(rc::check([] {
        const contact::jkr::Contact contact = any_contact();
        BranchData data = branch(contact, 5.0, 0.0);
        const double shift = between(-5.0, 5.0) * contact::jkr::maugis_units(contact).height;
        // a wave no model of contact has, so that the residuals are not zero
        for (Index i = 0; i < 40; ++i) data.force[i] *= 1.0 + 0.01 * std::sin(static_cast<double>(i));
        data.force_noise = 0.01 * data.force.abs().maxCoeff();
        data.displacement_noise = 0.01 * (data.displacement.maxCoeff() - data.displacement.minCoeff());
        data.contact_radius_noise = 0.01 * data.contact_radius.maxCoeff();
        const ModelFit fit = fit_model(data, on_rigid(contact.radius));
        BranchData other = data;
        other.force = data.force.reverse().eval();
        other.contact_radius = data.contact_radius.reverse().eval();
        other.displacement = data.displacement.reverse().eval() + shift;
        const ModelFit turned = fit_model(other, on_rigid(contact.radius));
        RC_ASSERT(std::abs(turned.contact_modulus.value / fit.contact_modulus.value - 1.0) < 1e-6);
        RC_ASSERT(std::abs(turned.work_of_adhesion->value / fit.work_of_adhesion->value - 1.0) < 1e-6);
        RC_ASSERT(std::abs(turned.chi2 / fit.chi2 - 1.0) < 1e-6);
    }));
}

TEST(ModelFitProperties, MoreGeneralModelsFitNoWorse) {
    EXPECT_TRUE(rc::check([] {
        const contact::jkr::Contact contact = any_contact();
        BranchData data = branch(contact, decades(1.0, 30.0), 0.0);
        for (Index i = 0; i < 40; ++i) data.force[i] *= 1.0 + 0.02 * std::sin(1.7 * static_cast<double>(i));
        data.force_noise = data.contact_radius_noise = 0.0;
        const auto chi2 = [&](ContactModel model) {
            return fit_model(data, on_rigid(contact.radius), {.model = model, .channels = Channels::force_radius}).chi2;
        };
        const double dry = chi2(ContactModel::hertz), sticky = chi2(ContactModel::jkr), far = chi2(ContactModel::dmt);
        RC_ASSERT(sticky <= dry * (1.0 + 1e-9));
        RC_ASSERT(far <= dry * (1.0 + 1e-9));
    }));
}

TEST(GlobalFitProperties, OfTwoEqualBranchesEqualsTheFitOfOne) {
    EXPECT_TRUE(rc::check([] {
        const contact::jkr::Contact contact = any_contact();
        BranchData data = branch(contact, 5.0, 0.0);
        for (Index i = 0; i < 40; ++i) data.force[i] *= 1.0 + 0.01 * std::sin(2.3 * static_cast<double>(i));
        const LensAndCounterBody bodies = on_rigid(contact.radius);
        const GlobalFit fit = fit_globally(
            {{.name = "one", .data = data, .bodies = bodies}, {.name = "two", .data = data, .bodies = bodies}},
            {.share_work_of_adhesion = true});
        const ModelFit& own = fit.branches.front().separate;
        RC_ASSERT(std::abs(fit.contact_modulus->value / own.contact_modulus.value - 1.0) < 1e-6);
        RC_ASSERT(std::abs(fit.work_of_adhesion->value / own.work_of_adhesion->value - 1.0) < 1e-6);
        RC_ASSERT(fit.sharing.p_value > 0.99);
    }));
}

}  // namespace
}  // namespace setae::loops::model_fits_property_test
