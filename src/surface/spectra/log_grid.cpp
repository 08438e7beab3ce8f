// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/log_grid.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::spectra {

double LogGrid::edge(Index bin) const { return std::pow(10.0, static_cast<double>(bin) / bins_per_decade); }

double LogGrid::centre(Index bin) const { return std::pow(10.0, (static_cast<double>(bin) + 0.5) / bins_per_decade); }

Index LogGrid::bin_of(double wavevector) const {
    if (!(wavevector > 0.0) || !std::isfinite(wavevector))
        throw InvalidArgument(
            fmt::format("wavevector {} 1/m on a logarithmic grid; expected positive and finite", wavevector));
    constexpr double rounding = 1e-12, near_an_edge = 1e-6;
    const double place = std::log10(wavevector) * bins_per_decade, below = std::floor(place);
    const auto bin = static_cast<Index>(below);
    if (std::min(place - below, below + 1.0 - place) > near_an_edge) return bin;
    // log10 may have a rounding error in either direction: the edges decide
    if (wavevector < edge(bin) * (1.0 - rounding)) return bin - 1;
    if (wavevector >= edge(bin + 1) * (1.0 - rounding)) return bin + 1;
    return bin;
}

}  // namespace setae::spectra
