// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

#include "setae/parallel/for_each.hpp"
#include "setae/processing/direction.hpp"
#include "setae/processing/region.hpp"

namespace setae::processing {

/// Quantity that neighbouring scan lines share after alignment.
enum class RowAlignment {
    mean,                   ///< the mean of each line
    median,                 ///< the median of each line
    median_of_differences,  ///< the median of the differences from the previous line, summed
    polynomial,             ///< the best fitting polynomial of each line
};
inline constexpr std::array<Choice<RowAlignment>, 4> row_alignment_names{
    {{"mean", RowAlignment::mean},
     {"median", RowAlignment::median},
     {"median_of_differences", RowAlignment::median_of_differences},
     {"polynomial", RowAlignment::polynomial}}};

/// Removes offsets between scan lines.
///
///   h(x, j) −> h(x, j) − s_j + mean of s
///   mean, median: s_j = mean or median over x of h(x, j)
///   median_of_differences: s_j = s_(j−1) + median over x of h(x, j) − h(x, j−1)
///   polynomial: s_j(x) = fit of `degree` to line j
///
/// This also removes structure along the slow axis: anything constant along a line is lost, including real waves and
/// the tilt along y. The median keeps islands that cover less than half of each line; the median of differences also
/// keeps larger islands, if neighbouring lines agree in most points. Points outside the region are ignored in s_j but
/// are moved with their line. A line without points inside the region has the offset of the previous line (the first
/// ones that of the next line with points); with `polynomial` it becomes undefined.
struct AlignRows {
    RowAlignment method = RowAlignment::median;
    Index degree = 1;                    ///< degree of `polynomial`, 0 … 12
    Direction direction = Direction::x;  ///< direction of the lines
    Region region;
};

inline constexpr std::string_view step_name(const AlignRows&) { return "align_rows"; }
template <class Visitor>
void visit_parameters(AlignRows& step, Visitor& visitor) {
    visitor.choice("method", step.method, row_alignment_names, "what lines are made to agree in");
    visitor.count("degree", step.degree, "degree of the polynomial, for that method");
    visitor.choice("direction", step.direction, direction_names, "direction along which scan lines run");
    visitor.region("region", step.region, "points that count");
}

/// @throws InvalidArgument for a degree outside 0 … 12 and for lines, which have no rows (use level_polynomial);
/// UndefinedDataError if no line has enough points. Cost: linear; memory: 64 lines per thread.
[[nodiscard]] Processed apply(const AlignRows& step, topography::Measurement measurement,
                              parallel::Threads threads = {});

}  // namespace setae::processing
