// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_coherence.hpp"

#include <algorithm>
#include <cmath>

#include "setae/spectra/mode_groups.hpp"

namespace setae::spectra {
namespace {

/// Modes with computed coherence: the middle one of each group of similar wavevectors.
std::vector<Index> evaluated_modes(Index count) {
    constexpr Index by_themselves = 128;
    constexpr double ratio = 1.1547819846894583;  // 10^(1/16)
    const auto first = narrow_groups(Array1D::LinSpaced(count, 1.0, static_cast<double>(count)), ratio, by_themselves);
    std::vector<Index> modes;
    for (std::size_t g = 0; g + 1 < first.size(); ++g) modes.push_back(1 + (first[g] + first[g + 1] - 1) / 2);
    return modes;
}

/// Values at modes 1 … count, linear between the known ones and constant beyond them.
Array1D between(const std::vector<Index>& modes, const Array1D& values, Index count) {
    Array1D result(count);
    std::size_t next = 0;
    for (Index k = 1; k <= count; ++k) {
        while (next < modes.size() && modes[next] < k) ++next;
        const auto at = static_cast<Index>(next);
        if (next == modes.size()) result[k - 1] = values[at - 1];
        else if (next == 0 || modes[next] == k) result[k - 1] = values[at];
        else {
            const double t =
                static_cast<double>(k - modes[next - 1]) / static_cast<double>(modes[next] - modes[next - 1]);
            result[k - 1] = (1.0 - t) * values[at - 1] + t * values[at];
        }
    }
    return result;
}

}  // namespace

LineCoherence::LineCoherence(Index points, Index lines)
    : points_(points), lines_(lines), modes_(evaluated_modes(points / 2)), stride_(lines + lines % 2) {
    values_.resize(modes_.size() * static_cast<std::size_t>(stride_));
}

void LineCoherence::take(Index line, const fourier::Complex* modes) {
    for (std::size_t m = 0; m < modes_.size(); ++m)
        values_[m * static_cast<std::size_t>(stride_) + static_cast<std::size_t>(line)] = modes[modes_[m]];
}

Array1D LineCoherence::independent_lines(parallel::Threads threads) {
    const auto number = static_cast<double>(lines_);
    const fourier::ComplexTransform transform(lines_);
    Array1D found(static_cast<Index>(modes_.size()));
    parallel::for_each_index(modes_.size(), threads, [&](std::size_t m) {
        auto* values = values_.data() + m * static_cast<std::size_t>(stride_);
        transform.apply(values);
        double sum = 0.0, squares = 0.0;
        for (Index j = 0; j < lines_; ++j) {
            const double power = std::norm(values[j]);
            sum += power;
            squares += power * power;
        }
        const double variance = (2 * modes_[m] == points_ ? 1.0 : 0.5) * squares;
        found[static_cast<Index>(m)] =
            variance > 0.0 ? std::clamp((sum * sum - 2.0 * variance) / variance, 1.0, number) : number;
    });
    return between(modes_, found, points_ / 2);
}

}  // namespace setae::spectra
