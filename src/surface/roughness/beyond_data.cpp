// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/roughness/beyond_data.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/log_gamma.hpp"
#include "setae/roughness/true_area.hpp"
#include "straight_line.hpp"

namespace setae::roughness {
namespace {

using spectra::Density, spectra::Nodes, spectra::Spectrum;

/// Nodes of a curve inside its band with nonzero values.
struct NodeList {
    std::vector<double> q, density;

    [[nodiscard]] Index size() const { return std::ssize(q); }
    [[nodiscard]] Eigen::Map<const Array1D> wavevectors() const { return {q.data(), size()}; }
    [[nodiscard]] Eigen::Map<const Array1D> densities() const { return {density.data(), size()}; }
};

NodeList nodes_of(const Spectrum& curve) {
    NodeList list;
    for (Index i = 0; i < curve.wavevector.size(); ++i) {
        const double q = curve.wavevector[i];
        if (q < curve.band.lower || q > curve.band.upper || !(curve.density[i] > 0.0)) continue;
        list.q.push_back(q);
        list.density.push_back(curve.density[i]);
    }
    return list;
}

/// Means over ten bins per decade: the logarithm of a single mode would be too low.
NodeList averaged(const NodeList& modes) {
    struct Sums {
        double log_q = 0.0, density = 0.0, count = 0.0;
    };
    std::map<long, Sums> bins;
    for (std::size_t i = 0; i < modes.q.size(); ++i) {
        auto& bin = bins[std::lround(std::floor(10.0 * std::log10(modes.q[i])))];
        bin.log_q += std::log(modes.q[i]);
        bin.density += modes.density[i];
        bin.count += 1.0;
    }
    NodeList list;
    for (const auto& [number, bin] : bins) {
        list.q.push_back(std::exp(bin.log_q / bin.count));
        list.density.push_back(bin.density / bin.count);
    }
    return list;
}

/// ln C over the decade next to an end, as a straight line in ln(q/end).
Line line_at(const NodeList& nodes, double end) {
    std::vector<double> x, y;
    for (std::size_t i = 0; i < nodes.q.size(); ++i) {
        const double distance = std::log(nodes.q[i] / end);
        if (std::abs(distance) > std::log(10.0) * (1.0 + 1e-9)) continue;
        x.push_back(distance);
        y.push_back(std::log(nodes.density[i]));
    }
    if (x.size() < 3)
        throw UndefinedDataError(fmt::format(
            "{} nodes lie in the decade at the end of the spectrum; expected at least 3 to continue it", x.size()));
    return line_through(x, y);
}

/// C_iso over C1D/q of a power law C_iso ∝ q^p; 0 for p >= −1: the spectrum of lines does not determine such waves.
double abel_factor(double p) {
    return p < -1.0 ? 2.0 * std::sqrt(pi) * std::exp(log_gamma(-0.5 * p) - log_gamma(0.5 * (-p - 1.0))) : 0.0;
}

/// Extrapolation of C_iso from an end.
struct PowerLaw {
    double exponent = 0.0, standard_error = 0.0;
    double level = 0.0;  ///< of the curve at the end
    bool of_lines = false;

    /// C_iso at the end for this exponent.
    [[nodiscard]] double isotropic_level(double end, double p) const {
        return of_lines ? level * abel_factor(p) / end : level;
    }
};

PowerLaw power_law_at(const Spectrum& curve, double end) {
    auto nodes = nodes_of(curve);
    if (curve.nodes == Nodes::modes) nodes = averaged(nodes);
    const auto line = line_at(nodes, end);
    const bool of_lines = curve.kind == Density::C1D;
    return {line.slope - (of_lines ? 1.0 : 0.0), line.slope_error, std::exp(line.level), of_lines};
}

SpectralParameters continued(const SpectralParameters& within, const PowerLaw& law, double exponent, double end,
                             double up_to) {
    Spectrum tail;
    tail.kind = Density::C_iso;
    tail.band = {std::min(end, up_to), std::max(end, up_to)};
    tail.wavevector = Array1D{{tail.band.lower, tail.band.upper}};
    tail.density = law.isotropic_level(end, exponent) * (tail.wavevector / end).pow(exponent);
    auto whole = within;
    if (!(tail.density > 0.0).all()) return whole;
    const auto added = spectral_parameters(tail);
    whole.rms_height = std::hypot(within.rms_height, added.rms_height);
    whole.rms_slope = std::hypot(within.rms_slope, added.rms_slope);
    whole.elastic_energy_per_modulus += added.elastic_energy_per_modulus;
    return whole;
}

}  // namespace

BeyondData beyond_data(const Spectrum& curve, double up_to) {
    const bool towards_short = up_to > curve.band.upper;
    if (!towards_short && !(up_to < curve.band.lower && up_to > 0.0))
        throw InvalidArgument(
            fmt::format("a spectrum from {:.4g} to {:.4g} 1/m continued to {:.4g}; expected a wavevector outside this "
                        "range",
                        curve.band.lower, curve.band.upper, up_to));
    constexpr double min_error = 0.2, normal_quantile = 1.96;
    constexpr double steepest = -4.0, flattest = 0.0;  // of long waves: H = 1 and the plateau
    const double end = towards_short ? curve.band.upper : curve.band.lower;
    auto law = power_law_at(curve, end);
    if (!towards_short) law.exponent = std::clamp(law.exponent, steepest, flattest);
    const double error = std::max(min_error, law.standard_error);
    const auto within = spectral_parameters(curve);
    const double outwards = towards_short ? 1.0 : -1.0;
    const auto at = [&](double quantile) {
        const double exponent = law.exponent + outwards * quantile * error;
        return continued(within, law, towards_short ? exponent : std::clamp(exponent, steepest, flattest), end, up_to);
    };
    const auto middle = at(0.0), least = at(-normal_quantile), most = at(normal_quantile);
    const auto estimate = [&](auto value_of) {
        return Estimate{.value = value_of(middle),
                        .standard_error = (value_of(most) - value_of(least)) / (2.0 * normal_quantile),
                        .method = "power law continued",
                        .interval = Interval{value_of(least), value_of(most), 0.95}};
    };
    BeyondData result{.end = end, .up_to = up_to};
    result.exponent = {.value = law.exponent, .standard_error = error, .method = "least squares"};
    result.rms_height = estimate([](const SpectralParameters& p) { return p.rms_height; });
    result.rms_slope = estimate([](const SpectralParameters& p) { return p.rms_slope; });
    result.excess_area = estimate([](const SpectralParameters& p) { return gaussian_area_ratio(p.rms_slope) - 1.0; });
    result.elastic_energy_per_modulus =
        estimate([](const SpectralParameters& p) { return p.elastic_energy_per_modulus; });
    return result;
}

}  // namespace setae::roughness
