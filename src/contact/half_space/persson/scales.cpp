// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/persson/scales.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "first_nodes.hpp"
#include "setae/roughness/spectral_moments.hpp"

namespace setae::persson {
namespace {

constexpr double nodes_per_decade = 100.0;

/// Power laws through the usable nodes of a curve, extrapolated at the ends.
class PowerLaws {
public:
    explicit PowerLaws(const spectra::Spectrum& curve) {
        for (Index i = 0; i < curve.wavevector.size(); ++i)
            if (curve.density[i] > 0.0) {
                q_.push_back(curve.wavevector[i]);
                density_.push_back(curve.density[i]);
            }
    }

    [[nodiscard]] const std::vector<double>& nodes() const { return q_; }
    [[nodiscard]] double at(double q) const {
        const auto above = std::upper_bound(q_.begin() + 1, q_.end() - 1, q) - q_.begin();
        const auto i = static_cast<std::size_t>(above);
        const double part = std::log(q / q_[i - 1]) / std::log(q_[i] / q_[i - 1]);
        return density_[i - 1] * std::pow(density_[i] / density_[i - 1], part);
    }

private:
    std::vector<double> q_, density_;
};

/// Wavevectors of the curve, and more between.
std::vector<double> refined(const std::vector<double>& nodes, double lower) {
    std::vector<double> q;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
        const double ratio = nodes[i + 1] / nodes[i];
        const double pieces = std::ceil(std::log10(ratio) * nodes_per_decade - 1e-9);
        for (double piece = 0.0; piece < pieces; ++piece) q.push_back(nodes[i] * std::pow(ratio, piece / pieces));
    }
    q.push_back(nodes.back());
    // where their steps are as long as those of the others
    double distance = lower * (std::pow(10.0, 1.0 / nodes_per_decade) - 1.0) / (growth - 1.0);
    for (int k = 0; k < first_nodes; ++k, distance /= growth)
        if (lower + distance < q.back()) q.push_back(lower + distance);
    std::sort(q.begin(), q.end());
    q.erase(std::unique(q.begin(), q.end()), q.end());
    return q;
}

/// The curve with more nodes on its power laws.
spectra::Spectrum refined(const spectra::Spectrum& curve) {
    const PowerLaws laws(curve);
    if (curve.nodes == spectra::Nodes::modes || laws.nodes().size() < 2) return curve;
    const auto q = refined(laws.nodes(), curve.band.lower);
    spectra::Spectrum result{.band = curve.band, .kind = curve.kind, .waves_end = curve.waves_end};
    result.wavevector = Eigen::Map<const Array1D>(q.data(), static_cast<Index>(q.size()));
    result.density = result.wavevector.unaryExpr([&laws](double at) { return laws.at(at); });
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
