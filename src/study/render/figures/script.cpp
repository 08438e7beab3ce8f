// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "layout.hpp"
#include "marks.hpp"
#include "markup.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/layout.hpp"
#include "ticks.hpp"

namespace setae::figures {
namespace {

constexpr double millimetres_per_inch = 25.4;
constexpr double text_points = 8.0, small_points = 7.0;

/// A terminal, with the scales that give text and symbols equal sizes in all terminals.
struct Terminal {
    std::string definition;
    double point = 1.0;  ///< a point (1/72 inch) in its unit of text
    SymbolSize symbol;
    double raised_numbers = 0.0;   ///< shift of numbers below axes, in heights of text
    double legend_spacing = 1.05;  ///< spacing of lines
};

Terminal terminal(const Figure& figure, const std::string& ending) {
    constexpr const char* font = "Liberation Sans";
    const double width = figure.width_mm / millimetres_per_inch, height = figure.height_mm / millimetres_per_inch;
    const bool pictures = std::any_of(figure.panels.begin(), figure.panels.end(),
                                      [](const Panel& panel) { return panel.map.has_value(); });
    if (ending == "svg")  // 96 pixels per inch; pictures within the file
        return {
            fmt::format("svg size {:.0f},{:.0f} fixed enhanced rounded font '{},{:.2f}' linewidth 1.1 name 'figure'{}",
                        96.0 * width, 96.0 * height, font, text_points * 4.0 / 3.0, pictures ? " standalone" : ""),
            4.0 / 3.0,
            {0.95, 0.72},
            0.35,
            0.85};
    if (ending == "pdf")  // takes 96 points for an inch
        return {
            fmt::format("pdfcairo size {:.4f}in,{:.4f}in enhanced rounded font '{},{}' fontscale 0.75 linewidth 1.6",
                        width, height, font, text_points),
            1.0,
            {0.85}};
    if (ending == "png")
        return {fmt::format("pngcairo size {:.0f},{:.0f} enhanced rounded font '{},{}' fontscale 3.125 linewidth 3.2",
                            300.0 * width, 300.0 * height, font, text_points),
                1.0,
                {3.1}};
    throw InvalidArgument(fmt::format("a figure cannot be drawn as '{}'; expected svg, pdf or png", ending));
}

std::string category_tick_lines(const Axis& axis, char name) {
    std::string ticks;
    for (std::size_t i = 0; i < axis.tick_labels.size(); ++i)
        ticks += fmt::format("{}{} {}", i == 0 ? "" : ", ", quoted_tick(axis.tick_labels[i]), i);
    return fmt::format("unset logscale {0}\nset {0}tics ({1}) scale 0.6,0.3\nunset m{0}tics\n", name, ticks);
}

std::string axis_lines(const Axis& axis, const Range& range, double length_mm, char name) {
    const auto lines = fmt::format("set {}range [{}:{}]\n", name, range.from, range.to) +
                       (!axis.tick_labels.empty() ? category_tick_lines(axis, name)
                        : axis.logarithmic        ? logarithmic_tick_lines(range, length_mm, name)
                                                  : linear_tick_lines(range, length_mm, name));
    return axis.bare ? lines + fmt::format("set format {} ''\n", name) : lines;
}

std::string key_line(const Panel& panel, const Range& x, const Range& y, const Layout& layout, const Figure& figure,
                     const std::string& font_size, double spacing) {
    const auto legend = legend_size(panel);
    if (legend.entries == 0) return "unset key\n";
    const auto look = fmt::format("vertical Left reverse noopaque nobox samplen 2.2 spacing {} font ',{}' maxrows {}\n",
                                  spacing, font_size, legend.entries);
    if (const auto& place = panel.legend_place)
        return fmt::format(
            "set key at screen {:.5f},{:.5f} left top vertical Left reverse noopaque nobox samplen 2.2 spacing {} font ',{}' maxrows {}\n",
            place->left, 1.0 - place->top - 0.8 / figure.height_mm, spacing, font_size,
            legend.rows_within(place->width * figure.width_mm));
    if (panel.legend_right)
        return fmt::format("set key at screen {:.5f},{:.5f} left top {}", layout.legend_left / figure.width_mm,
                           layout.axes.top / figure.height_mm, look);
    const double width = legend.width_mm() / (layout.axes.right - layout.axes.left),
                 height = legend.height_mm() / (layout.axes.top - layout.axes.bottom);
    const auto corner =
        panel.legend_corner.value_or(emptiest_corner(panel, x, y, std::min(width, 1.0), std::min(height, 1.0)));
    constexpr std::array<const char*, 4> names{"top right", "top left", "bottom right", "bottom left"};
    return fmt::format("set key inside {} {}", names[static_cast<std::size_t>(corner)], look);
}

void require(const Figure& figure) {
    if (figure.panels.empty() || figure.columns < 1 ||
        !(figure.width_mm > 0.0 && figure.height_mm > 0.0 && std::isfinite(figure.width_mm * figure.height_mm)))
        throw InvalidArgument(
            fmt::format("a figure of {} panels in {} columns, {} mm x {} mm; expected a panel, a column and a size > 0",
                        figure.panels.size(), figure.columns, figure.width_mm, figure.height_mm));
    for (const auto& panel : figure.panels) require_drawable(panel);
}

/// A file's name, which gnuplot does not typeset.
std::string quoted_name(const std::string& name) {
    std::string quoted = "'";
    for (const char c : name) quoted += c == '\'' ? "''" : std::string(1, c);
    return quoted + "'";
}

/// A place on the page for gnuplot.
std::string on_page(const Figure& figure, double across_mm, double up_mm) {
    return fmt::format("{:.5f},{:.5f}", across_mm / figure.width_mm, up_mm / figure.height_mm);
}

/// The colours of a map and their bar, to the right of the axes.
std::string colour_lines(const Figure& figure, const HeatMap& map, const Layout& layout, const std::string& small) {
    const auto range = value_range(map);
    const double left = layout.axes.right + colour_bar_gap_mm;
    // viridis: even steps of lightness, also to the colour-blind
    return fmt::format(
        "set palette defined (0 '#440154', 1 '#46327e', 2 '#365c8d', 3 '#277f8e', 4 '#1fa187', 5 '#4ac16d', 6 '#a0da39', 7 '#fde725')\n"
        "set cbrange [{}:{}]\nset colorbox user origin screen {} size screen {:.5f},{:.5f} noinvert border\n"
        "set cbtics in font ',{}' scale 0.4,0.2 offset -0.6,0 format '%g'\nset label {} at screen {} center rotate by 90\n",
        range.from, range.to, on_page(figure, left, layout.axes.bottom), colour_bar_mm / figure.width_mm,
        (layout.axes.top - layout.axes.bottom) / figure.height_mm, small,
        quoted_axis_title(map.values_axis.quantity, map.values_axis.unit),
        on_page(figure, layout.cell.right - 2.5, 0.5 * (layout.axes.bottom + layout.axes.top)));
}

std::string note_line(const Note& note, const std::string& small) {
    const auto* side = note.side == Note::Side::centre  ? "center"
                       : note.side == Note::Side::right ? "left offset 0.6,0"
                                                        : "right offset -0.6,0";
    return fmt::format("set label {} at first {},{} {} font ',{}' tc rgb {} front\n", quoted_verbatim(note.text),
                       note.x, note.y, side, small, colour_name(note.colour));
}

std::string panel_lines(const Figure& figure, std::size_t p, const Terminal& device, const std::string& small) {
    const auto& panel = figure.panels[p];
    const auto x = x_range(panel), y = y_range(panel);
    const auto layout = layout_of(figure, p);
    const auto& axes = layout.axes;
    std::string script, plots;
    const auto plot = [&](const std::string& element) { plots += (plots.empty() ? "" : ", \\\n     ") + element; };
    if (panel.map) {
        script += fmt::format("$panel_{}_map << END_OF_DATA\n{}END_OF_DATA\n", p + 1, map_lines(*panel.map));
        plot(fmt::format("$panel_{}_map using 1:2:3 with image notitle", p + 1));
    }
    for (std::size_t s = 0; s < panel.series.size(); ++s) {
        const auto& series = panel.series[s];
        const auto lines =
            data_lines(panel, series.mark == Mark::band ? clipped_band(panel, series, x, y) : series, x, y);
        if (lines.empty() && !series.legend_only) continue;
        const auto name = fmt::format("$panel_{}_series_{}", p + 1, s + 1);
        if (!series.legend_only) script += fmt::format("{} << END_OF_DATA\n{}END_OF_DATA\n", name, lines);
        for (const auto& element : elements(series, s, name, {0.6 * device.symbol.symbols, device.symbol.diamonds}))
            plot(element);
    }
    // only a legend is no plot
    if (plots.starts_with("keyentry")) plots = "NaN notitle, \\\n     " + plots;
    script += fmt::format(
        "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\nset tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n",
        axes.left / figure.width_mm, axes.right / figure.width_mm, axes.top / figure.height_mm,
        axes.bottom / figure.height_mm);
    script += axis_lines(panel.x, x, axes.right - axes.left, 'x') + axis_lines(panel.y, y, axes.top - axes.bottom, 'y');
    script += panel.sketch ? "unset border\nunset xtics\nunset ytics\n" : "set border 15 lw 0.8\n";
    script += key_line(panel, x, y, layout, figure, small, device.legend_spacing) + "unset label\nunset arrow\n";
    // gnuplot's own axis titles have other positions in each terminal
    const auto title = [&](const std::string& quoted, double across_mm, double up_mm, const char* how) {
        script += fmt::format("set label {} at screen {} {}\n", quoted, on_page(figure, across_mm, up_mm), how);
    };
    const auto axis_title = [](const Axis& axis, double length_mm) {
        return quoted_axis_title(title_quantity(axis, length_mm), axis.unit);
    };
    if (!panel.x.bare && !panel.sketch)
        title(axis_title(panel.x, layout.cell.right - layout.cell.left), 0.5 * (axes.left + axes.right),
              layout.cell.bottom + 2.6, "center");
    if (!panel.y.bare && !panel.sketch)
        title(axis_title(panel.y, axes.top - axes.bottom + 4.0), layout.cell.left + 2.6, 0.5 * (axes.bottom + axes.top),
              "center rotate by 90");
    if (const auto heading = heading_of(figure, p); !heading.letter.empty() || !heading.words.empty()) {
        const double space_mm = layout.cell.right - axes.left - (heading.letter.empty() ? 0.0 : 2.0 * title_letters_mm);
        const auto words =
            shortened(heading.words, static_cast<std::size_t>(std::max(space_mm / title_letters_mm, 1.0)));
        title(quoted_heading(heading.letter, words), axes.left, axes.top + 2.6, "left");
    }
    for (const double height : panel.horizontal_lines)
        if (shows(panel.y, height) && height >= y.from && height <= y.to)
            script += fmt::format(
                "set arrow from graph 0, first {0} to graph 1, first {0} nohead back lc rgb '#808080' lw 0.7\n",
                height);
    for (const auto& note : panel.notes) script += note_line(note, small);
    if (panel.map) script += colour_lines(figure, *panel.map, layout, small);
    return script + "plot " + (plots.empty() ? std::string("NaN notitle") : plots) + "\n";
}

}  // namespace

std::string gnuplot_script(const Figure& figure, const std::string& terminal_ending, const std::string& output_file) {
    require(figure);
    const auto device = terminal(figure, terminal_ending);
    const auto small = fmt::format("{:.2f}", small_points * device.point);
    std::string script = fmt::format(
        "set encoding utf8\nset terminal {}\nset output {}\nset minussign\nset border 15 lw 0.8\nset clip two\n"
        "set style fill solid noborder\n",
        device.definition, quoted_name(output_file));
    script +=
        fmt::format("set xtics in mirror font ',{0}' offset 0,{1}\nset ytics in mirror font ',{0}'\nset multiplot\n",
                    small, device.raised_numbers);
    for (std::size_t p = 0; p < figure.panels.size(); ++p) script += panel_lines(figure, p, device, small);
    return script + "unset multiplot\nunset output\n";
}

}  // namespace setae::figures
