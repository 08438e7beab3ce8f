// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/model_fits.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include <Eigen/Dense>

#include "setae/contact/dmt.hpp"
#include "setae/contact/hertz.hpp"
#include "setae/contact/large_strain.hpp"
#include "setae/contact/layer.hpp"
#include "setae/contact/maugis_dugdale.hpp"
#include "setae/contact/transition.hpp"
#include "setae/core/errors.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::model_fits_test {
namespace {

using contact::AdhesiveContact;
using tests::rubber_on_diamond;

constexpr AdhesiveContact lens{.radius = 1.25e-3, .contact_modulus = 0.92e6, .work_of_adhesion = 0.040};
constexpr double contact_point = 3.7e-6;
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
        least, contact::jkr::contact_radius_at_force(1e-3, contact),
        [&](double a) { return contact::jkr::force(a, contact); },
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
        for (const FitErrors errors :
             {FitErrors::force_only, FitErrors::effective_variance, FitErrors::orthogonal_distance}) {
            if (errors == FitErrors::force_only && channels == Channels::force_displacement_radius) continue;
            // without measured radii the two are one
            if (errors == FitErrors::effective_variance && channels == Channels::force_displacement) continue;
            expect_recovered(fit_model(data, bodies, {.model = model, .channels = channels, .errors = errors}), contact,
                             named(model, channels, errors));
        }
}

TEST(ModelFits, RecoverJkrFromNoiseFreeData) {
    expect_recovered_by_all(jkr_branch(), rubber_on_diamond(), ContactModel::jkr, lens);
}

TEST(ModelFits, RecoverHertzFromNoiseFreeData) {
    const contact::SphereOnFlat dry{.radius = lens.radius, .contact_modulus = lens.contact_modulus};
    const BranchData data = branch(
        1e-5, contact::hertz::contact_radius(1e-3, dry),
        [&](double a) { return contact::hertz::force(a * a / dry.radius, dry); },
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
        [&](double a) { return contact::layer::displacement(a, lens, layer); }, 60);
    expect_recovered_by_all(data, bodies, ContactModel::layer, lens);
}

class MaugisDugdaleFits : public testing::TestWithParam<double> {};

TEST_P(MaugisDugdaleFits, RecoverNoiseFreeData) {
    const double lambda = GetParam();
    const auto contact = zone_contact(lambda);
    const BranchData data = zone_branch(contact, 80);
    for (const Channels channels : all_channels) {
        const ModelFit fit =
            fit_model(data, rubber_on_diamond(), {.model = ContactModel::maugis_dugdale, .channels = channels});
        const std::string what = named(fit.model, channels, fit.errors);
        expect_recovered(fit, lens, what);
        ASSERT_TRUE(fit.transition_parameter) << what << fit.transition_parameter.reason;
        EXPECT_NEAR(fit.transition_parameter->value / lambda, 1.0, 1e-8) << what;
        EXPECT_NEAR(fit.cohesive_stress->value / contact.cohesive_stress, 1.0, 1e-8) << what;
    }
}

INSTANTIATE_TEST_SUITE_P(FromDmtToJkr, MaugisDugdaleFits, testing::Values(0.1, 0.4, 1.5, 5.0));

TEST(ModelFits, RecoverTransitionFromNoiseFreeData) {
    for (const double lambda : {0.1, 0.5, 1.5, 3.0}) {
        const auto contact = zone_contact(lambda);
        const auto curve = contact::transition::curve_of(contact);
        BranchData data;
        data.force = Array1D::LinSpaced(150, 0.95 * curve.pull_off_force, 1e-3);
        data.contact_radius = contact::transition::contact_radius(data.force, curve);
        for (const FitErrors errors :
             {FitErrors::force_only, FitErrors::effective_variance, FitErrors::orthogonal_distance}) {
            const ModelFit fit =
                fit_model(data, rubber_on_diamond(), {.model = ContactModel::transition, .errors = errors});
            const std::string what = named(fit.model, fit.channels, errors) + " λ = " + std::to_string(lambda);
            expect_recovered(fit, lens, what);
            ASSERT_TRUE(fit.cohesive_stress) << what << fit.cohesive_stress.reason;
            EXPECT_NEAR(fit.transition_share->value / curve.transition_share, 1.0, 1e-8) << what;
            EXPECT_NEAR(fit.cohesive_stress->value / contact.cohesive_stress, 1.0, 1e-7)
                << what;  // the inverse keeps 1e-8 of W
        }
    }
}

