// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/simulation/known_surface.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "line_spectrum.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/roughness/true_area.hpp"
#include "setae/synthesis/height_transform.hpp"
#include "spectral_moment.hpp"

namespace setae::simulation {
namespace {

/// ∫ q^(n+1) C dq of the angle-averaged C_iso of the Gaussian heights over a band. With q' = κ(θ) q, κ = √(s² cos²θ +
/// sin²θ): the mean over θ of s κ^(−n−2) times the same of C_iso over κ band.
double moment(const KnownSurface& surface, double order, const Band& band) {
    const auto isotropic = [&](const Band& part) {
        return spectral_moment(surface.C_iso, order, surface.band().lower, part);
    };
    if (surface.isotropic()) return isotropic(band);
    constexpr int directions = 16;  // directions of a quarter turn, periodic: exact to the stretch to the power −32
    const double stretch = surface.anisotropy.stretch, whole = isotropic({0.0, surface.band().upper});
    double sum = 0.0;
    for (int i = 0; i < directions; ++i) {
        const double angle = 0.5 * pi * (i + 0.5) / directions,
                     factor = std::hypot(stretch * std::cos(angle), std::sin(angle));
        double part = whole;
        if (band.lower > 0.0) part -= isotropic({0.0, std::min(factor * band.lower, surface.band().upper)});
        if (factor * band.upper < surface.band().upper) part -= isotropic({factor * band.upper, surface.band().upper});
        sum += stretch * std::pow(factor, -order - 2.0) * part;
    }
    return sum / directions;
}

/// Mean of Eq. 9 over the directions of a slope whose two components differ: it is that of isotropic slopes √2 σ(θ).
double area_ratio(const KnownSurface& surface, double rms_slope) {
    if (surface.isotropic()) return roughness::gaussian_area_ratio(rms_slope);
    constexpr int directions = 32;
    const double stretch = surface.anisotropy.stretch;
    const double across = rms_slope / std::sqrt(0.5 + 0.5 / (stretch * stretch));
    double sum = 0.0;
    for (int i = 0; i < directions; ++i) {
        const double angle = 0.5 * pi * (i + 0.5) / directions;
        sum += roughness::gaussian_area_ratio(across * std::hypot(std::cos(angle) / stretch, std::sin(angle)));
    }
    return sum / directions;
}

/// ⟨f(z)⟩ of a standard normal z: the trapezoid rule, exact to rounding for smooth f.
double normal_mean(const std::function<double(double)>& f) {
    constexpr double step = 0.02;
    constexpr int points = 400;  // to eight standard deviations
    double sum = 0.0, weights = 0.0;
    for (int i = -points; i <= points; ++i) {
        const double z = step * i, weight = std::exp(-0.5 * z * z);
        sum += weight * f(z);
        weights += weight;
    }
    return sum / weights;
}

/// g with its derivatives, by central differences: error step²/6 for derivatives of order 1, rounding 1e-10.
struct SmoothTransform {
    synthesis::HeightTransform g;
    static constexpr double step = 1e-3;

    [[nodiscard]] double slope(double z) const { return (g(z + step) - g(z - step)) / (2.0 * step); }
    [[nodiscard]] double curvature(double z) const { return (g(z + step) - 2.0 * g(z) + g(z - step)) / (step * step); }
};

/// 1 − ρ(r) of the Gaussian heights, ∫ q (1 − J0(qr)) C dq/∫ q C dq, on one grid in ln q.
class StructureFunction {
public:
    explicit StructureFunction(const KnownSurface& surface) : q_(points), weight_(points) {
        const Band band = surface.band();
        const double lower = std::log(1e-3 * band.lower), step = (std::log(band.upper) - lower) / points;
        for (Index i = 0; i < points; ++i) {  // midpoints: none falls on an end of the spectrum
            q_[i] = std::exp(lower + (static_cast<double>(i) + 0.5) * step);
            weight_[i] = q_[i] * q_[i] * surface.C_iso(q_[i]);
        }
        weight_ /= weight_.sum();
    }

