// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "setae/core/arrays.hpp"

namespace setae::figures {

/// Colours of figures, as "RRGGBB". The first eight are Okabe and Ito's, which the colour-blind tell apart; those after
/// them belong to instruments (instrument_look()) and to nothing else. Source: Okabe, Ito, Color Universal Design
/// (2008), https://jfly.uni-koeln.de/color/; Tol, Colour Schemes (2021), https://personal.sron.nl/~pault/.
inline constexpr std::array<const char*, 13> palette{"0072B2", "D55E00", "009E73", "CC79A7", "000000",
                                                     "E69F00", "56B4E9", "F0E442", "332288", "AA4499",
                                                     "117733", "BBAA33", "888888"};
inline constexpr int general_colours = 8;  ///< of the palette, for whatever a figure shows

/// How a series is shown.
enum class Mark {
    points,  ///< symbols
    line,    ///< a line
    both,    ///< symbols on a line
    band,    ///< filled between lower and upper, with a line along y where there is one
    area,    ///< the closed polygon through the points, filled
};

/// One curve of a panel. x and y are in the units of the panel's axes; NaN is a gap.
struct Series {
    std::string label;     ///< in the legend, letter by letter; empty: not there
    Array1D x, y;          ///< of equal length; y may be empty for a band
    Array1D lower, upper;  ///< ends of error bars or of the band, not their lengths; both empty: none
    Mark mark = Mark::both;
    int colour = -1;           ///< index into the palette, taken modulo its size; -1: the series' place in its panel
                               ///< among the general colours
    int symbol = -1;           ///< symbol and dash alike; -1: as colour
    bool hollow = false;       ///< symbols
    Array1D left, right;       ///< ends of error bars along x; both empty: none
    int dash = -1;             ///< of a line, 0 solid; -1: as symbol
    double line_width = 1.3;   ///< of a line [points], about
    double opacity = 1.0;      ///< of line and symbols, 0 … 1
    bool in_legend = true;     ///< false: the label stands in the data alone
    bool legend_only = false;  ///< explains what other series share; it has no points of its own
    std::vector<std::string>
        names;  ///< of the points, where each is a thing of its own; empty: none. Not drawn; in the data
};

/// One axis of a panel.
struct Axis {
    /// Typeset: between asterisks italic, _ and ^ lower and raise the word or {group} after them, as in
    /// "rms slope *h*'_rms"; a backslash takes the next letter as it is.
    std::string quantity;
    std::string unit;                ///< as setae spells units, "mJ/m2"; set upright, mJ m⁻²; empty or "1": none
    bool logarithmic = false;        ///< values that are not positive are gaps
    std::optional<double> from, to;  ///< ends; without, those of the data and a margin
    bool bare = false;               ///< ticks alone: numbers and title stand at the axis of a panel beside it
    std::vector<std::string> tick_labels;  ///< categories at 0, 1, 2 …, letter by letter; empty: numbers
};

enum class Corner { top_right, top_left, bottom_right, bottom_left };

/// Values over a rectangle, as a picture with a colour bar.
struct HeatMap {
    Array2D values;       ///< (nx, ny), row-major as a height map; NaN is left white
    double width = 0.0;   ///< along x, from 0, in the unit of the panel's axes
    double height = 0.0;  ///< along y, from 0
    Axis values_axis;     ///< quantity and unit of the values; ends of the colours
};

/// Text within a panel, letter by letter.
struct Note {
    std::string text;
    double x = 0.0, y = 0.0;                                      ///< in the units of the axes
    enum class Side { centre, right, left } side = Side::centre;  ///< which side of the place the text stands on
    int colour = 4;                                               ///< index into the palette; black
};

/// Where a panel stands within its figure, in shares of its width and height from the top left corner.
struct Place {
    double left = 0.0, top = 0.0, width = 1.0, height = 1.0;
};

/// One pair of axes.
struct Panel {
    std::string title;  ///< above its left end, letter by letter, such as "A"
    std::string shows;  ///< after the title: what the panel shows, in a few words
    Axis x, y;
    std::vector<Series> series;
    std::vector<double> horizontal_lines;  ///< thin, grey, across the panel
    bool legend = true;
    std::optional<Corner> legend_corner;  ///< without: the corner that holds the least data
    bool sketch = false;                  ///< a drawing: no frame, ticks, numbers or axis titles
    bool legend_beside = false;           ///< to the right of the axes, not within them
    std::optional<Place> legend_place;    ///< elsewhere in the figure, its entries in columns that fill the place
    std::optional<Place> place;           ///< without: its cell of the grid
    std::optional<HeatMap> map;
    std::vector<Note> notes;
};

/// Panels in rows from the left, `columns` a row.
struct Figure {
    std::vector<Panel> panels;
    int columns = 1;
    double width_mm = 85.0, height_mm = 65.0;  ///< of the whole; 85 is one column of a journal, 178 two
};

/// Text above a panel: a letter where a figure has several panels with titles, and what the panel is.
struct Heading {
    std::string letter;  ///< "A", "B" …; empty: none
    std::string words;
};

/// A title that is a letter is the panel's letter; other titles follow the next one in the alphabet.
[[nodiscard]] Heading heading_of(const Figure& figure, std::size_t panel);

/// Height of the strip that a panel's legend needs where its entries stand in columns as wide as the figure [mm]; 0
/// where it has none.
[[nodiscard]] double legend_strip_mm(const Figure& figure, std::size_t panel = 0);

/// Puts the legend of a panel into a strip above all panels, which move into the rest of the figure's height.
void put_legend_above(Figure& figure, std::size_t panel = 0);

/// The gnuplot program that draws a figure, its data inline. The same figure gives the same bytes.
///
/// terminal_ending: "svg", "pdf" or "png" (300 dots an inch).  output_file: what the program writes.
/// Colours are those of the palette; symbol or dash differ, too. Text other than an axis' quantity stands as it is,
/// control characters as blanks. The title of an axis that is shorter than it loses the words before the symbol.
/// Numbers at axes have no letter e: 2·10⁶.
/// @throws InvalidArgument for another ending, a figure without panels or with columns < 1, a size that is not > 0,
/// series whose arrays differ in length, or ends of an axis that are not finite, not in order, or not positive on a
/// logarithmic one.
[[nodiscard]] std::string gnuplot_script(const Figure& figure, const std::string& terminal_ending,
                                         const std::string& output_file);

/// Bytes of a file with a figure, drawn by gnuplot. ending: "svg", "pdf" or "png". No date enters it, and nothing
/// outside it is referred to.
/// @throws as draw.
[[nodiscard]] std::string drawn(const Figure& figure, const std::string& ending);

/// Which gnuplot draws: its path, size and time of change, without running it. Empty where there is none.
[[nodiscard]] std::string drawing_program();

/// Draws a figure by gnuplot into a file whose ending is .svg, .pdf or .png, replaced as a whole. No date enters the
/// file.
/// @throws InvalidArgument as gnuplot_script; FileError where the file cannot be written, where gnuplot fails (with its
/// own words) or where there is no gnuplot (with what to install).
void draw(const Figure& figure, const std::string& path);

/// The numbers of a figure as CSV, one row a point: panel, series, name of the point, quantity, unit and value along x
/// and along y, lower, upper, left, right; empty where there is none or NaN. Quantities are plain text, "W_app". Panels
/// without title are numbered from 1.
/// Where a panel holds a map, the quantity, unit and value of its cells are in three more columns.
/// @throws InvalidArgument for series whose arrays differ in length.
[[nodiscard]] std::string data_text(const Figure& figure);

/// Writes them. @throws as data_text; FileError.
void write_data(const Figure& figure, const std::string& path);

}  // namespace setae::figures
