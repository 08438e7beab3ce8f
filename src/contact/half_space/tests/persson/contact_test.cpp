// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/persson/contact.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <boost/math/quadrature/gauss_kronrod.hpp>

#include "self_affine_curve.hpp"
#include "setae/adhesion/stored_energy.hpp"
#include "setae/contact/layer.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/persson/cell_scales.hpp"
#include "setae/persson/stress_diffusion.hpp"
#include "setae/roughness/spectral_moments.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::persson::contact_test {
namespace {

constexpr double modulus = 1e9;

Scales rough() { return scales_of(self_affine_curve(), {.contact_modulus = modulus}); }

double last(const Array1D& values) { return values[values.size() - 1]; }

double integral(const auto& function, double from, double to) {
    return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(function, from, to, 12, 1e-12);
}

TEST(PerssonScales, EndAtSlopeAndStoredEnergyOfTheSpectrum) {
    const auto curve = self_affine_curve();
    const auto scales = rough();
    const double slope = roughness::spectral_parameters(curve).rms_slope;
    EXPECT_NEAR(last(scales.pressure_variance) / (0.25 * modulus * modulus * slope * slope), 1.0, 1e-12);
    EXPECT_NEAR(last(scales.stored_energy) / adhesion::stored_energy(modulus, curve), 1.0, 1e-12);
    EXPECT_EQ(scales.pressure_variance[0], 0.0);
    EXPECT_NEAR(last(scales.stiffness) / (0.5 * modulus * last(scales.wavevector)), 1.0, 1e-15);
}

TEST(PerssonScales, OfAProfileSpectrumHaveTheEnergyOfTheSurface) {
    auto curve = self_affine_curve();
    curve.kind = spectra::Density::C1D;
    curve.density = spectra::profile_power_spectrum(model(), curve.wavevector * (1.0 - 1e-9));
    const auto scales = scales_of(curve, {.contact_modulus = modulus});
    EXPECT_NEAR(last(scales.stored_energy) / adhesion::stored_energy(modulus, curve), 1.0, 1e-3);
}

// (E*/4) Σ |q| |h_q|² of a map that has the spectrum mode by mode
TEST(PerssonScales, HaveTheEnergyOfAMapOfTheSpectrum) {
    const synthesis::SurfaceGrid grid{512, 512, 8e-6, 8e-6};
    const auto map = synthesis::random_surface(spectra::density(model()), grid,
                                               {.key = {7}, .amplitudes = synthesis::Amplitudes::exact});
    auto curve = self_affine_curve();
    curve.band.lower = 2.0 * pi / 8e-6;
    const auto scales = scales_of(curve, {.contact_modulus = modulus});
    // the plateau's sum over modes and its integral differ by the square about q = 0
    EXPECT_NEAR(adhesion::stored_energy(modulus, map) / last(scales.stored_energy), 1.0, 0.01);
}

TEST(CellScales, HaveTheSlopeOfCellsAndTendToTheSpectrum) {
    const auto C_iso = spectra::density(model());
    const half_space::Body body{.contact_modulus = modulus};
    double far_off = 1.0;
    for (const Index waves : {1, 4, 16}) {  // of the roll-off's length
        const double side = 2e-6 * static_cast<double>(waves);
        const half_space::Grid grid{100 * waves, 100 * waves, side, side};
        const auto cell = scales_of_cell(C_iso, grid, body);
        const double slope =
            synthesis::expected_roughness(C_iso, synthesis::SurfaceGrid{grid.nx, grid.ny, side, side}).rms_slope;
        EXPECT_NEAR(last(cell.pressure_variance) / (0.25 * modulus * modulus * slope * slope), 1.0, 1e-5);
        EXPECT_EQ(cell.pressure_variance[0], 0.0);
        for (Index i = 1; i < cell.pressure_variance.size(); ++i)
            ASSERT_GT(cell.pressure_variance[i], cell.pressure_variance[i - 1]);
        const double energy =
            0.25 * modulus / pi * integral([&](double q) { return 0.5 * q * q * C_iso(q); }, 1.0, 1.256e8);
        const double off = std::abs(last(cell.stored_energy) / energy - 1.0);
        EXPECT_LT(off, 0.6 * far_off);
        far_off = off;
    }
    EXPECT_LT(far_off, 0.01);
}

TEST(PerssonContact, OfACellDoesNotDependOnNodes) {
    // one wave each way: V and U rise together, and A = erf(p/√2V) can be integrated by hand
    const double side = 1e-6, level = 1e-30;
    const double q = 2.0 * pi / side;
    const spectra::SpectralDensity C_iso = [&](double at) { return at < 1.1 * q ? level : 0.0; };
    const auto cell = scales_of_cell(C_iso, {8, 8, side, side}, {.contact_modulus = modulus});
    const double k = 0.5 * modulus * q, variance = 4.0 * k * k * level / (side * side);
    EXPECT_NEAR(last(cell.pressure_variance) / variance, 1.0, 1e-12);
    const double pressure = 0.3 * std::sqrt(variance);
    const auto contact = contact_at_scales(pressure, cell, 1.0);
    const double stored =
        integral([&](double v) { return std::erf(pressure / std::sqrt(2.0 * v)); }, 0.0, variance) / (2.0 * k);
    EXPECT_NEAR(last(contact.stored_energy) / stored, 1.0, 1e-4);
    EXPECT_THROW((void)scales_of_cell([](double) { return 0.0; }, {8, 8, side, side}, {.contact_modulus = modulus}),
                 UndefinedDataError);
}

TEST(PerssonScales, OfALayerUseItsStiffness) {
    const auto curve = self_affine_curve();
    const double thickness = 0.3e-6;
    const auto layer = scales_of(curve, {.contact_modulus = modulus, .layer = half_space::Layer{thickness, 0.4}});
    const auto thick = scales_of(curve, {.contact_modulus = modulus, .layer = half_space::Layer{1.0, 0.4}});
    EXPECT_NEAR(last(thick.pressure_variance) / last(rough().pressure_variance), 1.0, 1e-12);
    const auto density = spectra::density(model());
    double variance = 0.0, energy = 0.0;
    for (const auto& [from, to] : {std::pair{curve.band.lower, model().rolloff_wavevector},
                                   std::pair{model().rolloff_wavevector, curve.band.upper}}) {
        const auto k = [&](double q) {
            return 0.5 * modulus * q * contact::layer::stiffness_ratio(q * thickness, 0.4);
        };
        variance += integral([&](double q) { return k(q) * k(q) * density(q) * q / (2.0 * pi); }, from, to);
        energy += integral([&](double q) { return k(q) * density(q) * q / (4.0 * pi); }, from, to);
    }
    EXPECT_NEAR(last(layer.pressure_variance) / variance, 1.0, 2e-4);
    EXPECT_NEAR(last(layer.stored_energy) / energy, 1.0, 2e-4);
}

TEST(PressureDensity, IntegratesToAreaAndLoad) {
    const double variance = 4.0;
    for (const double load : {0.1, 1.0, 5.0}) {
        const auto density = [&](double p) { return pressure_density(p, load, variance); };
        EXPECT_NEAR(integral(density, 0.0, 40.0), area_fraction(load, variance), 1e-12);
        EXPECT_NEAR(integral([&](double p) { return p * density(p); }, 0.0, 40.0), load, 1e-11);
    }
    EXPECT_EQ(pressure_density(-1.0, 1.0, variance), 0.0);
    EXPECT_THROW((void)pressure_density(1.0, 0.0, variance), InvalidArgument);
}

TEST(AreaFraction, IsLinearAtLowLoadAndTendsToOne) {
    const double slope = 0.2, variance = 0.25 * modulus * modulus * slope * slope;
    const double load = 1e-5 * modulus * slope;
    EXPECT_NEAR(area_fraction(load, variance) * slope * modulus / load, std::sqrt(8.0 / pi), 1e-9);
    EXPECT_NEAR(area_fraction(0.3 * modulus * slope, variance), std::erf(std::sqrt(2.0) * 0.3), 1e-15);
    EXPECT_NEAR(area_fraction(3.0 * modulus * slope, variance), 1.0, 1e-8);
    EXPECT_EQ(area_fraction(1.0, 0.0), 1.0);
}

TEST(PerssonContact, IsFullContactAtHighLoad) {
    const auto scales = rough();
    const auto contact = contact_at_scales(10.0 * std::sqrt(last(scales.pressure_variance)), scales);
    EXPECT_NEAR(last(contact.area_fraction), 1.0, 1e-12);
    EXPECT_NEAR(last(contact.stored_energy) / last(scales.stored_energy), 1.0, 1e-12);
    EXPECT_LT(last(contact.mean_gap), 1e-22);
}

// p = −dU/dū, in units of the load and by differences
TEST(PerssonContact, StoredEnergyIsTheWorkOfTheLoad) {
    const auto scales = rough();
    for (const double factor : {0.2, 0.45, 1.0})
        for (const double load : {1e5, 1e7, 1e8}) {
            const double step = 1e-4 * load;
            const auto less = contact_at_scales(load - step, scales, factor),
                       more = contact_at_scales(load + step, scales, factor),
                       at = contact_at_scales(load, scales, factor);
            const double approach = last(less.mean_gap) - last(more.mean_gap);
            EXPECT_NEAR((last(more.stored_energy) - last(less.stored_energy)) / (load * approach), 1.0, 1e-6);
            EXPECT_NEAR(last(at.contact_stiffness) * approach / (2.0 * step), 1.0, 1e-6);
        }
}

// u_0 = γ √(2/π) ∫ dh'/q
TEST(PerssonContact, StiffnessIsProportionalToALightLoad) {
    const auto scales = rough();
    double length = 0.0;
    const Array1D slope = 2.0 / modulus * scales.pressure_variance.sqrt();
    for (Index i = 1; i < slope.size(); ++i)
        length += (slope[i] - slope[i - 1]) * 0.5 * (1.0 / scales.wavevector[i] + 1.0 / scales.wavevector[i - 1]);
    for (const double factor : {0.45, 1.0}) {
        const auto contact = contact_at_scales(1.0, scales, factor);
        EXPECT_NEAR(1.0 / (last(contact.contact_stiffness) * factor * std::sqrt(2.0 / pi) * length), 1.0, 2e-4);
        const auto tenth = contact_at_scales(0.1, scales, factor);
        const double difference = last(tenth.mean_gap) - last(contact.mean_gap);
        EXPECT_NEAR(difference * last(contact.contact_stiffness) / std::log(10.0), 1.0, 1e-5);
    }
}

// a spectrum that begins at once, q^-4 from q_0 on: what its first waves do is found at every load, as with nodes a
// thousand times as dense
TEST(PerssonContact, DoesNotDependOnTheNodesOfTheSpectrum) {
    const auto curve_of = [](Index nodes) {
        const Array1D q = Array1D::LinSpaced(nodes, std::log(1e6), std::log(1e9)).exp();
        return spectra::Spectrum{
            .wavevector = q, .density = 0.08 * q.pow(-4.0), .band = {1e6, 1e9}, .kind = spectra::Density::C_iso};
    };
    const auto coarse = scales_of(curve_of(13), {.contact_modulus = modulus}),
               fine = scales_of(curve_of(12001), {.contact_modulus = modulus});
    for (const double load : {1e6, 3e6, 1e7, 3e7, 1e8}) {
        const auto with_few = contact_at_scales(load, coarse), with_many = contact_at_scales(load, fine);
        EXPECT_NEAR(last(with_few.mean_gap) / last(with_many.mean_gap), 1.0, 1e-4) << load;
        EXPECT_NEAR(last(with_few.contact_stiffness) / last(with_many.contact_stiffness), 1.0, 5e-4) << load;
    }
}

TEST(PerssonContact, IsTheSameInOtherUnits) {
    auto curve = self_affine_curve();
    const auto here = contact_at_scales(2e7, rough());
    curve.wavevector *= 1e-3;
    curve.density *= 1e12;
    curve.band = {curve.band.lower * 1e-3, curve.band.upper * 1e-3};
    const auto there = contact_at_scales(2e7, scales_of(curve, {.contact_modulus = modulus}));
    EXPECT_NEAR(last(there.area_fraction) / last(here.area_fraction), 1.0, 1e-12);
    EXPECT_NEAR(last(there.mean_gap) / (1e3 * last(here.mean_gap)), 1.0, 1e-12);
    EXPECT_NEAR(last(there.stored_energy) / (1e3 * last(here.stored_energy)), 1.0, 1e-12);
}

TEST(PerssonContact, RefusesInvalidInput) {
    EXPECT_THROW((void)contact_at_scales(0.0, rough()), InvalidArgument);
    EXPECT_THROW((void)contact_at_scales(1e6, rough(), 0.0), InvalidArgument);
    EXPECT_THROW((void)scales_of(self_affine_curve(), {.contact_modulus = -1.0}), InvalidArgument);
    EXPECT_THROW((void)scales_of(self_affine_curve(), {.contact_modulus = 1.0, .layer = half_space::Layer{0.0}}),
                 InvalidArgument);
}

}  // namespace
}  // namespace setae::persson::contact_test
