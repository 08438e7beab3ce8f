// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/roughness/reconstruction.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <boost/math/tools/toms748_solve.hpp>
#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::roughness {
namespace {

/// ∫ q^p dq between two wavevectors, also at p = −1.
double power_integral(double p, double from, double to) {
    const double log_ratio = std::log(to / from), s = p + 1.0;
    if (std::abs(s * log_ratio) < 1e-9) return std::pow(from, s) * log_ratio;
    return std::pow(from, s) * std::expm1(s * log_ratio) / s;
}

template <class Function>
double bracketed_root(Function f, double lower, double upper) {
    std::uintmax_t iterations = 200;
    const auto [a, b] = boost::math::tools::toms748_solve(f, lower, upper, boost::math::tools::eps_tolerance<double>(50), iterations);
    return 0.5 * (a + b);
}

}  // namespace

double SelfAffineReconstruction::moment(double order, double lower) const {
    double sum = 0.0;
    if (lower < rolloff_wavevector)
        sum += (std::pow(rolloff_wavevector, order + 2.0) - std::pow(lower, order + 2.0)) / (order + 2.0);
    const double from = std::max(lower, rolloff_wavevector);
    if (from < short_wavevector)
        sum += std::pow(rolloff_wavevector, 2.0 + 2.0 * hurst_exponent) *
               power_integral(order - 1.0 - 2.0 * hurst_exponent, from, short_wavevector);
    return plateau * sum / (2.0 * pi);
}

SpectralParameters SelfAffineReconstruction::parameters(double lower) const {
    return {std::sqrt(moment(0.0, lower)), std::sqrt(moment(2.0, lower)), 0.5 * std::sqrt(moment(4.0, lower)), 0.25 * moment(1.0, lower)};
}

SelfAffineReconstruction reconstruct_self_affine(double rms_height, double rms_slope, double rms_curvature, double short_wavevector) {
    if (!(rms_height > 0.0) || !(rms_slope > 0.0) || !(rms_curvature > 0.0) || !(short_wavevector > 0.0))
        throw InvalidArgument(fmt::format("rms height {} m, slope {}, curvature {} 1/m and short cutoff {} 1/m must all be positive",
                                          rms_height, rms_slope, rms_curvature, short_wavevector));
    const double log_lower = std::log(2.0 * pi), log_upper = std::log(short_wavevector * (1.0 - 1e-9));
    const auto with_rolloff = [&](double hurst, double log_rolloff) {
        return SelfAffineReconstruction{hurst, std::exp(log_rolloff), 1.0, short_wavevector};
    };
    // slope/height grows with q_r: where even the ends do not bracket it, the nearer end stands in and H takes the blame
    const auto rolloff_for = [&](double hurst) {
        const auto misfit = [&](double log_rolloff) {
            const auto p = with_rolloff(hurst, log_rolloff).parameters();
            return std::log(p.rms_slope / p.rms_height) - std::log(rms_slope / rms_height);
        };
        if (misfit(log_lower) >= 0.0) return log_lower;
        if (misfit(log_upper) <= 0.0) return log_upper;
        return bracketed_root(misfit, log_lower, log_upper);
    };
    const auto curvature_misfit = [&](double hurst) {
        const auto p = with_rolloff(hurst, rolloff_for(hurst)).parameters();
        return std::log(p.rms_curvature / p.rms_slope) - std::log(rms_curvature / rms_slope);
    };
    constexpr double least_hurst = 1e-3, largest_hurst = 2.0;
    if (curvature_misfit(least_hurst) * curvature_misfit(largest_hurst) > 0.0)
        throw InvalidArgument(fmt::format("no self-affine spectrum up to {:.4g} 1/m has rms height {:.4g} m, slope {:.4g} and curvature "
                                          "{:.4g} 1/m together; check units and short cutoff",
                                          short_wavevector, rms_height, rms_slope, rms_curvature));
    const double hurst = bracketed_root(curvature_misfit, least_hurst, largest_hurst);
    auto result = with_rolloff(hurst, rolloff_for(hurst));
    result.plateau = std::pow(rms_height / result.parameters().rms_height, 2);
    if (std::abs(result.parameters().rms_slope / rms_slope - 1.0) > 1e-9)
        throw InvalidArgument(fmt::format("rms height {:.4g} m and slope {:.4g} need a roll-off outside the band up to {:.4g} 1/m",
                                          rms_height, rms_slope, short_wavevector));
    return result;
}

}  // namespace setae::roughness
