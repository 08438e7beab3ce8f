// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/segment_response.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::spectra {
namespace {

using Complex = std::complex<double>;

constexpr Index largest_group_count = 32, node_count = 24;
constexpr double steepest = 4.9;     // the low end of a steeper spectrum would scatter without bound
constexpr double flat_below = 0.02;  // of Q: the divergence of the power law at p = 0 ends here

double sinc(double x) { return std::abs(x) < 1e-4 ? 1.0 - x * x / 6.0 : std::sin(x) / x; }

double sinc_slope(double x) { return std::abs(x) < 1e-3 ? x / 3.0 : (std::sin(x) / x - std::cos(x)) / x; }

/// κ(q, p) of a segment.
double sampled_part(double q, double p, double step) {
    return std::cos(0.5 * p * step) * sinc(0.5 * q * step) + std::sin(0.5 * p * step) * sinc_slope(0.5 * q * step);
}

/// Means of groups of neighbours in order of size.
Array1D representative_steps(const ArrayView1D& positions) {
    const auto n = positions.size() - 1;
    std::vector<double> steps(static_cast<std::size_t>(n));
    for (Index k = 0; k < n; ++k) steps[static_cast<std::size_t>(k)] = positions[k + 1] - positions[k];
    std::sort(steps.begin(), steps.end());
    const Index groups = std::min(n, largest_group_count);
    Array1D means(groups);
    for (Index g = 0; g < groups; ++g) {
        const Index first = g * n / groups, last = (g + 1) * n / groups;
        means[g] = Eigen::Map<const Array1D>(steps.data() + first, last - first).mean();
    }
    return means;
}

/// V(q, p).
double scattering(const Array1D& steps, double q, double p) {
    const double difference = p - q;
    Array1D part(steps.size());
    Complex along{}, turn{};
    for (Index k = 0; k < steps.size(); ++k) {
        part[k] = steps[k] * sampled_part(q, p, steps[k]);
        along += part[k] * std::polar(1.0, 0.5 * difference * steps[k]);
        // ⟨e^{iδd}⟩ − 1 over iδ, without cancellation
        turn += steps[k] * sinc(0.5 * difference * steps[k]) * std::polar(1.0, 0.5 * difference * steps[k]);
    }
    const Complex common = along / turn;
    double scatter = 0.0;
    for (Index k = 0; k < steps.size(); ++k)
        scatter += std::norm(part[k] - common * steps[k] * sinc(0.5 * difference * steps[k]));
    return scatter / steps.sum();
}

}  // namespace

SegmentResponse::SegmentResponse(const ArrayView1D& positions) : steps_(representative_steps(positions)) {
    band_end_ = pi * static_cast<double>(positions.size() - 1) / (positions[positions.size() - 1] - positions[0]);
    using Rule = boost::math::quadrature::gauss<double, 48>;
    const auto half = static_cast<Index>(Rule::abscissa().size());
    nodes_p_.resize(2 * half);
    weights_p_.resize(2 * half);
    for (Index j = 0; j < half; ++j) {
        const auto i = static_cast<std::size_t>(j);
        nodes_p_[j] = -(nodes_p_[half + j] = band_end_ * Rule::abscissa()[i]);
        weights_p_[j] = weights_p_[half + j] = band_end_ * Rule::weights()[i] / (2.0 * pi);
    }
    nodes_q_ = Array1D::LinSpaced(node_count + 1, 0.0, band_end_);
    scattering_.resize(nodes_q_.size(), nodes_p_.size());
    for (Index i = 0; i < nodes_q_.size(); ++i)
        for (Index j = 0; j < nodes_p_.size(); ++j) scattering_(i, j) = scattering(steps_, nodes_q_[i], nodes_p_[j]);
}

double SegmentResponse::kept(double wavevector) const {
    double sum = 0.0;
    for (Index k = 0; k < steps_.size(); ++k) {
        const double s = sinc(0.5 * wavevector * steps_[k]);
        sum += steps_[k] * s * s;
    }
    const double mean = sum / steps_.sum();
    return mean * mean;
}

Array1D SegmentResponse::scattered(double exponent) const {
    Array1D result = Array1D::Zero(nodes_q_.size());
    for (Index i = 1; i < nodes_q_.size(); ++i)
        for (Index j = 0; j < nodes_p_.size(); ++j) {
            const double p = std::max(std::abs(nodes_p_[j]), flat_below * band_end_);
            result[i] += weights_p_[j] * scattering_(i, j) * std::pow(p / nodes_q_[i], -exponent);
        }
    return result;
}

Array1D SegmentResponse::at(const ArrayView1D& wavevectors, double exponent) const {
    if (!(exponent >= 0.0) || exponent > steepest)
        throw InvalidArgument(
            fmt::format("spectral exponent {} for the response of segments; expected 0 … {}", exponent, steepest));
    const Array1D table = scattered(exponent);
    const double spacing = nodes_q_[1];
    return wavevectors.unaryExpr([&](double q) {
        const double place = std::min(std::abs(q) / spacing, static_cast<double>(node_count));
        const auto node = std::min(static_cast<Index>(place), node_count - 1);
        const double t = place - static_cast<double>(node);
        return kept(q) + (1.0 - t) * table[node] + t * table[node + 1];
    });
}

double SegmentResponse::fitted_exponent(const ArrayView1D& wavevectors, const ArrayView1D& segment_spectrum) const {
    std::vector<Index> used;
    for (Index j = 0; j < wavevectors.size(); ++j)
        if (wavevectors[j] > 0.1 * band_end_ && wavevectors[j] <= band_end_ && segment_spectrum[j] > 0.0)
            used.push_back(j);
    double exponent = 2.0;
    if (used.size() < 3) return exponent;
    const Array1D q = wavevectors(used), C = segment_spectrum(used);
    const Array1D x = q.log() - q.log().mean();
    // R depends weakly on n: three rounds converge far below the scatter of C
    for (int round = 0; round < 3; ++round) {
        const Array1D y = (C / at(q, exponent)).log();
        exponent = std::clamp(-(x * y).sum() / x.square().sum(), 0.0, steepest);
    }
    return exponent;
}

}  // namespace setae::spectra
