// SPDX-License-Identifier: GPL-3.0-or-later
#include "self_affine_model.hpp"

#include <algorithm>
#include <cmath>

namespace setae::spectra {

SelfAffineLines::SelfAffineLines(const spectra::SelfAffine& model, double lowest, double highest)
    : end_(model.short_wavevector), first_(std::log(lowest)) {
    constexpr double close_to_end = 1.0 - 1e-9;  // there C1D is proportional to √(q_s² − q²)
    constexpr double nodes_per_decade = 40.0;
    const double last = std::log(std::min(highest, close_to_end * end_));
    const auto count =
        std::max<Index>(2, static_cast<Index>(std::ceil((last - first_) / std::log(10.0) * nodes_per_decade)) + 1);
    spacing_ = (last - first_) / static_cast<double>(count - 1);
    const Array1D nodes = (Array1D::LinSpaced(count, first_, last)).exp().min(close_to_end * end_);
    log_values_ = (spectra::profile_power_spectrum(model, nodes) / (1.0 - (nodes / end_).square()).sqrt()).log();
}

double SelfAffineLines::operator()(double wavevector) const {
    if (wavevector >= end_) return 0.0;
    const double place = std::max(0.0, (std::log(wavevector) - first_) / spacing_);
    const Index node = std::min(static_cast<Index>(place), log_values_.size() - 2);
    const double t = place - static_cast<double>(node), x = wavevector / end_;
    return std::exp((1.0 - t) * log_values_[node] + t * log_values_[node + 1]) * std::sqrt(1.0 - x * x);
}

}  // namespace setae::spectra
