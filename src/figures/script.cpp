// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "markup.hpp"
#include "ranges.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::figures {
namespace {

constexpr double millimetres_an_inch = 25.4, letters_mm = 1.45;  // mean width of a letter of small text
constexpr double text_points = 8.0, small_points = 7.0;

/// Okabe and Ito's, the pale ones last.
constexpr std::array<const char*, 8> palette{"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#000000", "#E69F00", "#56B4E9", "#F0E442"};

struct Symbol {
    int filled, hollow;
    double size;  ///< for the same look: gnuplot's shapes differ in area
};
constexpr std::array<Symbol, 6> symbols{{{7, 6, 1.0}, {5, 4, 0.9}, {9, 8, 1.15}, {13, 12, 1.2}, {11, 10, 1.15}, {15, 14, 1.1}}};
constexpr std::array<const char*, 6> dashes{"solid", "(9,5)", "(2,4)", "(10,4,2,4)", "(16,5)", "(10,4,2,4,2,4)"};

template <std::size_t size, class Value>
const Value& chosen(const std::array<Value, size>& choices, int index) {
    const int n = static_cast<int>(size);
    return choices[static_cast<std::size_t>(((index % n) + n) % n)];
}

/// A series' place in the palette, and its symbol and dash.
struct Style {
    std::string colour;
    Symbol symbol;
    const char* dash;
};

Style style_of(const Series& series, std::size_t place) {
    const int colour = series.colour >= 0 ? series.colour : static_cast<int>(place);
    const int symbol = series.symbol >= 0 ? series.symbol : colour;
    return {fmt::format("lc rgb '{}'", chosen(palette, colour)), chosen(symbols, symbol), chosen(dashes, symbol)};
}

/// A terminal, and what makes its text and symbols as large as the others'.
struct Terminal {
    std::string definition;
    double point = 1.0;   ///< a point (1/72 inch) in its unit of text
    double symbol = 1.0;  ///< factor on the size of symbols
};

Terminal terminal(const Figure& figure, const std::string& ending) {
    constexpr const char* font = "Liberation Sans";
    const double width = figure.width_mm / millimetres_an_inch, height = figure.height_mm / millimetres_an_inch;
    if (ending == "svg")  // 96 pixels an inch
        return {fmt::format("svg size {:.0f},{:.0f} fixed enhanced font '{},{:.2f}' linewidth 1.1 name 'figure'", 96.0 * width, 96.0 * height, font,
                            text_points * 4.0 / 3.0), 4.0 / 3.0, 0.95};
    if (ending == "pdf")  // takes 96 points for an inch
        return {fmt::format("pdfcairo size {:.4f}in,{:.4f}in enhanced font '{},{}' fontscale 0.75 linewidth 1.6", width, height, font, text_points), 1.0, 0.85};
    if (ending == "png")
        return {fmt::format("pngcairo size {:.0f},{:.0f} enhanced font '{},{}' fontscale 3.125 linewidth 3.2", 300.0 * width, 300.0 * height, font, text_points),
                1.0, 3.1};
    throw InvalidArgument(fmt::format("a figure cannot be drawn as '{}'; expected svg, pdf or png", ending));
}

/// The points of a series, one a line: x y lower upper left right. An empty line where the curve is interrupted.
std::string data_lines(const Panel& panel, const Series& series, const Range& x, const Range& y) {
    const auto at = [](const Array1D& values, Index i, double otherwise) { return values.size() > 0 ? values[i] : otherwise; };
    const auto on = [](const Axis& axis, double value, double otherwise) { return shows(axis, value) ? value : otherwise; };
    std::string lines;
    bool interrupted = true;  // nothing before the first
    for (Index i = 0; i < series.x.size(); ++i) {
        const double lower = at(series.lower, i, undefined), upper = at(series.upper, i, undefined);
        const bool band = series.mark == Mark::band;
        const double middle = series.y.size() > 0 ? series.y[i] : upper;
        if (!shows(panel.x, series.x[i]) || !shows(panel.y, middle) || (band && !(std::isfinite(lower) && shows(panel.y, upper)))) {
            if (!interrupted) lines += "\n";
            interrupted = true;
            continue;
        }
        interrupted = false;
        // an end a logarithmic axis cannot show lies below it; an undefined one at the point
        const double bottom = std::isnan(lower) ? middle : on(panel.y, lower, y.from);
        const double left = at(series.left, i, undefined);
        fmt::format_to(std::back_inserter(lines), "{} {} {} {} {} {}\n", series.x[i], middle, bottom, on(panel.y, upper, middle),
                       std::isnan(left) ? series.x[i] : on(panel.x, left, x.from), on(panel.x, at(series.right, i, series.x[i]), series.x[i]));
    }
    return lines;
}

/// What draws a series: elements of a plot command.
std::vector<std::string> elements(const Series& series, const Style& style, const std::string& data, double symbol_size) {
    std::vector<std::string> result;
    const auto title = series.label.empty() ? std::string("notitle") : "title " + quoted_verbatim(series.label);
    // symbols tell lines apart that have them
    const auto line = fmt::format("{} lw 1.3 dt {}", style.colour, series.mark == Mark::both ? "solid" : style.dash);
    if (series.mark == Mark::band) {
        const bool middle = series.y.size() > 0;
        result.push_back(fmt::format("{} using 1:3:4 with filledcurves fs transparent solid 0.25 noborder {} {}", data, style.colour, middle ? "notitle" : title));
        if (middle) result.push_back(fmt::format("{} using 1:2 with lines {} {}", data, line, title));
        return result;
    }
    const bool upright = series.lower.size() > 0, across = series.left.size() > 0;
    // gnuplot's own error bars leave a white ring around each point
    if (upright) result.push_back(fmt::format("{} using 1:3:(0):($4-$3) with vectors nohead lw 0.9 {} notitle", data, style.colour));
    if (across) result.push_back(fmt::format("{} using 5:2:($6-$5):(0) with vectors nohead lw 0.9 {} notitle", data, style.colour));
    if (series.mark == Mark::line) {
        result.push_back(fmt::format("{} using 1:2 with lines {} {}", data, line, title));
        return result;
    }
    const auto& symbol = style.symbol;
    const double size = symbol_size * symbol.size;
    if (!series.hollow) {
        result.push_back(fmt::format("{} using 1:2 with {} pt {} ps {:.2f} {} {}", data, series.mark == Mark::both ? "linespoints" : "points", symbol.filled,
                                     size, line, title));
        return result;
    }
    if (series.mark == Mark::both) result.push_back(fmt::format("{} using 1:2 with lines {} notitle", data, line));
    // the paper's white inside, so that neither line nor bar runs through
    if (series.mark == Mark::both || upright || across)
        result.push_back(fmt::format("{} using 1:2 with points pt {} ps {:.2f} lc rgb 'white' notitle", data, symbol.filled, size));
    const auto look = fmt::format("pt {} ps {:.2f} {} lw 1", symbol.hollow, size, style.colour);
    const bool joined = series.mark == Mark::both && !series.label.empty();
    result.push_back(fmt::format("{} using 1:2 with points {} {}", data, look, joined ? "notitle" : title));
    if (joined) result.push_back(fmt::format("keyentry with linespoints {} {}", look, title));
    return result;
}

/// Ticks of a logarithmic axis: every power of ten where there is room to name it, else every few; 2 … 9 between where
/// there is room, named within little more than a decade, where powers of ten alone would leave the axis bare.
std::string logarithmic_ticks(const Range& range, double length_mm, char name) {
    constexpr double room_mm = 7.5;
    const double decades = std::log10(range.to / range.from);
    const int step = std::max(1, static_cast<int>(std::ceil(room_mm * decades / length_mm)));
    const bool few = decades < 1.6;
    std::string ticks;
    const auto add = [&](int digit, int decade, bool named) {
        ticks += fmt::format("{}{}{}e{}{}", ticks.empty() ? "" : ", ", named ? "" : "'' ", digit, decade, named ? "" : " 1");
    };
    for (int decade = static_cast<int>(std::floor(std::log10(range.from))); decade <= static_cast<int>(std::floor(std::log10(range.to))); ++decade) {
        add(1, decade, decade % step == 0);
        for (int digit = 2; digit <= 9 && step == 1; ++digit) add(digit, decade, few && (decades < 0.5 || digit == 2 || digit == 5));
    }
    return fmt::format("set logscale {0} 10\nset format {0} '{1}'\nset {0}tics ({2}) scale 0.6,0.3\n", name, few ? "%g" : "10^{%L}", ticks);
}

std::string axis_lines(const Axis& axis, const Range& range, double length_mm, char name) {
    const auto lines = fmt::format("set {}range [{}:{}]\n", name, range.from, range.to);
    const bool logarithmic = axis.logarithmic && axis.tick_labels.empty();
    if (logarithmic) return lines + logarithmic_ticks(range, length_mm, name);
    if (axis.tick_labels.empty()) return lines + fmt::format("unset logscale {0}\nset {0}tics autofreq scale 0.6,0.3\nset m{0}tics 2\nset format {0} '%g'\n", name);
    std::string ticks;
    for (std::size_t i = 0; i < axis.tick_labels.size(); ++i) ticks += fmt::format("{}{} {}", i == 0 ? "" : ", ", quoted_tick(axis.tick_labels[i]), i);
    return lines + fmt::format("unset logscale {0}\nset {0}tics ({1}) scale 0.6,0.3\nunset m{0}tics\n", name, ticks);
}

std::string key_line(const Panel& panel, const Range& x, const Range& y, double width_mm, double height_mm, const std::string& font_size) {
    std::size_t entries = 0, longest = 0;
    for (const auto& series : panel.series) {
        if (series.label.empty() || series.x.size() == 0) continue;
        ++entries;
        longest = std::max(longest, static_cast<std::size_t>(std::count_if(series.label.begin(), series.label.end(), [](char c) { return (c & 0xc0) != 0x80; })));
    }
    if (!panel.legend || entries == 0) return "unset key\n";
    const double width = (11.0 + letters_mm * static_cast<double>(longest)) / width_mm, height = (1.5 + 3.4 * static_cast<double>(entries)) / height_mm;
    const auto corner = panel.legend_corner.value_or(emptiest_corner(panel, x, y, std::min(width, 1.0), std::min(height, 1.0)));
    constexpr std::array<const char*, 4> names{"top right", "top left", "bottom right", "bottom left"};
    return fmt::format("set key inside {} vertical Left reverse noopaque nobox samplen 2.2 spacing 1.05 font ',{}' maxrows {}\n",
                       names[static_cast<std::size_t>(corner)], font_size, entries);
}

/// Letters of the numbers at a linear axis, as its ticks will lie: a step of 1, 2 or 5 times a power of ten.
int letters_of_ticks(const Range& range) {
    const double step = std::floor(std::log10((range.to - range.from) / 6.0)), most = std::max(std::abs(range.from), std::abs(range.to));
    const int before = most >= 1.0 ? 1 + static_cast<int>(std::log10(most)) : 1, after = step < 0.0 ? 1 - static_cast<int>(step) : 0;
    return std::min(before + after + (range.from < 0.0 ? 1 : 0), 8);
}

/// Margins of a panel's axes against its cell [mm].
struct Margins {
    double left = 0.0, right = 2.5, top = 2.5, bottom = 9.5;
};

Margins margins_of(const Panel& panel) {
    constexpr double title_mm = 6.5;
    Margins margins;
    if (!panel.title.empty()) margins.top += 3.5;
    std::size_t longest = 0;
    for (const auto& label : panel.y.tick_labels) longest = std::max(longest, label.size());
    if (longest > 0) margins.left = title_mm + letters_mm * static_cast<double>(longest);
    else if (panel.y.logarithmic) margins.left = title_mm + 9.0;  // 10^{−20}
    else margins.left = title_mm + letters_mm * letters_of_ticks(y_range(panel));
    return margins;
}

void require(const Figure& figure) {
    if (figure.panels.empty() || figure.columns < 1 || !(figure.width_mm > 0.0 && figure.height_mm > 0.0 && std::isfinite(figure.width_mm * figure.height_mm)))
        throw InvalidArgument(fmt::format("a figure of {} panels in {} columns, {} mm x {} mm; expected a panel, a column and a size > 0",
                                          figure.panels.size(), figure.columns, figure.width_mm, figure.height_mm));
    for (const auto& panel : figure.panels) require_drawable(panel);
}

/// A file's name, which gnuplot does not typeset.
std::string quoted_name(const std::string& name) {
    std::string quoted = "'";
    for (const char c : name) quoted += c == '\'' ? "''" : std::string(1, c);
    return quoted + "'";
}

}  // namespace

