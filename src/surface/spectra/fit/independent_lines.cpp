// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectral_fit/independent_lines.hpp"

#include <algorithm>
#include <cmath>

namespace setae::spectral_fit {

Array1D independent_lines(const spectra::SpectralDensity& C_iso, const ArrayView1D& wavevectors,
                          const ArrayView1D& signal, Index lines, double pitch, parallel::Threads threads) {
    constexpr Index nodes = 160, lags = 40;
    constexpr double end = 6.0;  // p = q sinh t up to 200 q
    // lags: single ones at first, then logarithmic, each representing the lags around it
    Array1D lag(lags + 1);
    for (Index l = 0; l <= lags; ++l)
        lag[l] = std::expm1(std::log1p(static_cast<double>(lines - 1)) * static_cast<double>(l) / lags);
    Array1D sinh(nodes), cosh(nodes);
    for (Index i = 0; i < nodes; ++i) {
        const double t = end * (static_cast<double>(i) + 0.5) / nodes;
        sinh[i] = std::sinh(t);
        cosh[i] = std::cosh(t);
    }
    Array1D result(wavevectors.size());
    parallel::for_each_index(static_cast<std::size_t>(wavevectors.size()), threads, [&](std::size_t index) {
        const auto k = static_cast<Index>(index);
        const Array1D p = wavevectors[k] * sinh;
        const Array1D weight = cosh * (wavevectors[k] * cosh).unaryExpr(C_iso);
        const double total = weight.sum();
        Index reached = nodes;  // most are beyond the end of the spectrum
        while (reached > 0 && weight[reached - 1] == 0.0) --reached;
        const auto squared = [&](double distance) {
            const double rho =
                signal[k] * (weight.head(reached) * (p.head(reached) * (distance * pitch)).cos()).sum() / total;
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
               (total > 0.0 ? signal[k] * signal[k] : 0.0);  // subtracts half of the lag 0 counted by the rule, both
                                                             // signs
        result[k] = std::clamp(static_cast<double>(lines) * static_cast<double>(lines) / std::max(sum, 1.0), 1.0,
                               static_cast<double>(lines));
    });
    return result;
}

}  // namespace setae::spectral_fit
