// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/model_spectra.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::spectra {

SpectralDensity density(const SoftCutoff& model) {
    SelfAffine endless{model.plateau, model.rolloff_wavevector, model.hurst_exponent, model.short_wavevector};
    (void)density(endless);  // the same domain
    // beyond 27 q_s the factor exp(−(q/q_s)²) is zero in double precision
    endless.short_wavevector = 27.5 * model.short_wavevector;
    return [power_law = density(endless), cutoff = model.short_wavevector](double q) {
        return power_law(q) * std::exp(-(q / cutoff) * (q / cutoff));
    };
}

SpectralDensity density(const TwoSlopes& model) {
    const auto longer =
        density(SelfAffine{model.plateau, model.rolloff_wavevector, model.hurst_exponent, model.crossover_wavevector});
    const double level = longer(model.crossover_wavevector);
    const auto shorter =
        density(SelfAffine{level, model.crossover_wavevector, model.short_hurst_exponent, model.short_wavevector});
    return [longer, shorter, crossover = model.crossover_wavevector](double q) {
        return q < crossover ? longer(q) : shorter(q);
    };
}

SpectralDensity density(const Bump& model) {
    if (!(model.excess > -1.0 && model.wavevector > 0.0 && model.width > 0.0) ||
        !std::isfinite(model.excess * model.wavevector * model.width))
        throw InvalidArgument(fmt::format(
            "a bump {} times the spectrum at {} 1/m, {} wide in ln q; expected a height above -1, a positive "
            "wavevector and a positive width",
            model.excess, model.wavevector, model.width));
    return [base = density(model.base), model](double q) {
        if (!(q > 0.0)) return base(q);
        const double distance = std::log(q / model.wavevector) / model.width;
        return base(q) * (1.0 + model.excess * std::exp(-0.5 * distance * distance));
    };
}

}  // namespace setae::spectra