std::string gnuplot_script(const Figure& figure, const std::string& terminal_ending, const std::string& output_file) {
    require(figure);
    const auto device = terminal(figure, terminal_ending);
    const auto small = fmt::format("{:.2f}", small_points * device.point);
    std::string script = fmt::format("set encoding utf8\nset terminal {}\nset output {}\nset minussign\nset border 15 lw 0.8\nset clip two\n"
                                     "set style fill transparent solid 0.25 noborder\n",
                                     device.definition, quoted_name(output_file));
    script += fmt::format("set xtics in mirror font ',{0}'\nset ytics in mirror font ',{0}'\nset multiplot\n", small);
    const auto columns = std::min(static_cast<std::size_t>(figure.columns), figure.panels.size());
    const auto rows = (figure.panels.size() + columns - 1) / columns;
    const double cell_width = figure.width_mm / static_cast<double>(columns), cell_height = figure.height_mm / static_cast<double>(rows);
    for (std::size_t p = 0; p < figure.panels.size(); ++p) {
        const auto& panel = figure.panels[p];
        const auto x = x_range(panel), y = y_range(panel);
        auto margins = margins_of(panel);
        // axes below each other begin at one line
        for (std::size_t other = p % columns; other < figure.panels.size(); other += columns)
            margins.left = std::max(margins.left, margins_of(figure.panels[other]).left);
        const double west = cell_width * static_cast<double>(p % columns), north = figure.height_mm - cell_height * static_cast<double>(p / columns);
        const double left = west + margins.left, right = west + cell_width - margins.right;
        const double top = north - margins.top, bottom = north - cell_height + margins.bottom;
        if (!(left < right && bottom < top))
            throw InvalidArgument(fmt::format("{} panels in {} columns leave no room for axes in {} mm x {} mm; expected a larger figure",
                                              figure.panels.size(), columns, figure.width_mm, figure.height_mm));
        std::string plots;
        for (std::size_t s = 0; s < panel.series.size(); ++s) {
            const auto& series = panel.series[s];
            const auto lines = data_lines(panel, series.mark == Mark::band ? clipped_band(panel, series, x, y) : series, x, y);
            if (lines.empty()) continue;
            const auto name = fmt::format("$panel_{}_series_{}", p + 1, s + 1);
            script += fmt::format("{} << END_OF_DATA\n{}END_OF_DATA\n", name, lines);
            for (const auto& element : elements(series, style_of(series, s), name, 0.6 * device.symbol)) plots += (plots.empty() ? "" : ", \\\n     ") + element;
        }
        script += fmt::format("set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\nset tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n",
                              left / figure.width_mm, right / figure.width_mm, top / figure.height_mm, bottom / figure.height_mm);
        script += axis_lines(panel.x, x, right - left, 'x') + axis_lines(panel.y, y, top - bottom, 'y');
        script += key_line(panel, x, y, right - left, top - bottom, small) + "unset label\nunset arrow\n";
        // gnuplot's own axis titles stand elsewhere in each terminal
        const auto title = [&](const std::string& quoted, double across_mm, double up_mm, const char* how) {
            script += fmt::format("set label {} at screen {:.5f},{:.5f} {}\n", quoted, across_mm / figure.width_mm, up_mm / figure.height_mm, how);
        };
        title(quoted_axis_title(panel.x.quantity, panel.x.unit), 0.5 * (left + right), north - cell_height + 2.6, "center");
        title(quoted_axis_title(panel.y.quantity, panel.y.unit), west + 2.6, 0.5 * (bottom + top), "center rotate by 90");
        if (!panel.title.empty()) title(quoted_bold(panel.title), left, top + 2.6, "left");
        for (const double height : panel.horizontal_lines)
            if (shows(panel.y, height) && height >= y.from && height <= y.to)
                script += fmt::format("set arrow from graph 0, first {0} to graph 1, first {0} nohead back lc rgb '#808080' lw 0.7\n", height);
        script += "plot " + (plots.empty() ? std::string("NaN notitle") : plots) + "\n";
    }
    return script + "unset multiplot\nunset output\n";
}

}  // namespace setae::figures