BranchData noisy(const BranchData& exact, double share, std::mt19937_64& generator) {
    BranchData data = exact;
    const auto disturb = [&](Array1D& series, double& noise) {
        noise = share * (series.maxCoeff() - series.minCoeff());
        series = tests::with_noise(series, noise, generator);
    };
    disturb(data.force, data.force_noise);
    disturb(data.displacement, data.displacement_noise);
    disturb(data.contact_radius, data.contact_radius_noise);
    return data;
}

TEST(ModelFits, OrthogonalDistanceIsUnbiasedWithCorrectErrors) {
    constexpr int repetitions = 60;
    const BranchData exact = jkr_branch(lens, 80);
    std::mt19937_64 generator(21);
    for (const Channels channels : {Channels::force_radius, Channels::force_displacement_radius}) {
        double sum = 0.0, squares = 0.0, chi2 = 0.0;
        for (int k = 0; k < repetitions; ++k) {
            const ModelFit fit = fit_model(noisy(exact, 0.03, generator), rubber_on_diamond(), {.channels = channels});
            const double pull =
                (fit.work_of_adhesion->value - lens.work_of_adhesion) / fit.work_of_adhesion->standard_error;
            sum += pull;
            squares += pull * pull;
            chi2 += fit.chi2_reduced / repetitions;
        }
        EXPECT_LT(std::abs(sum / repetitions), 4.0 / std::sqrt(repetitions));
        // Student's t of some 78 degrees of freedom; a scatter of 60 is known to 9 %
        EXPECT_NEAR(std::sqrt(squares / repetitions), 1.0, 0.3);
        EXPECT_NEAR(chi2, 1.0, 4.0 * std::sqrt(2.0 / (78.0 * repetitions)));
    }
}

TEST(ModelFits, OnlyOrthogonalDistanceIsUnbiasedByErrorsOfRadius) {
    const BranchData exact = jkr_branch(lens, 2000);
    std::mt19937_64 generator(5);
    const BranchData data = noisy(exact, 0.06, generator);
    const auto pull = [&](FitErrors errors) {
        const ModelFit fit =
            fit_model(data, rubber_on_diamond(), {.channels = Channels::force_radius, .errors = errors});
        return std::abs(fit.contact_modulus.value - lens.contact_modulus) / fit.contact_modulus.standard_error;
    };
    EXPECT_GT(pull(FitErrors::force_only), 4.0);
    EXPECT_LT(pull(FitErrors::orthogonal_distance), 3.0);
}

TEST(ModelFits, EffectiveVarianceEqualsALinearFit) {
    std::mt19937_64 generator(8);
    const BranchData data = noisy(jkr_branch(), 0.02, generator);
    const Array1D dry = 4.0 * data.contact_radius.cube() / (3.0 * lens.radius),
                  edge = (8.0 * pi * data.contact_radius.cube()).sqrt();
    Eigen::Vector2d found(lens.contact_modulus, std::sqrt(lens.contact_modulus * lens.work_of_adhesion));
    for (int round = 0; round < 60; ++round) {
        const Array1D slope = (3.0 * found[0] * dry - 1.5 * found[1] * edge) / data.contact_radius;
        const Array1D weight =
            (data.force_noise * data.force_noise + (slope * data.contact_radius_noise).square()).rsqrt();
        Eigen::Matrix2d normal;
        normal << (weight * dry).square().sum(), -(weight.square() * dry * edge).sum(),
            -(weight.square() * dry * edge).sum(), (weight * edge).square().sum();
        found = normal.inverse() * Eigen::Vector2d((weight.square() * dry * data.force).sum(),
                                                   -(weight.square() * edge * data.force).sum());
    }
    const ModelFit fit = fit_model(data, rubber_on_diamond(),
                                   {.channels = Channels::force_radius, .errors = FitErrors::effective_variance});
    EXPECT_NEAR(fit.contact_modulus.value / found[0], 1.0, 1e-8);
    EXPECT_NEAR(fit.work_of_adhesion->value / (found[1] * found[1] / found[0]), 1.0, 1e-8);
}

