// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/roughness/beyond_data.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/roughness/true_area.hpp"

namespace setae::roughness {
namespace {

/// ln C(q_e) and p of a straight line through the last decade, and the standard error of p.
struct End {
    double level = 0.0, exponent = 0.0, error = 0.0;
};

End end_of(const spectra::Spectrum& curve) {
    const double last = curve.band.upper;
    std::vector<double> x, y;
    for (Index i = 0; i < curve.wavevector.size(); ++i) {
        const double q = curve.wavevector[i];
        if (q < 0.1 * last || q < curve.band.lower || q > last || !(curve.density[i] > 0.0)) continue;
        x.push_back(std::log(q / last));
        y.push_back(std::log(curve.density[i]));
    }
    const auto n = static_cast<double>(x.size());
    if (x.size() < 3)
        throw UndefinedDataError(
            fmt::format("{} nodes in the last decade of a spectrum; expected 3 to continue it", x.size()));
    double mean_x = 0.0, mean_y = 0.0, xx = 0.0, xy = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        mean_x += x[i] / n;
        mean_y += y[i] / n;
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - mean_x) * (x[i] - mean_x);
        xy += (x[i] - mean_x) * (y[i] - mean_y);
    }
    const double slope = xy / xx;
    for (std::size_t i = 0; i < x.size(); ++i) squares += std::pow(y[i] - mean_y - slope * (x[i] - mean_x), 2);
    return {mean_y - slope * mean_x, slope, std::sqrt(squares / (n - 2.0) / xx)};
}

/// ∫_1^t u^order du.
double power_integral(double order, double t) {
    const double s = order + 1.0, log_t = std::log(t);
    return std::abs(s * log_t) < 1e-8 ? log_t : std::expm1(s * log_t) / s;
}

SpectralParameters continued(const spectra::Spectrum& curve, const SpectralParameters& within, const End& end,
                             double exponent, double up_to) {
    const bool isotropic = curve.kind == spectra::Density::C_iso;
    const double q = curve.band.upper, t = up_to / q, level = std::exp(end.level);
    const double shift = isotropic ? 1.0 : 0.0;  // ∫ q^{n+1} C_iso dq where C1D has ∫ q^n C1D dq
    const auto integral = [&](double order) {
        return level * std::pow(q, order + shift + 1.0) * power_integral(exponent + order + shift, t);
    };
    auto result = within;
    result.rms_slope =
        std::sqrt(within.rms_slope * within.rms_slope + integral(2.0) * (isotropic ? 1.0 / (2.0 * pi) : 2.0 / pi));
    result.elastic_energy_per_modulus += integral(1.0) / (8.0 * (isotropic ? pi : 1.0));
    return result;
}

}  // namespace

BeyondData beyond_data(const spectra::Spectrum& curve, double up_to) {
    if (!(up_to > curve.band.upper))
        throw InvalidArgument(
            fmt::format("a spectrum to {:.4g} 1/m continued to {:.4g}; expected more", curve.band.upper, up_to));
    constexpr double least_error = 0.2, normal_quantile = 1.96;
    const auto end = end_of(curve);
    const auto within = spectral_parameters(curve);
    const double error = std::max(least_error, end.error);
    const auto at = [&](double quantile) {
        return continued(curve, within, end, end.exponent + quantile * error, up_to);
    };
    const auto middle = at(0.0), least = at(-normal_quantile), most = at(normal_quantile);
    const auto estimate = [&](auto value_of) {
        return Estimate{.value = value_of(middle),
                        .standard_error = (value_of(most) - value_of(least)) / (2.0 * normal_quantile),
                        .method = "power law continued",
                        .interval = Interval{value_of(least), value_of(most), 0.95}};
    };
    BeyondData result{.end = curve.band.upper, .up_to = up_to};
    result.exponent = {.value = end.exponent - (curve.kind == spectra::Density::C_iso ? 0.0 : 1.0),
                       .standard_error = error,
                       .method = "least squares"};
    result.rms_slope = estimate([](const SpectralParameters& p) { return p.rms_slope; });
    result.excess_area = estimate([](const SpectralParameters& p) { return gaussian_area_ratio(p.rms_slope) - 1.0; });
    result.elastic_energy_per_modulus =
        estimate([](const SpectralParameters& p) { return p.elastic_energy_per_modulus; });
    return result;
}

}  // namespace setae::roughness
