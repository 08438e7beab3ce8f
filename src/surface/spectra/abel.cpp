// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/abel.hpp"

#include <cmath>

#include <fmt/format.h>

#include "abel_integral.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::spectra {
namespace {

void require_same_size(const ArrayView1D& wavevector, const ArrayView1D& spectrum) {
    if (wavevector.size() != spectrum.size())
        throw InvalidArgument(fmt::format("{} wavevectors for {} values of the spectrum; expected as many of both",
                                          wavevector.size(), spectrum.size()));
}

void require_curve(const ArrayView1D& nodes, const ArrayView1D& spectrum) {
    require_same_size(nodes, spectrum);
    if (nodes.size() < 2)
        throw InvalidArgument(fmt::format("a spectrum with {} nodes; expected at least 2", nodes.size()));
    for (Index i = 0; i < nodes.size(); ++i)
        if (!(nodes[i] > (i == 0 ? 0.0 : nodes[i - 1])) || !(spectrum[i] > 0.0) ||
            !std::isfinite(nodes[i] * spectrum[i]))
            throw InvalidArgument(
                fmt::format("node {} of a spectrum (q = {} 1/m, C = {}); expected increasing q > 0 and C > 0", i,
                            nodes[i], spectrum[i]));
}

}  // namespace

Array1D isotropic_from_profile_eq11(const ArrayView1D& wavevector, const ArrayView1D& C1D, double shortest_wavevector) {
    require_same_size(wavevector, C1D);
    if (!(shortest_wavevector > 0.0))
        throw InvalidArgument(fmt::format("short cutoff q_s = {} 1/m; expected positive", shortest_wavevector));
    Array1D result(wavevector.size());
    for (Index k = 0; k < wavevector.size(); ++k) {
        const double share = wavevector[k] / shortest_wavevector;
        result[k] = share < 1.0 ? pi * C1D[k] / (wavevector[k] * std::sqrt(1.0 - share * share)) : undefined;
    }
    return result;
}

Array1D profile_from_isotropic(const ArrayView1D& nodes, const ArrayView1D& C_iso, const ArrayView1D& wavevector) {
    require_curve(nodes, C_iso);
    const AbelIntegral integral(nodes, C_iso);
    return wavevector.unaryExpr([&](double q) { return integral(std::abs(q)); });
}

Array1D isotropic_from_profile(const ArrayView1D& wavevector, const ArrayView1D& C1D, double shortest_wavevector,
                               int rounds) {
    require_curve(wavevector, C1D);
    if (rounds < 0) throw InvalidArgument(fmt::format("{} rounds of correction; expected 0 or more", rounds));
    const Index n = wavevector.size();
    if (!(wavevector[n - 1] < shortest_wavevector))
        throw InvalidArgument(
            fmt::format("wavevectors up to {} 1/m, short cutoff q_s = {} 1/m; expected all wavevectors below q_s",
                        wavevector[n - 1], shortest_wavevector));
    Array1D nodes(n + 1), values(n + 1);
    nodes << wavevector, shortest_wavevector;
    values.head(n) = isotropic_from_profile_eq11(wavevector, C1D, shortest_wavevector);
    const auto continue_to_cutoff = [&] {
        const double slope = std::log(values[n - 1] / values[n - 2]) / std::log(nodes[n - 1] / nodes[n - 2]);
        values[n] = values[n - 1] * std::pow(nodes[n] / nodes[n - 1], slope);
    };
    continue_to_cutoff();
    for (int round = 0; round < rounds; ++round) {
        values.head(n) *= C1D / profile_from_isotropic(nodes, values, wavevector);
        continue_to_cutoff();
    }
    return values.head(n);
}

}  // namespace setae::spectra