TEST(ModelFits, FixedParametersAreUnchangedAndExact) {
    const auto contact = zone_contact(0.7);
    const BranchData data = zone_branch(contact, 80);
    const ModelFitOptions model{.model = ContactModel::maugis_dugdale};
    ModelFitOptions held = model;
    held.contact_point = contact_point;
    held.cohesive_stress = contact.cohesive_stress;
    ModelFit fit = fit_model(data, rubber_on_diamond(), held);
    expect_recovered(fit, lens, "σ0 and δ0 held");
    EXPECT_EQ(fit.parameters, (std::vector<std::string>{"contact_modulus", "work_of_adhesion"}));
    EXPECT_EQ(fit.cohesive_stress->standard_error, 0.0);
    EXPECT_NEAR(fit.transition_parameter->value, 0.7, 1e-8);
    held = model;
    held.transition_parameter = 0.7;
    held.work_of_adhesion = lens.work_of_adhesion;
    fit = fit_model(data, rubber_on_diamond(), held);
    expect_recovered(fit, lens, "λ and W held");
    EXPECT_EQ(fit.work_of_adhesion->standard_error, 0.0);
    held = {.contact_modulus = lens.contact_modulus};
    fit = fit_model(jkr_branch(), rubber_on_diamond(), held);
    expect_recovered(fit, lens, "E* held");
    EXPECT_EQ(fit.contact_modulus.method, "given");
}

TEST(ModelFits, RangeOfAttractionIsUndeterminedFarFromTheTransition) {
    std::mt19937_64 generator(3);
    const BranchData data = noisy(jkr_branch(lens, 100), 0.005, generator);
    const ModelFit zone = fit_model(data, rubber_on_diamond(),
                                    {.model = ContactModel::maugis_dugdale, .channels = Channels::force_radius});
    EXPECT_FALSE(zone.transition_parameter);
    EXPECT_FALSE(zone.cohesive_stress);
    ASSERT_FALSE(zone.undetermined.empty());
    EXPECT_NE(zone.undetermined.front().find("does not determine"), std::string::npos) << zone.undetermined.front();
    ASSERT_TRUE(zone.work_of_adhesion) << zone.work_of_adhesion.reason;
    EXPECT_NEAR(zone.work_of_adhesion->value / lens.work_of_adhesion, 1.0, 0.1);
    const ModelFit curve =
        fit_model(data, rubber_on_diamond(), {.model = ContactModel::transition, .channels = Channels::force_radius});
    EXPECT_FALSE(curve.cohesive_stress);
    EXPECT_NEAR(curve.work_of_adhesion->value / lens.work_of_adhesion, 1.0, 0.1);
}

TEST(ModelFits, WOfMaugisDugdaleIsUndeterminedFromHighForcesOnly) {
    std::mt19937_64 generator(4);
    BranchData data = noisy(jkr_branch(lens, 100), 0.005, generator);
    for (Array1D* series : {&data.force, &data.displacement, &data.contact_radius}) *series = series->tail(60).eval();
    const ModelFitOptions zone{.model = ContactModel::maugis_dugdale, .channels = Channels::force_displacement};
    const ModelFit fit = fit_model(data, rubber_on_diamond(), zone);
    ASSERT_FALSE(fit.work_of_adhesion);
    EXPECT_NE(fit.work_of_adhesion.reason.find("give the cohesive stress"), std::string::npos)
        << fit.work_of_adhesion.reason;
    // no more than an order of preference: correlated residuals leave few samples to decide by
    const ModelComparison comparison = compare_models(data, rubber_on_diamond(), zone);
    for (const ComparedModel& model : comparison.models)
        EXPECT_EQ(model.fit.value.has_value(), std::isfinite(model.akaike_difference)) << to_string(model.model);
}

TEST(ModelFits, ResidualsAreDistancesToTheNearestPoint) {
    std::mt19937_64 generator(9);
    const BranchData data = noisy(jkr_branch(lens, 60), 0.02, generator);
    const ModelFit fit = fit_model(data, rubber_on_diamond());
    const AdhesiveContact found{.radius = lens.radius,
                                .contact_modulus = fit.contact_modulus.value,
                                .work_of_adhesion = fit.work_of_adhesion->value};
    double chi2 = 0.0;
    for (Index i = 0; i < 60; ++i) {
        const auto distance = [&](double t) {
            return std::pow((data.force[i] - contact::jkr::force(t, found)) / data.force_noise, 2) +
                   std::pow((data.displacement[i] - fit.contact_point.value - contact::jkr::displacement(t, found)) /
                                data.displacement_noise,
                            2) +
                   std::pow((data.contact_radius[i] - t) / data.contact_radius_noise, 2);
        };
        const double foot = fit.fitted_radius[i], step = 1e-4 * foot;
        EXPECT_LE(distance(foot), std::min(distance(foot - step), distance(foot + step)));
        EXPECT_NEAR(fit.contact_radius_residuals.values[i], data.contact_radius[i] - foot, 1e-18);
        chi2 += distance(foot);
    }
    EXPECT_NEAR(fit.chi2 / chi2, 1.0, 1e-9);
    EXPECT_EQ(fit.degrees_of_freedom, 120.0 - 3.0);
}

