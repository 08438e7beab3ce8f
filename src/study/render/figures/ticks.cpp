// SPDX-License-Identifier: GPL-3.0-or-later
#include "ticks.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "layout.hpp"
#include "markup.hpp"
#include "setae/figures/typesetting.hpp"

namespace setae::figures {
namespace {

LinearTicks ticks_at(const Range& range, double step) {
    LinearTicks ticks{.step = step};
    const double slack = 1e-9 * (range.to - range.from) / step;
    const double first = std::ceil(range.from / step - slack), last = std::floor(range.to / step + slack);
    for (int i = 0; i <= static_cast<int>(last - first); ++i) {
        const double multiple = first + i;
        ticks.places.push_back(multiple == 0.0 ? 0.0 : multiple * step);  // 0, not −0
        ticks.labels.push_back(number_text(ticks.places.back()));
        ticks.letters = std::max(ticks.letters, letters_in(ticks.labels.back()));
    }
    return ticks;
}

/// Least distance of two numbers [mm], and the least where that leaves fewer than three.
double space_mm(const LinearTicks& ticks, Direction direction, bool few) {
    if (direction == Direction::along_y) return few ? 2.9 : 5.0;
    const double width = letters_mm * static_cast<double>(ticks.letters);
    return few ? width + 1.2 : std::max(6.5, width + 2.5);
}

}  // namespace

LinearTicks linear_ticks(const Range& range, double length_mm, Direction direction) {
    constexpr std::size_t enough = 3;
    constexpr double max_numbers = 200.0;
    const double extent = range.to - range.from;
    LinearTicks closer;  // the largest step with enough numbers that do not overlap
    for (double decade = std::pow(10.0, std::floor(std::log10(extent / max_numbers)));; decade *= 10.0)
        for (const double digit : {1.0, 2.0, 5.0}) {
            if (extent / (digit * decade) > max_numbers) continue;
            auto ticks = ticks_at(range, digit * decade);
            const double distance = length_mm * ticks.step / extent * (1.0 + 1e-9);
            if (distance >= space_mm(ticks, direction, true) &&
                (ticks.places.size() >= enough || closer.places.empty()))
                closer = ticks;
            if (distance < space_mm(ticks, direction, false)) continue;
            return ticks.places.size() >= std::min(enough, closer.places.size()) ? ticks : closer;
        }
}

std::string logarithmic_tick_lines(const Range& range, double length_mm, char name) {
    constexpr double min_mm = 7.5;
    const double decades = std::log10(range.to / range.from);
    const int step = std::max(1, static_cast<int>(std::ceil(min_mm * decades / length_mm)));
    // within about a decade, only powers of ten would leave the axis bare
    const bool few = decades < 1.6;
    std::string ticks;
    const auto add = [&](int digit, int decade, bool named) {
        ticks +=
            fmt::format("{}{}{}e{}{}", ticks.empty() ? "" : ", ", named ? "" : "'' ", digit, decade, named ? "" : " 1");
    };
    for (int decade = static_cast<int>(std::floor(std::log10(range.from)));
         decade <= static_cast<int>(std::floor(std::log10(range.to))); ++decade) {
        add(1, decade, decade % step == 0);
        for (int digit = 2; digit <= 9 && step == 1; ++digit)
            add(digit, decade, few && (decades < 0.5 || digit == 2 || digit == 5));
    }
    const bool far = range.from < 1e-4 || range.to >= 1e6;
    return fmt::format("set logscale {0} 10\nset format {0} '{1}'\nset {0}tics ({2}) scale 0.6,0.3\n", name,
                       !few  ? "10^{%L}"
                       : far ? "%.0t·10^{%T}"
                             : "%g",
                       ticks);
}

std::string linear_tick_lines(const Range& range, double length_mm, char name) {
    const auto ticks = linear_ticks(range, length_mm, name == 'x' ? Direction::along_x : Direction::along_y);
    const auto lines = fmt::format("unset logscale {0}\nset m{0}tics 2\nset format {0} '%g'\n", name);
    const bool far = std::any_of(ticks.labels.begin(), ticks.labels.end(),
                                 [](const std::string& label) { return label.find("·") != std::string::npos; });
    if (!far) return lines + fmt::format("set {}tics {:.6g} scale 0.6,0.3\n", name, ticks.step);
    std::string named;
    for (std::size_t i = 0; i < ticks.places.size(); ++i)
        named += fmt::format("{}{} {:.6g}", i == 0 ? "" : ", ", quoted_tick(ticks.labels[i]), ticks.places[i]);
    return lines + fmt::format("set {}tics ({}) scale 0.6,0.3\n", name, named);
}

}  // namespace setae::figures
