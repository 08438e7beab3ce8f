// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/persson/scales.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "setae/roughness/spectral_moments.hpp"

namespace setae::persson {
namespace {

constexpr double nodes_per_decade = 100.0;

/// The same curve with more nodes on its power laws.
spectra::Spectrum refined(const spectra::Spectrum& curve) {
    if (curve.nodes == spectra::Nodes::modes) return curve;
    std::vector<double> q, density;
    double left = 0.0, at_left = 0.0;
    for (Index i = 0; i < curve.wavevector.size(); ++i) {
        const double right = curve.wavevector[i], at_right = curve.density[i];
        if (!(at_right > 0.0)) continue;
        if (left > 0.0) {
            const double pieces = std::ceil(std::log10(right / left) * nodes_per_decade - 1e-9);
            for (double piece = 1.0; piece < pieces; ++piece) {
                q.push_back(left * std::pow(right / left, piece / pieces));
                density.push_back(at_left * std::pow(at_right / at_left, piece / pieces));
            }
        }
        q.push_back(right), density.push_back(at_right);
        left = right, at_left = at_right;
    }
    spectra::Spectrum result{.band = curve.band, .kind = curve.kind, .waves_end = curve.waves_end};
    result.wavevector = Eigen::Map<const Array1D>(q.data(), static_cast<Index>(q.size()));
    result.density = Eigen::Map<const Array1D>(density.data(), static_cast<Index>(density.size()));
    return result;
}

}  // namespace

Scales scales_of(const spectra::Spectrum& spectrum, const half_space::Body& body) {
    half_space::require(body);
    const auto below = roughness::cumulative_parameters(refined(spectrum));
    const Index n = below.wavevector.size();
    Scales scales{below.wavevector, Array1D(n), Array1D::Zero(n), Array1D::Zero(n)};
    for (Index i = 0; i < n; ++i) {
        const double q = scales.wavevector[i];
        scales.stiffness[i] = half_space::stiffness(q, body);
        if (i == 0) continue;
        const double middle = std::sqrt(scales.wavevector[i - 1] * q);
        const double per_wavevector = half_space::stiffness(middle, body) / middle;
        const double squared_slope = std::pow(below.rms_slope[i], 2) - std::pow(below.rms_slope[i - 1], 2);
        const double energy = below.elastic_energy_per_modulus[i] - below.elastic_energy_per_modulus[i - 1];
        scales.pressure_variance[i] =
            scales.pressure_variance[i - 1] + std::pow(per_wavevector, 2) * std::max(0.0, squared_slope);
        scales.stored_energy[i] = scales.stored_energy[i - 1] + 2.0 * per_wavevector * std::max(0.0, energy);
    }
    return scales;
}

}  // namespace setae::persson
