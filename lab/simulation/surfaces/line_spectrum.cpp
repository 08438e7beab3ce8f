// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "setae/core/constants.hpp"

namespace setae::simulation {
namespace {

constexpr double nodes_per_unit = 100.0 / std::numbers::ln10;  // 100 per decade
constexpr double below_rolloff = 1e-3;

/// √(q_s² − q²), by which C1D goes to zero; kept off zero.
double end_factor(double wavevector, double upper) {
    return std::sqrt(std::max(upper * upper - wavevector * wavevector, 1e-12 * upper * upper));
}

}  // namespace

double profile_value(const spectra::SpectralDensity& C_iso, double wavevector, double short_wavevector) {
    if (!(wavevector < short_wavevector)) return 0.0;
    constexpr double points_per_unit = 30.0;
    const double extent = std::acosh(short_wavevector / wavevector);
    const auto points = std::max<Index>(8, static_cast<Index>(std::ceil(points_per_unit * extent)));
    const double step = extent / static_cast<double>(points);
    double sum = 0.0;
    for (Index i = 0; i < points; ++i) {
        const double q = wavevector * std::cosh((static_cast<double>(i) + 0.5) * step);
        sum += q * C_iso(std::min(q, short_wavevector));
    }
    return sum * step / pi;
}

LineSpectrum::LineSpectrum(const KnownSurface& surface)
    : stretch_(surface.anisotropy.stretch),
      surface_angle_(surface.anisotropy.angle),
      first_(below_rolloff * surface.band().lower),
      upper_(surface.band().upper) {
    const auto nodes = static_cast<Index>(std::ceil(nodes_per_unit * std::log(upper_ / first_)));
    spacing_ = std::log(upper_ / first_) / static_cast<double>(nodes);
    log_values_.resize(nodes + 1);
    for (Index i = 0; i <= nodes; ++i) {
        // the last node is just before the end, where C1D/√ has its limit
        const double q = std::min(first_ * std::exp(static_cast<double>(i) * spacing_), upper_ * (1.0 - 1e-9));
        log_values_[i] = std::log(std::max(profile_value(surface.C_iso, q, upper_), 1e-300) / end_factor(q, upper_));
    }
}

double LineSpectrum::isotropic(double wavevector) const {
    if (!(wavevector < upper_)) return 0.0;
    const double at = std::log(std::max(wavevector, first_) / first_) / spacing_;
    const Index left = std::min(static_cast<Index>(at), log_values_.size() - 2);
    const double share = std::min(at - static_cast<double>(left), 1.0);
    return std::exp(log_values_[left] + share * (log_values_[left + 1] - log_values_[left])) *
           end_factor(std::max(wavevector, first_), upper_);
}

double LineSpectrum::contraction(double angle) const {
    return stretch_ / std::hypot(stretch_ * std::sin(angle), std::cos(angle));
}

double LineSpectrum::along(double angle, double wavevector) const {
    const double factor = contraction(angle);
    return factor * isotropic(factor * wavevector);
}

double LineSpectrum::averaged(double wavevector) const {
    if (stretch_ == 1.0) return isotropic(wavevector);
    constexpr int directions = 64;  // directions of a quarter turn
    double sum = 0.0;
    for (int i = 0; i < directions; ++i) sum += along(0.5 * pi * (i + 0.5) / directions, wavevector);
    return sum / directions;
}

}  // namespace setae::simulation
