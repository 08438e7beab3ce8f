// SPDX-License-Identifier: GPL-3.0-or-later
#include "force_jumps.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "baseline.hpp"
#include "local_lines.hpp"

namespace setae::loops {
namespace {

constexpr double clear = 6.0;
constexpr double sigma_over_median = 1.4826;

/// Whether the force is flat on the side of free flight, within the error of its slope.
bool is_flat(const LocalLines& lines, Index left, Index right, double scatter, const JumpSearch& search) {
    if (search.free_side == FreeSide::neither) return true;
    const Index free = search.free_side == FreeSide::before ? left : right;
    constexpr double deviations = 3.0;
    return std::abs(lines.slope(free)) < search.flat + deviations * scatter / std::sqrt(lines.spread(free));
}

/// Jumps over one gap between windows of one width.
void add_jumps(const Array1D& clock, const LocalLines& lines, Index gap, const JumpSearch& search,
               std::vector<ForceJump>& found) {
    const Index width = lines.width(), first = std::max(search.samples.first, width - 1);
    const Index last = std::min(search.samples.last, clock.size() - width - 1 - gap), n = last - first + 1;
    constexpr Index fewest = 8;  // number of differences for a typical value
    if (n < fewest) return;
    Array1D sizes(n), errors(n);
    std::vector<bool> flat(static_cast<std::size_t>(n));
    for (Index k = 0; k < n; ++k) {
        const Index i = first + k, left = i - width + 1, right = i + 1 + gap;
        const double middle = 0.5 * (clock[i] + clock[right]);
        const double scatter =
            std::max(search.noise, std::hypot(lines.scatter(left), lines.scatter(right)) / std::sqrt(2.0));
        sizes[k] = lines.at(right, middle) - lines.at(left, middle);
        errors[k] = scatter * std::sqrt(lines.variance(left, middle) + lines.variance(right, middle));
        flat[static_cast<std::size_t>(k)] = is_flat(lines, left, right, scatter, search);
    }
    const double usual = sigma_over_median * median_of((sizes - median_of(sizes)).abs());
    for (Index k = 0; k < n; ++k) {
        const double significance = std::abs(sizes[k]) / std::max(errors[k], usual);
        if (flat[static_cast<std::size_t>(k)] && significance > clear && search.sign * sizes[k] >= 0.0)
            found.push_back({first + k, first + k + 1 + gap, sizes[k], significance});
    }
}

}  // namespace

std::vector<ForceJump> force_jumps(const Array1D& clock, const Array1D& force, const JumpSearch& search) {
    std::vector<ForceJump> found;
    constexpr Index narrowest = 4;
    std::vector<Index> widths{narrowest, std::max(narrowest, search.half_width / 2),
                              std::max(narrowest, search.half_width)};
    widths.erase(std::unique(widths.begin(), widths.end()), widths.end());
    for (const Index width : widths) {
        if (clock.size() < 2 * width) continue;
        const LocalLines lines(clock, force, width);
        for (const Index gap : std::array<Index, 4>{0, 1, 3, 7})
            if (gap <= width) add_jumps(clock, lines, gap, search, found);
    }
    return found;
}

double clarity(const ForceJump& jump) {
    constexpr double by_sample = 0.04;
    return std::abs(jump.size) * (1.0 - by_sample * static_cast<double>(jump.next - jump.last - 1)) *
           (1.0 - 2.0 / jump.significance);
}

}  // namespace setae::loops
