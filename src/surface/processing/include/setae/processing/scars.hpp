// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <string_view>

#include "setae/parallel/for_each.hpp"
#include "setae/processing/parameters.hpp"
#include "setae/processing/processed.hpp"
#include "setae/topography/mask.hpp"

namespace setae::processing {

/// Sign of the strokes that are scars.
enum class ScarSign {
    positive,  ///< above the adjacent lines
    negative,  ///< below
    both,
};
inline constexpr std::array<Choice<ScarSign>, 3> scar_sign_names{
    {{"positive", ScarSign::positive}, {"negative", ScarSign::negative}, {"both", ScarSign::both}}};

/// Replacement of a scar.
enum class ScarReplacement {
    undefined,
    neighbour_lines,  ///< linear in y between the nearest points without scar above and below
};
inline constexpr std::array<Choice<ScarReplacement>, 2> scar_replacement_names{
    {{"undefined", ScarReplacement::undefined}, {"neighbour_lines", ScarReplacement::neighbour_lines}}};

/// Scars: strokes along the fast axis x, a few scan lines wide, from failures of feedback or contact.
///
/// d: rms of the differences of neighbouring scan lines. A run of at most `width` points along y is a candidate if it
/// differs from both adjacent points by at least `low` · d; with `high` · d it is a scar, and candidates next to a scar
/// along x belong to it. Strokes shorter than `length` points are kept. Source: Nečas and Klapetek, Cent. Eur. J. Phys.
/// 10 (2012) 181, and Gwyddion's user guide, "Scars"; default thresholds of Gwyddion.
struct RemoveScars {
    double high = 0.666;  ///< >= low
    double low = 0.25;    ///< > 0
    Index length = 16;    ///< minimum number of points along x, >= 1
    Index width = 4;      ///< maximum number of scan lines, >= 1
    ScarSign sign = ScarSign::both;
    ScarReplacement replace_by = ScarReplacement::neighbour_lines;
};

inline constexpr std::string_view step_name(const RemoveScars&) { return "remove_scars"; }
template <class Visitor>
void visit_parameters(RemoveScars& step, Visitor& visitor) {
    visitor.number("high", step.high,
                   "height of a scar above its neighbours, in rms differences of neighbouring lines");
    visitor.number("low", step.low, "height of points that belong to a scar beside them, in the same unit");
    visitor.count("length", step.length, "least number of points along x");
    visitor.count("width", step.width, "largest number of scan lines");
    visitor.choice("sign", step.sign, scar_sign_names, "whether scars lie above or below");
    visitor.choice("replace_by", step.replace_by, scar_replacement_names, "what takes the place of a scar");
}

/// Rows of a map on request: heights of the rows first … last − 1, computed into `room`, which has as many places, or a
/// view of existing memory. Called from several threads.
struct RowsOfHeights {
    Index rows = 0, columns = 0;
    std::function<const double*(Index first, Index last, double* room)> rows_of;
};

/// The points of scars: 1 = scar. Cost: two passes over the rows; memory: one mask per sign.
/// @throws InvalidArgument for parameters outside their domain.
[[nodiscard]] topography::Mask find_scars(const RemoveScars& step, const topography::HeightMap& map,
                                          parallel::Threads threads = {});
[[nodiscard]] topography::Mask find_scars(const RemoveScars& step, const RowsOfHeights& map,
                                          parallel::Threads threads = {});

/// @throws InvalidArgument for parameters outside their domain and for lines, which have no neighbouring lines.
[[nodiscard]] Processed apply(const RemoveScars& step, topography::Measurement measurement,
                              parallel::Threads threads = {});

}  // namespace setae::processing
