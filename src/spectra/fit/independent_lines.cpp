// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectral_fit/independent_lines.hpp"

#include <algorithm>
#include <cmath>

#include "setae/core/constants.hpp"

namespace setae::spectral_fit {

Array1D independent_lines(const spectra::SpectralDensity& C_iso, const ArrayView1D& wavevectors,
                          const ArrayView1D& signal, Index lines, double pitch) {
    constexpr Index nodes = 160, lags = 40;
    constexpr double end = 6.0;  // p = q sinh t up to 200 q
    // lags: each by itself at first, then logarithmically, each standing for the lags around it
    Array1D lag(lags + 1);
    for (Index l = 0; l <= lags; ++l)
        lag[l] = std::expm1(std::log1p(static_cast<double>(lines - 1)) * static_cast<double>(l) / lags);
    Array1D result(wavevectors.size());
    for (Index k = 0; k < wavevectors.size(); ++k) {
        const double q = wavevectors[k];
        Array1D p(nodes), weight(nodes);
        for (Index i = 0; i < nodes; ++i) {
            const double t = end * (static_cast<double>(i) + 0.5) / nodes;
            p[i] = q * std::sinh(t);
            weight[i] = C_iso(q * std::cosh(t)) * std::cosh(t);
        }
        const double total = weight.sum();
        const auto squared = [&](double distance) {
            const double rho = signal[k] * (weight * (p * (distance * pitch)).cos()).sum() / total;
            return rho * rho;
        };
        // Σ_ij ρ² = N + 2 Σ_l (N − l) ρ²(l), the sum over l by the trapezoidal rule between the chosen lags
        double sum = static_cast<double>(lines), before = 0.0, value_before = 0.0;
        for (Index l = 0; l <= lags && total > 0.0; ++l) {
            const double value = (static_cast<double>(lines) - lag[l]) * squared(lag[l]);
            if (l > 0) sum += (value + value_before) * (lag[l] - before);
            before = lag[l];
            value_before = value;
        }
        sum -= static_cast<double>(lines) *
               (total > 0.0 ? signal[k] * signal[k] : 0.0);  // half of the lag 0 the rule counted, both signs
        result[k] = std::clamp(static_cast<double>(lines) * static_cast<double>(lines) / std::max(sum, 1.0), 1.0,
                               static_cast<double>(lines));
    }
    return result;
}

}  // namespace setae::spectral_fit
