// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact/layer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::contact::layer::layer_test {
namespace {

constexpr AdhesiveContact lens{.radius = 1.25e-3, .contact_modulus = 0.92e6, .work_of_adhesion = 0.05};
constexpr AdhesiveContact dry{.radius = 1.25e-3, .contact_modulus = 0.92e6, .work_of_adhesion = 0.0};

/// The JKR lens parts at a = 62 µm (fixed load): a layer of 40 µm matters.
const Layer& rubber() {
    static const Layer layer(40e-6, 0.5);
    return layer;
}

TEST(LayerStiffness, HasTheLimitsOfThinAndThickLayers) {
    EXPECT_NEAR(stiffness_ratio(30.0, 0.5), 1.0, 1e-15);
    EXPECT_NEAR(stiffness_ratio(19.999, 0.3), 1.0, 1e-13);
    EXPECT_NEAR(stiffness_ratio(1e-3, 0.5) * 2e-9 / 3.0, 1.0, 1e-5);  // Reynolds: 3 µ u/(q² h³)
    for (const double nu : {0.0, 0.3, 0.45})                          // oedometer: M u/h
        EXPECT_NEAR(stiffness_ratio(1e-4, nu) * (1.0 - 2.0 * nu) * 1e-4 / (2.0 * std::pow(1.0 - nu, 2)), 1.0, 1e-3);
    const double below = stiffness_ratio(0.05 * (1.0 - 1e-9), 0.5), above = stiffness_ratio(0.05 * (1.0 + 1e-9), 0.5);
    EXPECT_NEAR(below / above, 1.0, 1e-7);
    EXPECT_THROW((void)stiffness_ratio(0.0, 0.5), InvalidArgument);
    EXPECT_THROW((void)stiffness_ratio(1.0, 0.6), InvalidArgument);
}

TEST(Layer, OfLargeThicknessIsAHalfSpace) {
    const Layer thick(1.0, 0.5);
    for (const double a : {1e-5, 1e-4}) {
        // first order: 1 + 1.13 a/h
        EXPECT_NEAR(force(a, lens, thick) / jkr::force(a, lens), 1.0, 3e-4);
        EXPECT_NEAR(displacement(a, lens, thick) / jkr::displacement(a, lens), 1.0, 3e-4);
    }
    EXPECT_NEAR(pull_off_at_fixed_load(lens, thick).force / jkr::pull_off_at_fixed_load(lens).force, 1.0, 1e-4);
    const Factors none = rubber().factors(0.0);
    for (const double factor : {none.stiffness, none.dry_displacement, none.dry_force, none.edge})
        EXPECT_NEAR(factor, 1.0, 1e-12);
}

TEST(Layer, DeviatesFromThePublishedPolynomialAtSecondOrder) {
    // Dimitriadis et al. 2002, Eq. 12 (ν = 1/2): F over Hertz's at the same δ, χ = √(Rδ)/h; the first order agrees
    // within the 1 % of their fit, and what is missing grows as χ²
    const auto published = [](double chi) {
        return 1.0 + chi * (1.133 + chi * (1.283 + chi * (0.769 + chi * 0.0975)));
    };
    const Layer layer(1.0, 0.5);
    EXPECT_NEAR(layer.factor_slopes(0.0).stiffness / 1.133, 1.0, 0.01);
    const auto missing = [&](double a) {
        const Factors factors = layer.factors(a);
        const double chi = a * std::sqrt(factors.dry_displacement);
        return 1.0 - published(chi) * std::pow(factors.dry_displacement, 1.5) / factors.dry_force;
    };
    EXPECT_NEAR(missing(0.05), 0.0, 1e-3);
    EXPECT_NEAR(missing(0.2), 0.009, 1e-3);  // χ = 0.19
    EXPECT_NEAR(missing(0.5), 0.055, 1e-3);  // χ = 0.42
    EXPECT_NEAR(missing(1.0), 0.135, 1e-3);  // χ = 0.75
}

TEST(Layer, OfIncompressibleRubberTendsToThinFilmFlow) {
    // a thin incompressible layer, bonded below and free to slide above, resists a flat punch as a film in Stokes flow
    // of mobility h³/(3G): F = (π/8) 3G a⁴/h³ δ, G = E*/4, that is s = (3π/64) (a/h)³ (1 + c h/a)⁴ with an edge layer
    // of width c h
    const Layer layer(1.0, 0.5);
    const auto edge_width = [&](double a) {
        return a * (std::pow(layer.factors(a).stiffness / (3.0 * pi / 64.0 * a * a * a), 0.25) - 1.0);
    };
    EXPECT_NEAR(edge_width(4.0) / edge_width(5.0), 1.0, 0.01);
}

TEST(Layer, StiffnessIncreasesWithTheSquareOfTheEdgeFactor) {
    // energy release G = −½ (δ − δ_H)² dS/dA twice over: d(2aE* s)/da = 2E* e²
    for (const double nu : {-0.5, 0.0, 0.3, 0.5}) {
        const Layer layer(1.0, nu);
        for (const double a : {0.01, 0.3, 1.0, 2.7, 4.9}) {
            const Factors at = layer.factors(a), slope = layer.factor_slopes(a);
            EXPECT_NEAR((at.stiffness + a * slope.stiffness) / (at.edge * at.edge), 1.0, 1e-9) << nu << ' ' << a;
        }
    }
}

TEST(Layer, WithoutAdhesionLoadsAsAPunchOfItsRadius) {
    // dF = S(a) dδ where the edge is regular
    for (const double nu : {0.0, 0.5}) {
        const Layer layer(40e-6, nu);
        for (const double a : {1e-5, 6e-5, 1.9e-4}) {
            const double step = 1e-4 * a;
            const double slope = (force(a + step, dry, layer) - force(a - step, dry, layer)) /
                                 (displacement(a + step, dry, layer) - displacement(a - step, dry, layer));
            EXPECT_NEAR(slope / (2.0 * a * dry.contact_modulus * layer.factors(a).stiffness), 1.0, 1e-7);
        }
    }
}

TEST(Layer, SlopesAreDerivativesOfTheFactors) {
    const double a = 7e-5, step = 1e-9;
    const Factors before = rubber().factors(a - step), after = rubber().factors(a + step),
                  slope = rubber().factor_slopes(a);
    EXPECT_NEAR((after.stiffness - before.stiffness) / (2.0 * step) / slope.stiffness, 1.0, 1e-6);
    EXPECT_NEAR((after.dry_displacement - before.dry_displacement) / (2.0 * step) / slope.dry_displacement, 1.0, 1e-6);
    EXPECT_NEAR((after.dry_force - before.dry_force) / (2.0 * step) / slope.dry_force, 1.0, 1e-6);
    EXPECT_NEAR((after.edge - before.edge) / (2.0 * step) / slope.edge, 1.0, 1e-6);
}

TEST(LayerEnergyReleaseRate, EqualsWorkOfAdhesionInEquilibrium) {
    for (const double a : {1e-5, 6e-5, 1.9e-4})
        EXPECT_NEAR(
            energy_release_rate_at_force(a, force(a, lens, rubber()), {lens.radius, lens.contact_modulus}, rubber()) /
                0.05,
            1.0, 1e-9);
}

TEST(LayerRadius, AtForceInvertsForceOnBothBranches) {
    const double fold = pull_off_at_fixed_load(lens, rubber()).contact_radius;
    for (const double factor : {1.01, 1.5, 3.0}) {
        const double a = fold * factor;
        EXPECT_NEAR(contact_radius_at_force(force(a, lens, rubber()), lens, rubber()) / a, 1.0, 1e-10) << factor;
    }
    for (const double factor : {0.01, 0.3, 0.9, 0.99}) {
        const double a = fold * factor;
        EXPECT_NEAR(contact_radius_at_force(force(a, lens, rubber()), lens, rubber(), Branch::inner) / a, 1.0, 1e-10)
            << factor;
    }
}

TEST(LayerRadius, AtDisplacementInvertsDisplacementOnBothBranches) {
    const double fold = pull_off_at_fixed_grips(lens, rubber()).contact_radius;
    for (const double factor : {1.01, 1.5, 4.0}) {
        const double a = fold * factor;
        EXPECT_NEAR(contact_radius_at_displacement(displacement(a, lens, rubber()), lens, rubber()) / a, 1.0, 1e-10)
            << factor;
    }
    for (const double factor : {0.01, 0.3, 0.9, 0.99}) {
        const double a = fold * factor;
        EXPECT_NEAR(contact_radius_at_displacement(displacement(a, lens, rubber()), lens, rubber(), Branch::inner) / a,
                    1.0, 1e-10)
            << factor;
    }
}

TEST(LayerRadius, IsUndefinedBeyondTheFolds) {
    EXPECT_TRUE(std::isnan(
        contact_radius_at_force(pull_off_at_fixed_load(lens, rubber()).force * (1.0 + 1e-9), lens, rubber())));
    EXPECT_TRUE(std::isnan(contact_radius_at_displacement(
        pull_off_at_fixed_grips(lens, rubber()).displacement * (1.0 + 1e-9), lens, rubber())));
    EXPECT_TRUE(std::isnan(contact_radius_at_force(1e-6, lens, rubber(), Branch::inner)));
    EXPECT_TRUE(std::isnan(contact_radius_at_displacement(1e-9, lens, rubber(), Branch::inner)));
    EXPECT_TRUE(std::isnan(contact_radius_at_force(undefined, lens, rubber())));
    EXPECT_TRUE(std::isnan(contact_radius_at_force(-1e-9, dry, rubber())));
}

TEST(LayerPullOff, IsTheMinimumOfTheCurve) {
    for (const double thickness : {15e-6, 40e-6, 1e-3}) {
        const Layer layer(thickness, 0.5);
        const State load = pull_off_at_fixed_load(lens, layer), grips = pull_off_at_fixed_grips(lens, layer);
        const double end = std::min(layer.largest_contact_radius(), 3e-4);
        for (double a = 0.01 * end; a < end; a += 0.01 * end) {
            EXPECT_GE(force(a, lens, layer), load.force * (1.0 + 1e-12));
            EXPECT_GE(displacement(a, lens, layer), grips.displacement * (1.0 + 1e-12));
        }
    }
}

TEST(LayerRadius, OfSeriesEqualsThatOfEachValue) {
    const Array1D loads = Array1D::LinSpaced(5, -3e-4, 1e-3);
    const Array1D radii = contact_radius_at_force(loads, lens, rubber());
    EXPECT_EQ(radii[3], contact_radius_at_force(loads[3], lens, rubber()));
    const Array1D displacements = Array1D::LinSpaced(5, -1e-6, 2e-6);
    EXPECT_EQ(contact_radius_at_displacement(displacements, lens, rubber())[4],
              contact_radius_at_displacement(displacements[4], lens, rubber()));
}

TEST(Layer, RefusesContactsOutsideTheRangeOfItsFactors) {
    EXPECT_THROW((void)rubber().factors(5.01 * 40e-6), InvalidArgument);
    EXPECT_THROW((void)force(2.1e-4, lens, rubber()), InvalidArgument);
    EXPECT_THROW((void)contact_radius_at_force(1.0, lens, rubber()), InvalidArgument);
    EXPECT_THROW((void)contact_radius_at_displacement(1e-3, lens, rubber()), InvalidArgument);
    EXPECT_THROW((void)pull_off_at_fixed_load(lens, Layer(1e-6, 0.5)), InvalidArgument);
}

TEST(Layer, RefusesValuesOutsideItsDomain) {
    EXPECT_THROW(Layer(0.0, 0.5), InvalidArgument);
    EXPECT_THROW(Layer(1e-3, 0.51), InvalidArgument);
    EXPECT_THROW(Layer(1e-3, -1.0), InvalidArgument);
    EXPECT_THROW(Layer(1e-3, undefined), InvalidArgument);
    EXPECT_THROW((void)rubber().factors(-1e-6), InvalidArgument);
    EXPECT_THROW((void)rubber().factors(undefined), InvalidArgument);
    AdhesiveContact bad = lens;
    bad.radius = -1.0;
    EXPECT_THROW((void)force(1e-5, bad, rubber()), InvalidArgument);
    bad = lens;
    bad.work_of_adhesion = -1.0;
    EXPECT_THROW((void)contact_radius_at_force(0.0, bad, rubber()), InvalidArgument);
    EXPECT_THROW((void)energy_release_rate_at_force(0.0, 0.0, {1.0, 1.0}, rubber()), InvalidArgument);
}

}  // namespace
}  // namespace setae::contact::layer::layer_test
