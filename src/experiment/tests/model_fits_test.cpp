// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/experiment/model_fits.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "setae/contact/dmt.hpp"
#include "setae/contact/hertz.hpp"
#include "setae/contact/large_strain.hpp"
#include "setae/contact/layer.hpp"
#include "setae/contact/maugis_dugdale.hpp"
#include "setae/contact/transition.hpp"
#include "setae/core/errors.hpp"
#include "synthetic_loop.hpp"

namespace setae::experiment {
namespace {

using contact::AdhesiveContact;
using tests::rubber_on_diamond;

constexpr AdhesiveContact lens{.radius = 1.25e-3, .contact_modulus = 0.92e6, .work_of_adhesion = 0.040};
constexpr double contact_point = 3.7e-6;
constexpr std::array<FitErrors, 2> both_errors{FitErrors::effective_variance, FitErrors::orthogonal_distance};
constexpr std::array<Channels, 3> all_channels{Channels::force_radius, Channels::force_displacement,
                                               Channels::force_displacement_radius};

/// A branch at evenly spaced contact radii, from a state near pull-off to 1 mN.
template <class Force, class Displacement>
BranchData branch(double least, double largest, const Force& force, const Displacement& displacement, Index n = 150) {
    BranchData data;
    data.contact_radius = Array1D::LinSpaced(n, least, largest);
    data.force = data.contact_radius.unaryExpr(force);
    data.displacement = data.contact_radius.unaryExpr(displacement) + contact_point;
    return data;
}

BranchData jkr_branch(const AdhesiveContact& contact = lens, Index n = 150) {
    const double least = 1.1 * contact::jkr::pull_off_at_fixed_load(contact).contact_radius;
    return branch(
        least, contact::jkr::contact_radius_at_force(1e-3, contact), [&](double a) { return contact::jkr::force(a, contact); },
        [&](double a) { return contact::jkr::displacement(a, contact); }, n);
}

contact::maugis_dugdale::Contact zone_contact(double lambda) {
    return {.radius = lens.radius,
            .contact_modulus = lens.contact_modulus,
            .work_of_adhesion = lens.work_of_adhesion,
            .cohesive_stress = contact::maugis_dugdale::cohesive_stress(lambda, lens)};
}

BranchData zone_branch(const contact::maugis_dugdale::Contact& contact, Index n = 150) {
    const double least = std::max(1.1 * contact::maugis_dugdale::pull_off_at_fixed_load(contact).contact_radius, 1e-5);
    return branch(
        least, contact::maugis_dugdale::contact_radius_at_force(1e-3, contact),
        [&](double a) { return contact::maugis_dugdale::force(a, contact); },
        [&](double a) { return contact::maugis_dugdale::displacement(a, contact); }, n);
}

void expect_recovered(const ModelFit& fit, const AdhesiveContact& contact, const std::string& what) {
    EXPECT_TRUE(fit.converged) << what;
    EXPECT_NEAR(fit.contact_modulus.value / contact.contact_modulus, 1.0, 1e-8) << what;
    if (fit.model == ContactModel::hertz) return;
    ASSERT_TRUE(fit.work_of_adhesion) << what << ": " << fit.work_of_adhesion.reason;
    EXPECT_NEAR(fit.work_of_adhesion->value / contact.work_of_adhesion, 1.0, 1e-8) << what;
    if (fit.channels == Channels::force_radius) return;
    EXPECT_NEAR(fit.contact_point.value / contact_point, 1.0, 1e-8) << what;
}

std::string named(ContactModel model, Channels channels, FitErrors errors) {
    return to_string(model) + " " + std::to_string(static_cast<int>(channels)) + " " + to_string(errors);
}

void expect_recovered_by_all(const BranchData& data, const LensAndCounterBody& bodies, ContactModel model,
                             const AdhesiveContact& contact) {
    for (const Channels channels : all_channels)
        for (const FitErrors errors : both_errors)
            expect_recovered(fit_model(data, bodies, {.model = model, .channels = channels, .errors = errors}), contact,
                             named(model, channels, errors));
    for (const Channels channels : {Channels::force_radius, Channels::force_displacement})
        expect_recovered(fit_model(data, bodies, {.model = model, .channels = channels, .errors = FitErrors::force_only}), contact,
                         named(model, channels, FitErrors::force_only));
}

TEST(ModelFits, RecoverJkrFromNoiseFreeData) {
    expect_recovered_by_all(jkr_branch(), rubber_on_diamond(), ContactModel::jkr, lens);
}

TEST(ModelFits, RecoverHertzFromNoiseFreeData) {
    const contact::SphereOnFlat dry{.radius = lens.radius, .contact_modulus = lens.contact_modulus};
    const BranchData data = branch(
        1e-5, contact::hertz::contact_radius(1e-3, dry), [&](double a) { return contact::hertz::force(a * a / dry.radius, dry); },
        [&](double a) { return a * a / dry.radius; });
    expect_recovered_by_all(data, rubber_on_diamond(), ContactModel::hertz, lens);
}

TEST(ModelFits, RecoverDmtFromNoiseFreeData) {
    const BranchData data = branch(
        1e-5, contact::dmt::contact_radius_at_force(1e-3, lens), [&](double a) { return contact::dmt::force(a, lens); },
        [&](double a) { return contact::dmt::displacement(a, lens); });
    expect_recovered_by_all(data, rubber_on_diamond(), ContactModel::dmt, lens);
}

TEST(ModelFits, RecoverLargeStrainFromNoiseFreeData) {
    const AdhesiveContact soft{.radius = 1.25e-3, .contact_modulus = 3e3, .work_of_adhesion = 0.040};
    const BranchData data = branch(
        1.1 * contact::large_strain::pull_off_at_fixed_load(soft).contact_radius, 0.7 * soft.radius,
        [&](double a) { return contact::large_strain::force(a, soft); },
        [&](double a) { return contact::large_strain::displacement(a, soft); });
    expect_recovered_by_all(data, rubber_on_diamond(), ContactModel::large_strain, soft);
}

TEST(ModelFits, RecoverLayerFromNoiseFreeData) {
    LensAndCounterBody bodies = rubber_on_diamond();
    bodies.layer_thickness = 30e-6;
    const contact::layer::Layer layer(30e-6, bodies.lens_poisson_ratio);
    const BranchData data = branch(
        1.1 * contact::layer::pull_off_at_fixed_load(lens, layer).contact_radius, 130e-6,
        [&](double a) { return contact::layer::force(a, lens, layer); },
        [&](double a) { return contact::layer::displacement(a, lens, layer); });
    expect_recovered_by_all(data, bodies, ContactModel::layer, lens);
}

TEST(ModelFits, RecoverMaugisDugdaleFromNoiseFreeData) {
    for (const double lambda : {0.1, 0.5, 1.5, 5.0}) {
        const auto contact = zone_contact(lambda);
        const BranchData data = zone_branch(contact);
        for (const Channels channels : all_channels) {
            const ModelFit fit = fit_model(data, rubber_on_diamond(), {.model = ContactModel::maugis_dugdale, .channels = channels});
            const std::string what = named(fit.model, channels, fit.errors) + " λ = " + std::to_string(lambda);
            expect_recovered(fit, lens, what);
            ASSERT_TRUE(fit.transition_parameter) << what << fit.transition_parameter.reason;
            EXPECT_NEAR(fit.transition_parameter->value / lambda, 1.0, 1e-8) << what;
            EXPECT_NEAR(fit.cohesive_stress->value / contact.cohesive_stress, 1.0, 1e-8) << what;
        }
    }
}

TEST(ModelFits, RecoverTransitionFromNoiseFreeData) {
    for (const double lambda : {0.1, 0.5, 1.5, 3.0}) {
        const auto contact = zone_contact(lambda);
        const auto curve = contact::transition::curve_of(contact);
        BranchData data;
        data.force = Array1D::LinSpaced(150, 0.95 * curve.pull_off_force, 1e-3);
        data.contact_radius = contact::transition::contact_radius(data.force, curve);
        for (const FitErrors errors : {FitErrors::force_only, FitErrors::effective_variance, FitErrors::orthogonal_distance}) {
            const ModelFit fit = fit_model(data, rubber_on_diamond(), {.model = ContactModel::transition, .errors = errors});
            const std::string what = named(fit.model, fit.channels, errors) + " λ = " + std::to_string(lambda);
            expect_recovered(fit, lens, what);
            ASSERT_TRUE(fit.cohesive_stress) << what << fit.cohesive_stress.reason;
            EXPECT_NEAR(fit.transition_share->value / curve.transition_share, 1.0, 1e-8) << what;
            EXPECT_NEAR(fit.cohesive_stress->value / contact.cohesive_stress, 1.0, 1e-7) << what;  // the inverse keeps 1e-8 of W
        }
    }
}

}  // namespace
}  // namespace setae::experiment
