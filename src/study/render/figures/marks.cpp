// SPDX-License-Identifier: GPL-3.0-or-later
#include "marks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "markup.hpp"
#include "setae/core/constants.hpp"

namespace setae::figures {
namespace {

struct Symbol {
    int filled, hollow;
    double size;  ///< for equal appearance: gnuplot's shapes differ in area
};
constexpr std::array<Symbol, 6> symbols{
    {{7, 6, 1.0}, {5, 4, 0.9}, {9, 8, 1.15}, {13, 12, 1.2}, {11, 10, 1.15}, {15, 14, 1.1}}};
constexpr std::array<const char*, 6> dashes{"solid", "(9,5)", "(2,4)", "(10,4,2,4)", "(16,5)", "(10,4,2,4,2,4)"};

template <std::size_t size, class Value>
const Value& chosen(const std::array<Value, size>& choices, int index) {
    const int n = static_cast<int>(size);
    return choices[static_cast<std::size_t>(((index % n) + n) % n)];
}

int colour_of(const Series& series, std::size_t place) {
    return series.colour >= 0 ? series.colour : static_cast<int>(place) % general_colours;
}

/// A series' place in the palette, and its symbol and dash.
struct Style {
    std::string colour;
    Symbol symbol;
    const char* dash;
};

Style style_of(const Series& series, std::size_t place) {
    const int colour = colour_of(series, place);
    const int symbol = series.symbol >= 0 ? series.symbol : colour;
    // symbols distinguish lines that have them
    const int dash = series.dash >= 0 ? series.dash : series.mark == Mark::both ? 0 : symbol;
    return {"lc rgb " + colour_name(colour, series.opacity), chosen(symbols, symbol), chosen(dashes, dash)};
}

}  // namespace

std::string colour_name(int index, double opacity) {
    const auto* colour = chosen(palette, index);
    if (opacity >= 1.0) return fmt::format("'#{}'", colour);
    return fmt::format("'#{:02X}{}'", static_cast<int>(std::lround(255.0 * (1.0 - std::max(opacity, 0.0)))), colour);
}

std::string data_lines(const Panel& panel, const Series& series, const Range& x, const Range& y) {
    const auto at = [](const Array1D& values, Index i, double otherwise) {
        return values.size() > 0 ? values[i] : otherwise;
    };
    const auto on = [](const Axis& axis, double value, double otherwise) {
        return shows(axis, value) ? value : otherwise;
    };
    std::string lines;
    bool interrupted = true;  // nothing before the first
    for (Index i = 0; i < series.x.size(); ++i) {
        const double lower = at(series.lower, i, undefined), upper = at(series.upper, i, undefined);
        const bool band = series.mark == Mark::band;
        const double middle = series.y.size() > 0 ? series.y[i] : upper;
        if (!shows(panel.x, series.x[i]) || !shows(panel.y, middle) ||
            (band && !(std::isfinite(lower) && shows(panel.y, upper)))) {
            if (!interrupted) lines += "\n";
            interrupted = true;
            continue;
        }
        interrupted = false;
        // an end outside a logarithmic axis is below it; an undefined one at the point
        const double bottom = std::isnan(lower) ? middle : on(panel.y, lower, y.from);
        const double left = at(series.left, i, undefined);
        fmt::format_to(std::back_inserter(lines), "{} {} {} {} {} {}\n", series.x[i], middle, bottom,
                       on(panel.y, upper, middle), std::isnan(left) ? series.x[i] : on(panel.x, left, x.from),
                       on(panel.x, at(series.right, i, series.x[i]), series.x[i]));
    }
    return lines;
}

std::vector<std::string> elements(const Series& series, std::size_t place, const std::string& data,
                                  const SymbolSize& symbol_size) {
    const auto style = style_of(series, place);
    std::vector<std::string> result;
    const bool named = series.in_legend && !series.label.empty();
    const auto title = named ? "title " + quoted_verbatim(series.label) : std::string("notitle");
    const auto line = fmt::format("{} lw {} dt {}", style.colour, series.line_width, style.dash);
    const auto& symbol = style.symbol;
    constexpr int diamond = 13;
    const double size = symbol_size.symbols * symbol.size * (symbol.filled == diamond ? symbol_size.diamonds : 1.0);
    const auto hollow = fmt::format("pt {} ps {:.2f} {} lw 1", symbol.hollow, size, style.colour);
    const auto filled = fmt::format("pt {} ps {:.2f} {}", symbol.filled, size, line);
    const auto filling = fmt::format("fs transparent solid {} noborder lc rgb {}", 0.25 * series.opacity,
                                     colour_name(colour_of(series, place)));
    if (series.legend_only) {
        const auto symbols_with = [&](const char* how) {
            return fmt::format("keyentry with {} {} {}", how, series.hollow ? hollow : filled, title);
        };
        if (series.mark == Mark::points) return {symbols_with("points")};
        if (series.mark == Mark::both) return {symbols_with("linespoints")};
        if (series.mark == Mark::line) return {fmt::format("keyentry with lines {} {}", line, title)};
        return {fmt::format("keyentry with boxes {} {}", filling, title)};
    }
    if (series.mark == Mark::area)
        return {fmt::format("{} using 1:2 with filledcurves closed {} {}", data, filling, title)};
    if (series.mark == Mark::band) {
        const bool middle = series.y.size() > 0;
        result.push_back(
            fmt::format("{} using 1:3:4 with filledcurves {} {}", data, filling, middle ? "notitle" : title));
        if (middle) result.push_back(fmt::format("{} using 1:2 with lines {} {}", data, line, title));
        return result;
    }
    const bool upright = series.lower.size() > 0, across = series.left.size() > 0;
    // gnuplot's own error bars leave a white ring around each point
    if (upright)
        result.push_back(
            fmt::format("{} using 1:3:(0):($4-$3) with vectors nohead lw 0.9 {} notitle", data, style.colour));
    if (across)
        result.push_back(
            fmt::format("{} using 5:2:($6-$5):(0) with vectors nohead lw 0.9 {} notitle", data, style.colour));
    if (series.mark == Mark::line) {
        result.push_back(fmt::format("{} using 1:2 with lines {} {}", data, line, title));
        return result;
    }
    if (!series.hollow) {
        result.push_back(fmt::format("{} using 1:2 with {} {} {}", data,
                                     series.mark == Mark::both ? "linespoints" : "points", filled, title));
        return result;
    }
    if (series.mark == Mark::both) result.push_back(fmt::format("{} using 1:2 with lines {} notitle", data, line));
    // the paper's white inside, so that neither line nor bar runs through
    if (series.mark == Mark::both || upright || across)
        result.push_back(
            fmt::format("{} using 1:2 with points pt {} ps {:.2f} lc rgb 'white' notitle", data, symbol.filled, size));
    const bool joined = series.mark == Mark::both && named;
    result.push_back(fmt::format("{} using 1:2 with points {} {}", data, hollow, joined ? "notitle" : title));
    if (joined) result.push_back(fmt::format("keyentry with linespoints {} {}", hollow, title));
    return result;
}

std::string map_lines(const HeatMap& map) {
    const double dx = map.width / static_cast<double>(map.values.rows()),
                 dy = map.height / static_cast<double>(map.values.cols());
    std::string lines;
    for (Index i = 0; i < map.values.rows(); ++i)
        for (Index j = 0; j < map.values.cols(); ++j)
            fmt::format_to(std::back_inserter(lines), "{:.6g} {:.6g} {:.6g}\n", (static_cast<double>(i) + 0.5) * dx,
                           (static_cast<double>(j) + 0.5) * dy, map.values(i, j));
    return lines;
}

}  // namespace setae::figures
