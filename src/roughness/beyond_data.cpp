// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/roughness/beyond_data.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/roughness/true_area.hpp"
#include "straight_line.hpp"

namespace setae::roughness {
namespace {

/// p of a straight line through ln C over the last decade.
LineSlope last_exponent(const spectra::Spectrum& curve) {
    const double last = curve.band.upper;
    std::vector<double> x, y;
    for (Index i = 0; i < curve.wavevector.size(); ++i) {
        const double q = curve.wavevector[i];
        if (q < 0.1 * last || q < curve.band.lower || q > last || !(curve.density[i] > 0.0)) continue;
        x.push_back(std::log(q / last));
        y.push_back(std::log(curve.density[i]));
    }
    if (x.size() < 3)
        throw UndefinedDataError(
            fmt::format("{} nodes in the last decade of a spectrum; expected 3 to continue it", x.size()));
    return slope_through(x, y);
}

SpectralParameters continued(spectra::Spectrum curve, double exponent, double up_to) {
    const auto n =
        std::upper_bound(curve.wavevector.begin(), curve.wavevector.end(), curve.band.upper) - curve.wavevector.begin();
    const double end = values_at(curve, Array1D::Constant(1, curve.band.upper * (1.0 - 1e-12)))[0];
    const Index kept = curve.wavevector[n - 1] < curve.band.upper * (1.0 - 1e-9) ? n : n - 1;
    Array1D q(kept + 2), C(kept + 2);
    q << curve.wavevector.head(kept), curve.band.upper, up_to;
    C << curve.density.head(kept), end, end * std::pow(up_to / curve.band.upper, exponent);
    curve.wavevector = std::move(q);
    curve.density = std::move(C);
    curve.band.upper = up_to;
    return spectral_parameters(curve);
}

}  // namespace

BeyondData beyond_data(const spectra::Spectrum& curve, double up_to) {
    if (curve.nodes == spectra::Nodes::modes) throw InvalidArgument("modes cannot be continued; combine them first");
    if (!(up_to > curve.band.upper))
        throw InvalidArgument(
            fmt::format("a spectrum to {:.4g} 1/m continued to {:.4g}; expected more", curve.band.upper, up_to));
    constexpr double least_error = 0.2, normal_quantile = 1.96;
    const auto end = last_exponent(curve);
    const double error = std::max(least_error, end.standard_error);
    const auto at = [&](double quantile) { return continued(curve, end.value + quantile * error, up_to); };
    const auto middle = at(0.0), least = at(-normal_quantile), most = at(normal_quantile);
    const auto estimate = [&](auto value_of) {
        return Estimate{.value = value_of(middle),
                        .standard_error = (value_of(most) - value_of(least)) / (2.0 * normal_quantile),
                        .method = "power law continued",
                        .interval = Interval{value_of(least), value_of(most), 0.95}};
    };
    BeyondData result{.end = curve.band.upper, .up_to = up_to};
    result.exponent = {.value = end.value - (curve.kind == spectra::Density::C_iso ? 0.0 : 1.0),
                       .standard_error = error,
                       .method = "least squares"};
    result.rms_slope = estimate([](const SpectralParameters& p) { return p.rms_slope; });
    result.excess_area = estimate([](const SpectralParameters& p) { return gaussian_area_ratio(p.rms_slope) - 1.0; });
    result.elastic_energy_per_modulus =
        estimate([](const SpectralParameters& p) { return p.elastic_energy_per_modulus; });
    return result;
}

}  // namespace setae::roughness
