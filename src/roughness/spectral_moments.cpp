// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/roughness/spectral_moments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <boost/math/quadrature/gauss.hpp>
#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::roughness {
namespace {

/// C1D = level · (q/q_left)^exponent between two wavevectors.
struct PowerLaw {
    double left, right, level, exponent;
};

/// A curve as power laws that cover its band, in order.
std::vector<PowerLaw> pieces(const Array1D& wavevector, const Array1D& density, const Band& band) {
    std::vector<double> q, c;
    for (Index i = 0; i < wavevector.size(); ++i)
        if (std::isfinite(density[i]) && density[i] > 0.0) {
            q.push_back(wavevector[i]);
            c.push_back(density[i]);
        }
    if (q.size() < 2)
        throw UndefinedDataError(fmt::format("a spectrum with {} usable values cannot be integrated, expected at least 2", q.size()));
    std::vector<PowerLaw> result;
    for (std::size_t i = 0; i + 1 < q.size(); ++i) {
        const double exponent = std::log(c[i + 1] / c[i]) / std::log(q[i + 1] / q[i]);
        const double left = i == 0 ? std::min(q[0], band.lower) : q[i];
        const double right = i + 2 == q.size() ? std::max(q[i + 1], band.upper) : q[i + 1];
        const double from = std::max(left, band.lower), to = std::min(right, band.upper);
        if (from < to) result.push_back({from, to, c[i] * std::pow(from / q[i], exponent), exponent});
    }
    return result;
}

/// ∫ q^order C dq over one piece, without cancellation where order + exponent is near −1.
double integral(const PowerLaw& piece, double order) {
    const double s = piece.exponent + order + 1.0;
    const double log_ratio = std::log(piece.right / piece.left);
    const double growth = std::abs(s * log_ratio) < 1e-8 ? log_ratio * (1.0 + 0.5 * s * log_ratio) : std::expm1(s * log_ratio) / s;
    return piece.level * std::pow(piece.left, order + 1.0) * growth;
}

/// The same weighted with 1/√(1 − (q/q_s)²): q = q_s sin t takes the singularity at q_s away.
double weighted_integral(const PowerLaw& piece, double order, double q_s) {
    const double t0 = std::asin(std::min(1.0, piece.left / q_s)), t1 = std::asin(std::min(1.0, piece.right / q_s));
    const auto integrand = [&](double t) {
        const double q = q_s * std::sin(t);
        return q_s * std::pow(q, order) * piece.level * std::pow(q / piece.left, piece.exponent);
    };
    return boost::math::quadrature::gauss<double, 15>::integrate(integrand, t0, t1);
}

struct Moments {
    double height = 0.0, energy = 0.0, slope = 0.0, curvature = 0.0;  // orders 0, 1, 2, 4
};

SpectralParameters exact_parameters(const Moments& m) {
    return {std::sqrt(m.height / pi), std::sqrt(2.0 * m.slope / pi), std::sqrt(2.0 * m.curvature / (3.0 * pi)), m.energy / 8.0};
}

}  // namespace

SpectrumCurve limited(SpectrumCurve curve, const WavelengthLimits& limits) {
    if (limits.longest) curve.band.lower = std::max(curve.band.lower, 2.0 * pi / *limits.longest);
    if (limits.shortest) curve.band.upper = std::min(curve.band.upper, 2.0 * pi / *limits.shortest);
    if (!(curve.band.lower < curve.band.upper))
        throw InvalidArgument(fmt::format("no wavevector between {:.4g} and {:.4g} 1/m is left; widen longest_wavelength and "
                                          "shortest_wavelength",
                                          curve.band.lower, curve.band.upper));
    return curve;
}

double spectral_integral(const SpectrumCurve& curve, double order, Conversion conversion) {
    double sum = 0.0;
    for (const auto& piece : pieces(curve.wavevector, curve.C1D, curve.band))
        sum += conversion == Conversion::exact ? integral(piece, order) : weighted_integral(piece, order, curve.band.upper);
    return sum;
}

SpectralParameters spectral_parameters(const SpectrumCurve& curve, Conversion conversion) {
    const Moments m{spectral_integral(curve, 0.0, conversion), spectral_integral(curve, 1.0, conversion),
                    spectral_integral(curve, 2.0, conversion), spectral_integral(curve, 4.0, conversion)};
    if (conversion == Conversion::exact) return exact_parameters(m);
    return {std::sqrt(m.height / 2.0), std::sqrt(m.slope / 2.0), std::sqrt(m.curvature / 8.0), m.energy / 8.0};
}

SpectralParameters spectral_parameters(const IsotropicCurve& curve) {
    const auto parts = pieces(curve.wavevector, curve.C_iso, curve.band);
    const auto moment = [&](double order) {
        double sum = 0.0;
        for (const auto& piece : parts) sum += integral(piece, order);
        return sum;
    };
    return {std::sqrt(moment(1.0) / (2.0 * pi)), std::sqrt(moment(3.0) / (2.0 * pi)), std::sqrt(moment(5.0) / (8.0 * pi)),
            moment(2.0) / (8.0 * pi)};
}

CumulativeParameters cumulative_parameters(const SpectrumCurve& curve) {
    const auto parts = pieces(curve.wavevector, curve.C1D, curve.band);
    const auto n = static_cast<Index>(parts.size()) + 1;
    CumulativeParameters result{Array1D(n), Array1D(n), Array1D(n), Array1D(n), Array1D(n)};
    Moments sum;
    for (Index i = 0; i < n; ++i) {
        const auto parameters = exact_parameters(sum);
        result.wavevector[i] = i == 0 ? parts.front().left : parts[static_cast<std::size_t>(i - 1)].right;
        result.rms_height[i] = parameters.rms_height;
        result.rms_slope[i] = parameters.rms_slope;
        result.rms_curvature[i] = parameters.rms_curvature;
        result.elastic_energy_per_modulus[i] = parameters.elastic_energy_per_modulus;
        if (i + 1 == n) break;
        const auto& piece = parts[static_cast<std::size_t>(i)];
        sum.height += integral(piece, 0.0);
        sum.energy += integral(piece, 1.0);
        sum.slope += integral(piece, 2.0);
        sum.curvature += integral(piece, 4.0);
    }
    return result;
}

}  // namespace setae::roughness
