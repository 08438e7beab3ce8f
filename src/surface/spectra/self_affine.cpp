// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/self_affine.hpp"

#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "self_affine_model.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/bracketing.hpp"
#include "setae/spectra/abel.hpp"

namespace setae::spectra {
namespace {

constexpr double largest_exponent = 1.5;

void check(const SelfAffine& model) {
    const bool inside = model.plateau > 0.0 && model.rolloff_wavevector > 0.0 && model.hurst_exponent > 0.0 &&
                        model.hurst_exponent < largest_exponent && model.short_wavevector > model.rolloff_wavevector &&
                        std::isfinite(model.short_wavevector) && std::isfinite(model.plateau);
    if (!inside)
        throw InvalidArgument(fmt::format(
            "self-affine model with C_0 = {} m4, q_r = {} 1/m, H = {}, q_s = {} 1/m; expected C_0 > 0, "
            "0 < q_r < q_s, 0 < H < {}",
            model.plateau, model.rolloff_wavevector, model.hurst_exponent, model.short_wavevector, largest_exponent));
}

/// moment/(C_0 q_r^(n+2)) with ratio = q_s/q_r: 1/(n+2) + (ratio^e − 1)/e, e = n − 2H.
double reduced_moment(double order, double hurst_exponent, double ratio) {
    const double exponent = order - 2.0 * hurst_exponent, span = std::log(ratio);
    const double fall = std::abs(exponent * span) < 1e-12 ? span : std::expm1(exponent * span) / exponent;
    return 1.0 / (order + 2.0) + fall;
}

}  // namespace

Array1D isotropic_power_spectrum(const SelfAffine& model, const ArrayView1D& wavevector) {
    check(model);
    return wavevector.unaryExpr([&](double q) { return isotropic_value(model, q); });
}

Array1D profile_power_spectrum(const SelfAffine& model, const ArrayView1D& wavevector) {
    check(model);
    const Array1D nodes{{model.rolloff_wavevector, model.short_wavevector}};
    return profile_from_isotropic(nodes, isotropic_power_spectrum(model, nodes), wavevector);
}

double moment(const SelfAffine& model, double order) {
    check(model);
    if (!(order > -2.0))
        throw InvalidArgument(fmt::format("moment of order {} of a spectrum with a plateau; expected above -2", order));
    return model.plateau * std::pow(model.rolloff_wavevector, order + 2.0) *
           reduced_moment(order, model.hurst_exponent, model.short_wavevector / model.rolloff_wavevector);
}

double rms_height(const SelfAffine& model) { return std::sqrt(moment(model, 0.0) / (2.0 * pi)); }
double rms_slope(const SelfAffine& model) { return std::sqrt(moment(model, 2.0) / (2.0 * pi)); }
double rms_curvature(const SelfAffine& model) { return std::sqrt(moment(model, 4.0) / (8.0 * pi)); }

SelfAffine self_affine_with_moments(double rms_height, double rms_slope, double rms_curvature,
                                    double short_wavevector) {
    if (!(rms_height > 0.0 && rms_slope > 0.0 && rms_curvature > 0.0 && short_wavevector > 0.0))
        throw InvalidArgument(
            fmt::format("self-affine spectrum with h_rms = {} m, slope {}, curvature {} 1/m up to {} 1/m; expected all "
                        "positive",
                        rms_height, rms_slope, rms_curvature, short_wavevector));
    // two ratios free of C_0: curvature/slope gives H for any q_r, height/slope then q_r
    const double curvature_ratio = 2.0 * std::log(2.0 * rms_curvature / (rms_slope * short_wavevector));
    const double height_ratio = 2.0 * std::log(rms_height * short_wavevector / rms_slope);
    const auto curvature_excess = [&](double hurst, double ratio) {
        return std::log(reduced_moment(4.0, hurst, ratio) / reduced_moment(2.0, hurst, ratio) / (ratio * ratio)) -
               curvature_ratio;
    };
    const auto hurst_at = [&](double ratio) {
        constexpr double lowest = 1e-9, highest = largest_exponent - 1e-9;
        if (curvature_excess(lowest, ratio) <= 0.0) return lowest;
        if (curvature_excess(highest, ratio) >= 0.0) return highest;
        return numerics::bracketed_root([&](double hurst) { return curvature_excess(hurst, ratio); }, lowest, highest,
                                        50);
    };
    const auto height_excess = [&](double log_ratio) {
        const double ratio = std::exp(log_ratio), hurst = hurst_at(ratio);
        return std::log(reduced_moment(0.0, hurst, ratio) / reduced_moment(2.0, hurst, ratio) * ratio * ratio) -
               height_ratio;
    };
    const double narrowest = std::log(1.1), widest = std::log(1e9);
    const bool bracketed = height_excess(narrowest) * height_excess(widest) <= 0.0;
    const double log_ratio = bracketed ? numerics::bracketed_root(height_excess, narrowest, widest, 50) : narrowest;
    const double hurst = hurst_at(std::exp(log_ratio));
    if (!bracketed || std::abs(curvature_excess(hurst, std::exp(log_ratio))) > 1e-9)
        throw InvalidArgument(
            fmt::format("no self-affine spectrum up to {} 1/m has h_rms = {} m, slope {} and curvature {} 1/m",
                        short_wavevector, rms_height, rms_slope, rms_curvature));
    SelfAffine model;
    model.short_wavevector = short_wavevector;
    model.rolloff_wavevector = short_wavevector * std::exp(-log_ratio);
    model.hurst_exponent = hurst;
    model.plateau = 1.0;
    model.plateau = 2.0 * pi * rms_height * rms_height / moment(model, 0.0);
    return model;
}

}  // namespace setae::spectra
