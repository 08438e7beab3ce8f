// SPDX-License-Identifier: GPL-3.0-or-later
// Elastocapillarity: the body's surface has a stress Υ of its own, k(q) = E*q/2 + Υq², and an inclined place gains by
// its true area, w(x) = W_int √(1 + |∇h|²). The solver below shares only the Fourier transforms with AdhesiveCell.
#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/half_space/elastic_operator.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::patches {
namespace {

constexpr Index n = 64;
constexpr double waves_per_side = 2.0, points_per_wave = 8.0;
constexpr double work = 0.037, surface_stress = 0.025;  // W_int, Υ = γ1 [J/m²]

/// Dalvi et al. 2019, Table S1, and the self-affine spectra that have its three moments.
struct Surface {
    const char* name;
    double rms_height, hurst_exponent, rolloff_wavelength;
};
constexpr Surface polished{"PUNCD", 4.6e-9, 0.883, 0.287e-6}, ultra{"UNCD", 23.4e-9, 0.977, 0.282e-6},
    nano{"NCD", 121.7e-9, 0.879, 3.76e-6}, micro{"MCD", 126.6e-9, 0.896, 3.81e-6};

/// C_iso of all scales, its height as published.
spectra::SpectralDensity density_of(const Surface& surface) {
    const double shortest = 1.6e10, rolloff = 2.0 * pi / surface.rolloff_wavelength, H = surface.hurst_exponent;
    const double squares = 0.5 * rolloff * rolloff + std::pow(rolloff, 2.0 + 2.0 * H) *
                                                         (std::pow(rolloff, -2.0 * H) - std::pow(shortest, -2.0 * H)) /
                                                         (2.0 * H);
    const double plateau = 2.0 * pi * surface.rms_height * surface.rms_height / squares;
    return [=](double q) { return plateau * std::pow(std::max(q, rolloff) / rolloff, -2.0 - 2.0 * H); };
}

/// The band of the surface whose longest wave is given, on a periodic patch.
Array2D heights_of(const Surface& surface, double longest, double side) {
    const auto all = density_of(surface);
    const double least = 2.0 * pi / longest, most = 2.0 * pi * static_cast<double>(n) / (points_per_wave * side);
    const auto band = [=](double q) { return q < 0.999 * least || q > 1.001 * most ? 0.0 : all(q); };
    Array2D heights =
        synthesis::random_surface(band, {n, n, side, side}, {.key = {1}, .amplitudes = synthesis::Amplitudes::exact})
            .heights;
    return heights - heights.mean();
}

/// |∇h|² by fourth-order differences.
Array2D squared_slopes(const Array2D& heights, double pixel) {
    const auto slope = [pixel](double next, double last, double after, double before) {
        return (8.0 * (next - last) - (after - before)) / (12.0 * pixel);
    };
    return Array2D::NullaryExpr(n, n, [&](Index i, Index j) {
        const auto at = [&](Index di, Index dj) { return heights((i + di + n) % n, (j + dj + n) % n); };
        const double x = slope(at(1, 0), at(-1, 0), at(2, 0), at(-2, 0)),
                     y = slope(at(0, 1), at(0, -1), at(0, 2), at(0, -2));
        return x * x + y * y;
    });
}

struct Outcome {
    double contact_share = 0.0;
    double gain = 0.0;     ///< of the state from far [J/m²]
    double balance = 0.0;  ///< full-contact balance (Eq. 7) to second order in slope [J/m²]
};

class ElastocapillaryPatch {
public:
    ElastocapillaryPatch(const Surface& surface, double contact_modulus, double longest)
        : side_(waves_per_side * longest),
          elastic_({n, n, side_, side_}, {.contact_modulus = contact_modulus}),
          stiffness_(elastic_.multiplier([=](double k) { return k + capillary(2.0 * k / contact_modulus); })),
          heights_(heights_of(surface, longest, side_)),
          works_(work * (1.0 + squared_slopes(heights_, pixel())).sqrt()) {
        const double finest = 0.5 * contact_modulus * pi / pixel() + capillary(pi / pixel());
        // as w dx/(E*ρ²) = 1/2 resolves the edge of a contact without surface stress
        range_ = std::sqrt(work * pi / finest);
        steepest_ = 0.5 * contact_modulus * std::sqrt(2.0) * pi / pixel() + 2.0 * capillary(pi / pixel());
    }