    [[nodiscard]] double operator()(double distance) const {
        // beyond it J0 turns faster than the grid can show; it would add a tail of C times a tenth
        constexpr double resolved = 100.0;
        double sum = 0.0;
        for (Index i = 0; i < points; ++i) {
            const double phase = q_[i] * distance;
            sum += weight_[i] * (phase < resolved ? 1.0 - ::j0(phase) : 1.0);
        }
        return sum;
    }

private:
    static constexpr Index points = 1500;
    Array1D q_, weight_;
};

/// U_el/(A E*) = ¼ ∫ [R(0) − R(r)]/r² dr.
double energy_of_transformed(const KnownSurface& surface, const synthesis::HeightTransform& g, double variance,
                             double slope_variance) {
    const StructureFunction parent(surface);
    const synthesis::TransformCorrelation correlation(g);
    const double shortest = 0.05 / surface.band().upper, longest = 300.0 / surface.band().lower;
    constexpr int points = 250;
    const double step = std::log(longest / shortest) / points;
    double sum = 0.0;
    for (int i = 0; i < points; ++i) {
        const double distance = shortest * std::exp((i + 0.5) * step);
        sum += step / distance * (1.0 - correlation.transformed(1.0 - parent(distance)));
    }
    // R(0) − R(r) is h'² r²/4 below the shortest distance and R(0) beyond the longest
    return 0.25 * (variance * (sum + 1.0 / longest) + 0.25 * slope_variance * shortest);
}

spectra::Spectrum profile_curve(const KnownSurface& surface) {
    constexpr double nodes_per_decade = 20.0, decades_below = 2.0;
    const LineSpectrum C1D(surface);
    const Band band = surface.band();
    const double lower = std::log10(band.lower) - decades_below;
    const auto count = static_cast<Index>(std::ceil(nodes_per_decade * (std::log10(band.upper) - lower)));
    spectra::Spectrum curve;
    curve.wavevector = Array1D::NullaryExpr(
        count, [&](Index i) -> double { return std::pow(10.0, lower + static_cast<double>(i) / nodes_per_decade); });
    curve.density = Array1D::NullaryExpr(count, [&](Index i) -> double { return C1D.averaged(curve.wavevector[i]); });
    curve.band = {curve.wavevector[0], band.upper};
    return curve;
}

TrueSurfaceValues true_values_of_gaussian(const KnownSurface& surface, const Band& band) {
    TrueSurfaceValues truth{.source = surface.isotropic()
                                          ? "moments of C_iso; Eq. 9"
                                          : "moments of the angle-averaged C_iso; mean of Eq. 9 over directions"};
    auto& parameters = truth.parameters;
    parameters.rms_height = std::sqrt(moment(surface, 0.0, band) / (2.0 * pi));
    parameters.rms_slope = std::sqrt(moment(surface, 2.0, band) / (2.0 * pi));
    parameters.rms_curvature = std::sqrt(moment(surface, 4.0, band) / (8.0 * pi));
    parameters.elastic_energy_per_modulus = moment(surface, 1.0, band) / (8.0 * pi);
    truth.area_ratio = area_ratio(surface, parameters.rms_slope);
    truth.C1D = profile_curve(surface);
    return truth;
}

TrueSurfaceValues true_values_of_transformed(const KnownSurface& surface) {
    const Band all{0.0, surface.band().upper};
    const double variance = moment(surface, 0.0, all) / (2.0 * pi),
                 slope_variance = moment(surface, 2.0, all) / (2.0 * pi);
    const double s2 = slope_variance / variance, s4 = s2 * s2,
                 v = moment(surface, 4.0, all) / (2.0 * pi) / variance - s4;
    const SmoothTransform transform{synthesis::lognormal_heights(surface.skewness)};
    const double stretch = normal_mean([&](double z) { return std::pow(transform.slope(z), 2); });
    const double curvature = normal_mean([&](double z) {
        const double first = transform.slope(z), second = transform.curvature(z);
        return first * first * (v + s4 * z * z) - 2.0 * first * second * s4 * z + 2.0 * second * second * s4;
    });
    TrueSurfaceValues truth{.source = "means over transformed Gaussian heights; energy from their autocorrelation"};
    truth.parameters = {
        .rms_height = std::sqrt(variance),
        .rms_slope = std::sqrt(stretch * slope_variance),
        .rms_curvature = 0.5 * std::sqrt(variance * curvature),
        .elastic_energy_per_modulus = energy_of_transformed(surface, transform.g, variance, stretch * slope_variance)};
    truth.area_ratio = normal_mean([&](double z) {
        return roughness::gaussian_area_ratio(std::sqrt(slope_variance) * std::abs(transform.slope(z)));
    });
    return truth;
}

}  // namespace

Band KnownSurface::band() const { return {2.0 * pi / rolloff_wavelength, 2.0 * pi / short_wavelength}; }

TrueSurfaceValues true_surface_values(const KnownSurface& surface) {
    return true_surface_values(surface, {0.0, surface.band().upper});
}

TrueSurfaceValues true_surface_values(const KnownSurface& surface, const Band& band) {
    if (!(band.lower >= 0.0) || !(band.upper > band.lower))
        throw InvalidArgument(fmt::format("true values over a band from {} to {} 1/m; expected 0 <= lower < upper",
                                          band.lower, band.upper));
    if (surface.gaussian())
        return true_values_of_gaussian(surface, {band.lower, std::min(band.upper, surface.band().upper)});
    // where the spectrum is flat, transformed heights keep it flat to the square of the skewness
    if (band.upper < surface.band().upper || band.lower > surface.band().lower)
        throw InvalidArgument(fmt::format(
            "true values of transformed heights over a band from {} to {} 1/m; expected all waves shorter than the "
            "roll-off at {} 1/m",
            band.lower, band.upper, surface.band().lower));
    TrueSurfaceValues truth = true_values_of_transformed(surface);
    const double missing = band.lower > 0.0 ? moment(surface, 0.0, {0.0, band.lower}) / (2.0 * pi) : 0.0;
    truth.parameters.rms_height = std::sqrt(truth.parameters.rms_height * truth.parameters.rms_height - missing);
    return truth;
}

}  // namespace setae::simulation
