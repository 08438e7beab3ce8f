// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "setae/core/arrays.hpp"

namespace setae::figures {

/// Colours of figures, as "RRGGBB". The first eight are those of Okabe and Ito, distinguishable with colour blindness;
/// the others are reserved for instruments (instrument_look()). Source: Okabe, Ito, Color Universal Design (2008),
/// https://jfly.uni-koeln.de/color/; Tol, Colour Schemes (2021), https://personal.sron.nl/~pault/.
inline constexpr std::array<const char*, 13> palette{"0072B2", "D55E00", "009E73", "CC79A7", "000000",
                                                     "E69F00", "56B4E9", "F0E442", "332288", "AA4499",
                                                     "117733", "BBAA33", "888888"};
inline constexpr int general_colours = 8;  ///< number of colours of the palette for general use

/// Representation of a series.
enum class Mark {
    points,  ///< symbols
    line,    ///< a line
    both,    ///< symbols on a line
    band,    ///< filled between lower and upper, with a line along y where there is one
    area,    ///< closed polygon through the points, filled
};

/// One curve of a panel. x and y are in the units of the panel's axes; NaN is a gap.
struct Series {
    std::string label;     ///< label in the legend, as plain text; empty: no entry
    Array1D x, y;          ///< of equal length; y may be empty for a band
    Array1D lower, upper;  ///< ends of error bars or of the band, not their lengths; empty without them
    Mark mark = Mark::both;
    /// index into the palette, taken modulo its size; -1: the position of the series in its panel among the general
    /// colours
    int colour = -1;
    int symbol = -1;           ///< index of symbol and dash; -1: as colour
    bool hollow = false;       ///< for symbols
    Array1D left, right;       ///< ends of error bars along x; empty without them
    int dash = -1;             ///< dash of a line, 0 solid; -1: as symbol
    double line_width = 1.3;   ///< approximate width of a line [points]
    double opacity = 1.0;      ///< opacity of line and symbols, 0 … 1
    bool in_legend = true;     ///< false: the label is in the data only
    bool legend_only = false;  ///< entry that explains other series; it has no points
    std::vector<std::string>
        names;  ///< names of the points, where each is an object; else empty. Not drawn, but in the data
};

/// One axis of a panel.
struct Axis {
    /// Typeset: text between asterisks is italic, _ and ^ lower and raise the word or {group} after them, as in
    /// "rms slope *h*'_rms"; a backslash escapes the next letter.
    std::string quantity;
    std::string unit;                ///< in the notation of setae, "mJ/m2"; set upright, mJ m⁻²; empty or "1": none
    bool logarithmic = false;        ///< values that are not positive are gaps
    std::optional<double> from, to;  ///< ends of the axis; without them, those of the data and a margin
    bool bare = false;               ///< only ticks: numbers and title are at the axis of an adjacent panel
    std::vector<std::string> tick_labels;  ///< categories at 0, 1, 2 …, as plain text; empty: numbers
};

enum class Corner { top_right, top_left, bottom_right, bottom_left };

/// Values over a rectangle, as a picture with a colour bar.
struct HeatMap {
    Array2D values;       ///< (nx, ny), row-major as a height map; NaN is left white
    double width = 0.0;   ///< extent along x, from 0, in the unit of the panel's axes
    double height = 0.0;  ///< extent along y, from 0
    Axis values_axis;     ///< quantity and unit of the values; ends of the colours
};

/// Text within a panel, as plain text.
struct Note {
    std::string text;
    double x = 0.0, y = 0.0;                                      ///< in the units of the axes
    enum class Side { centre, right, left } side = Side::centre;  ///< side of the position on which the text is
    int colour = 4;                                               ///< index into the palette; black
};

/// Position of a panel within its figure, in shares of its width and height from the top left corner.
struct Place {
    double left = 0.0, top = 0.0, width = 1.0, height = 1.0;
};

/// One pair of axes.
struct Panel {
    std::string title;  ///< above the left end, as plain text, such as "A"
    std::string shows;  ///< after the title: content of the panel in a few words
    Axis x, y;
    std::vector<Series> series;
    std::vector<double> horizontal_lines;  ///< thin grey lines across the panel
    bool legend = true;
    std::optional<Corner> legend_corner;  ///< without it: the corner with the least data
    bool sketch = false;                  ///< a drawing: no frame, ticks, numbers or axis titles
    bool legend_right = false;            ///< whether the legend is to the right of the axes, not within them
    /// position elsewhere in the figure, with entries in columns that fill the position
    std::optional<Place> legend_place;
    std::optional<Place> place;  ///< without it: its cell of the grid
    std::optional<HeatMap> map;
    std::vector<Note> notes;
};

/// Panels in rows from the left, with `columns` panels per row.
struct Figure {
    std::vector<Panel> panels;
    int columns = 1;
    double width_mm = 85.0, height_mm = 65.0;  ///< size of the figure; 85 is one column of a journal, 178 two
};

/// Text above a panel: a letter where a figure has several panels with titles, and the content of the panel.
struct Heading {
    std::string letter;  ///< "A", "B" …; empty: none
    std::string words;
};

/// A title that consists of a letter is the panel's letter; other titles get the next letter of the alphabet.
[[nodiscard]] Heading heading_of(const Figure& figure, std::size_t panel);

/// Height of the strip of a panel's legend with entries in columns as wide as the figure [mm]; 0 without a legend.
[[nodiscard]] double legend_strip_mm(const Figure& figure, std::size_t panel = 0);

/// Moves the legend of a panel into a strip above all panels, which use the rest of the figure's height.
void put_legend_above(Figure& figure, std::size_t panel = 0);

/// The gnuplot program that draws a figure, with its data inline. Equal figures give equal bytes.
///
/// terminal_ending: "svg", "pdf" or "png" (300 dots per inch).  output_file: file that the program writes.
/// Colours are those of the palette; symbols or dashes differ, too. Text other than an axis' quantity is plain text,
/// with control characters as blanks. The title of an axis that is too long for the axis loses the words before the
/// symbol. Numbers at axes have no letter e: 2·10⁶.
/// @throws InvalidArgument for another ending, a figure without panels or with columns < 1, a size that is not > 0,
/// series whose arrays differ in length, or ends of an axis that are not finite, not in order, or not positive on a
/// logarithmic one.
[[nodiscard]] std::string gnuplot_script(const Figure& figure, const std::string& terminal_ending,
                                         const std::string& output_file);

/// Bytes of a file with a figure, drawn by gnuplot. ending: "svg", "pdf" or "png". The file contains no date and no
/// reference to other files.
/// @throws as draw.
[[nodiscard]] std::string drawn(const Figure& figure, const std::string& ending);

/// Identity of the gnuplot that is used: its path, size and time of change, without running it. Empty without gnuplot.
[[nodiscard]] std::string drawing_program();

/// Draws a figure by gnuplot into a file whose ending is .svg, .pdf or .png, replaced as a whole. The file contains no
/// date.
/// @throws InvalidArgument as gnuplot_script; FileError where the file cannot be written, where gnuplot fails (with its
/// message) or where there is no gnuplot (with the packages to install).
void draw(const Figure& figure, const std::string& path);

/// The numbers of a figure as CSV, one row per point: panel, series, name of the point, quantity, unit and value along
/// x and along y, lower, upper, left, right; empty where there is none or NaN. Quantities are plain text, "W_app".
/// Panels without title are numbered from 1.
/// For a panel with a map, the quantity, unit and value of its cells are in three more columns.
/// @throws InvalidArgument for series whose arrays differ in length.
[[nodiscard]] std::string data_text(const Figure& figure);

/// Writes the numbers of a figure. @throws as data_text; FileError.
void write_data(const Figure& figure, const std::string& path);

}  // namespace setae::figures