    /// Accelerated projected gradients with restarts, from where the highest point is felt.
    Outcome from_far() {
        Array2D gaps = heights_.maxCoeff() - heights_ + 2.0 * range_, ahead = gaps, slope(n, n);
        double momentum = 1.0, moved = range_;
        for (int iteration = 0; moved > 1e-7 * range_ && iteration < 20000; ++iteration) {
            energy(ahead, slope);
            const Array2D next = (ahead - slope / steepest_).max(0.0);
            const bool uphill = ((ahead - next) * (next - gaps)).sum() > 0.0;
            const double grown = uphill ? 1.0 : 0.5 * (1.0 + std::sqrt(1.0 + 4.0 * momentum * momentum));
            const double share = uphill ? 0.0 : (momentum - 1.0) / grown;
            ahead = (next + share * (next - gaps)).max(0.0);
            moved = (next - gaps).abs().maxCoeff();
            gaps = next;
            momentum = grown;
        }
        Array2D pressures(n, n);
        apply(heights_, pressures);
        return {.contact_share = static_cast<double>((gaps <= 0.0).count()) / static_cast<double>(n * n),
                .gain = -energy(gaps, slope),
                .balance = works_.mean() - 0.5 * (heights_ * pressures).mean()};
    }

private:
    static double capillary(double q) { return surface_stress * q * q; }
    [[nodiscard]] double pixel() const { return side_ / static_cast<double>(n); }

    void apply(const Array2D& displacements, Array2D& pressures) {
        elastic_.apply(
            stiffness_,
            [&](Index i, double* row) { Eigen::Map<Eigen::Array<double, 1, n>>(row, n) = displacements.row(i); },
            [&](Index i, const double* row) {
                pressures.row(i) = Eigen::Map<const Eigen::Array<double, 1, n>>(row, n);
            });
    }

    double energy(const Array2D& gaps, Array2D& slope) {
        const Array2D displacements = gaps + heights_, attraction = works_ * (-gaps / range_).exp();
        apply(displacements, slope);
        const double stored = 0.5 * (displacements * slope).mean();
        slope += attraction / range_;
        return stored - attraction.mean();
    }

    double side_, range_ = 0.0, steepest_ = 0.0;
    half_space::ElasticOperator elastic_;
    fourier::Multiplier stiffness_;
    Array2D heights_, works_;
};

constexpr double moduli[] = {0.91999923e6, 1.37333162e6, 2.54666079e6, 13.37317133e6};

// the eleven published pairs of the full-contact balance with U_el/AW up to 0.3, in the band of each that stores most
TEST(Elastocapillarity, SurfaceStressAndSlopesDoNotChangeTheFullContactBalance) {
    struct Pairs {
        Surface surface;
        int moduli;
    };
    for (const auto& pairs : {Pairs{polished, 4}, Pairs{ultra, 3}, Pairs{nano, 2}, Pairs{micro, 2}})
        for (int k = 0; k < pairs.moduli; ++k) {
            const auto found =
                ElastocapillaryPatch(pairs.surface, moduli[k], pairs.surface.rolloff_wavelength).from_far();
            EXPECT_GT(found.contact_share, 0.95) << pairs.surface.name << ' ' << moduli[k];
            EXPECT_NEAR(found.gain / found.balance, 1.0, 0.006) << pairs.surface.name << ' ' << moduli[k];
        }
}

// waves far below 2Υ/E* = 54 nm, where the surface stress holds the body and not its bulk
TEST(Elastocapillarity, KeepsTheFullContactBalanceWhenSurfaceStressDominates) {
    for (const auto& surface : {polished, ultra, nano, micro}) {
        const auto found = ElastocapillaryPatch(surface, moduli[0], 10e-9).from_far();
        EXPECT_GT(found.contact_share, 0.95) << surface.name;
        EXPECT_NEAR(found.gain / found.balance, 1.0, 0.006) << surface.name;
    }
}

// the same solver opens what has no full contact, and gains more than the balance
TEST(Elastocapillarity, OpensAPairWithoutFullContact) {
    const auto found = ElastocapillaryPatch(ultra, moduli[3], ultra.rolloff_wavelength).from_far();
    EXPECT_LT(found.contact_share, 0.7);
    EXPECT_GT(found.gain, found.balance + 0.1 * work);
}

}  // namespace
}  // namespace setae::patches