TEST(ModelFits, ErrorOfTheZeroOfForceIsAdded) {
    std::mt19937_64 generator(13);
    BranchData data = noisy(jkr_branch(), 0.01, generator);
    const ModelFit sure = fit_model(data, rubber_on_diamond());
    data.force_zero_modes = Array2D::Constant(data.force.size(), 1, 2e-5);
    const ModelFit unsure = fit_model(data, rubber_on_diamond());
    EXPECT_GT(unsure.work_of_adhesion->standard_error, 1.5 * sure.work_of_adhesion->standard_error);
    EXPECT_NEAR(std::sqrt(unsure.covariance(0, 0)) / unsure.contact_modulus.standard_error, 1.0, 1e-12);
}

TEST(ModelFits, ComparisonFindsTheTrueModel) {
    std::mt19937_64 generator(17);
    LensAndCounterBody bodies = rubber_on_diamond();
    const ModelComparison sticky =
        compare_models(noisy(jkr_branch(lens, 120), 0.003, generator), bodies, {.channels = Channels::force_radius});
    // Maugis–Dugdale at large λ and large strain at small a/R are the same curve with as many or more parameters
    ASSERT_TRUE(sticky.best);
    const auto& models = sticky.models;
    const auto of = [&](ContactModel model) { return models[static_cast<std::size_t>(model)]; };
    EXPECT_LT(of(ContactModel::jkr).akaike_difference, 3.0);
    EXPECT_GT(of(ContactModel::dmt).akaike_difference, 100.0);
    EXPECT_GT(of(ContactModel::hertz).akaike_difference, 100.0);
    EXPECT_FALSE(of(ContactModel::layer).fit);
    EXPECT_NE(of(ContactModel::layer).fit.reason.find("thickness"), std::string::npos);
    double weights = 0.0;
    for (const ComparedModel& model : models) weights += model.akaike_weight;
    EXPECT_NEAR(weights, 1.0, 1e-12);
    const ModelComparison between =
        compare_models(noisy(zone_branch(zone_contact(0.7), 120), 0.002, generator), bodies);
    EXPECT_EQ(between.best, ContactModel::maugis_dugdale);
    EXPECT_NE(between.sentence.find("maugis_dugdale fits best"), std::string::npos) << between.sentence;
    EXPECT_FALSE(between.models[static_cast<std::size_t>(ContactModel::transition)].fit);
}

TEST(ModelFits, ModelNamesConvertToModelsAndBack) {
    for (const ContactModel model : contact_models()) EXPECT_EQ(model_named(to_string(model)), model);
    try {
        (void)model_named("maugis_dugdal");
        FAIL() << "a name that no model has was taken";
    } catch (const InvalidArgument& error) {
        EXPECT_NE(std::string(error.what()).find("did you mean 'maugis_dugdale'"), std::string::npos) << error.what();
    }
}

TEST(ModelFits, RefuseInvalidData) {
    const BranchData data = jkr_branch();
    const LensAndCounterBody bodies = rubber_on_diamond();
    EXPECT_THROW((void)fit_model(data, bodies, {.model = ContactModel::layer}), InvalidArgument);
    EXPECT_THROW((void)fit_model(data, bodies, {.model = ContactModel::transition}),
                 InvalidArgument);  // of three channels
    EXPECT_THROW((void)fit_model(data, bodies, {.errors = FitErrors::force_only}), InvalidArgument);
    EXPECT_THROW((void)fit_model(data, bodies, {.cohesive_stress = 1e5}), InvalidArgument);
    EXPECT_THROW((void)fit_model(data, bodies, {.model = ContactModel::hertz, .work_of_adhesion = 0.1}),
                 InvalidArgument);
    EXPECT_THROW((void)fit_model(data, bodies, {.contact_modulus = -1.0}), InvalidArgument);
    BranchData alone = data;
    alone.displacement = alone.contact_radius = Array1D();
    EXPECT_THROW((void)fit_model(alone, bodies), UndefinedDataError);
    EXPECT_THROW((void)fit_model(alone, bodies, {.channels = Channels::force_radius}), UndefinedDataError);
    BranchData constant = data;
    constant.force.setConstant(1e-4);
    EXPECT_THROW((void)fit_model(constant, bodies), UndefinedDataError);
    LensAndCounterBody thin = bodies;
    thin.layer_thickness = 5e-6;  // radii beyond five thicknesses
    EXPECT_THROW((void)fit_model(data, thin, {.model = ContactModel::layer}), InvalidArgument);
}

}  // namespace
}  // namespace setae::loops::model_fits_test
