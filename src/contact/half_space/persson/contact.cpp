// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/persson/contact.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/expint.hpp>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::persson {
namespace {

void require_positive(double value, const char* name, const char* unit) {
    if (!(value > 0.0) || !std::isfinite(value))
        throw InvalidArgument(fmt::format("{} is {} {}; expected > 0", name, value, unit));
}

/// ∫_s^∞ erf(x)² exp(−x²) dx/x; the part beyond s + 6 is below 1e-16 of it.
double squared_error_integral(double s) {
    const auto integrand = [](double x) { return x > 0.0 ? std::pow(std::erf(x), 2) * std::exp(-x * x) / x : 0.0; };
    return boost::math::quadrature::gauss<double, 30>::integrate(integrand, s, s + 6.0);
}

/// W, dW/dp and ∫_p^∞ (dW/dp) dp/p at one scale.
struct Share {
    double energy, slope, gap;
};

Share share_at(double pressure, double variance, double factor) {
    const double width = std::sqrt(2.0 * variance), s = pressure / width;
    const double rate = 2.0 / (std::sqrt(pi) * width);
    const double area = std::erf(s);
    // beyond, exp(−s²) is 0
    const double lone = s < 26.0 ? 0.5 * boost::math::expint(1, s * s) : 0.0;
    return {.energy = area * (factor + (1.0 - factor) * area * area),
            .slope = rate * std::exp(-s * s) * (factor + 3.0 * (1.0 - factor) * area * area),
            .gap = rate * (factor * lone + 3.0 * (1.0 - factor) * squared_error_integral(s))};
}

}  // namespace

double pressure_density(double pressure, double mean_pressure, double pressure_variance) {
    require_positive(mean_pressure, "mean pressure", "Pa");
    require_positive(pressure_variance, "pressure variance", "Pa2");
    if (!(pressure > 0.0)) return 0.0;
    // the difference of the two, without cancellation near p = 0
    return std::exp(-0.5 * std::pow(pressure - mean_pressure, 2) / pressure_variance) *
           -std::expm1(-2.0 * pressure * mean_pressure / pressure_variance) / std::sqrt(2.0 * pi * pressure_variance);
}

double area_fraction(double mean_pressure, double pressure_variance) {
    require_positive(mean_pressure, "mean pressure", "Pa");
    if (pressure_variance == 0.0) return 1.0;
    require_positive(pressure_variance, "pressure variance", "Pa2");
    return std::erf(mean_pressure / std::sqrt(2.0 * pressure_variance));
}

ContactAtScales contact_at_scales(double pressure, const Scales& scales, double energy_factor) {
    require_positive(pressure, "pressure", "Pa");
    if (!(energy_factor > 0.0 && energy_factor <= 1.0))
        throw InvalidArgument(fmt::format("energy factor is {}; expected above 0 and at most 1", energy_factor));
    const Index n = scales.wavevector.size();
    ContactAtScales contact{Array1D::Ones(n), Array1D::Zero(n), Array1D::Zero(n),
                            Array1D::Constant(n, std::numeric_limits<double>::infinity())};
    double slope = 0.0;
    for (Index i = 1; i < n; ++i) {
        contact.area_fraction[i] = persson::area_fraction(pressure, scales.pressure_variance[i]);
        const double energy = scales.stored_energy[i] - scales.stored_energy[i - 1];
        // middle in √V: exact for functions proportional to 1/√V, such as dW/dp at low load
        const double width =
            0.5 * (std::sqrt(scales.pressure_variance[i - 1]) + std::sqrt(scales.pressure_variance[i]));
        const Share share = width > 0.0 ? share_at(pressure, width * width, energy_factor) : Share{1.0, 0.0, 0.0};
        contact.stored_energy[i] = contact.stored_energy[i - 1] + energy * share.energy;
        contact.mean_gap[i] = contact.mean_gap[i - 1] + energy * share.gap;
        slope += energy * share.slope;
        if (slope > 0.0) contact.contact_stiffness[i] = pressure / slope;
    }
    return contact;
}

}  // namespace setae::persson
