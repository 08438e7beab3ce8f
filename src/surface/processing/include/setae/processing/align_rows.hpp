// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

#include "setae/parallel/for_each.hpp"
#include "setae/processing/direction.hpp"
#include "setae/processing/region.hpp"

namespace setae::processing {

/// What neighbouring scan lines are made to agree in.
enum class RowAlignment {
    mean,                   ///< the mean of each line
    median,                 ///< the median of each line
    median_of_differences,  ///< the median of the differences to the line before, added up
    polynomial,             ///< the polynomial that fits each line best
};
inline constexpr std::array<Choice<RowAlignment>, 4> row_alignment_names{
    {{"mean", RowAlignment::mean},
     {"median", RowAlignment::median},
     {"median_of_differences", RowAlignment::median_of_differences},
     {"polynomial", RowAlignment::polynomial}}};

/// Scan lines that jumped against each other are set to one level.
///
///   h(x, j) −> h(x, j) − s_j + mean of s,   s_j: mean or median over x of h(x, j);
///   median_of_differences: s_j = s_(j−1) + median over x of h(x, j) − h(x, j−1);  polynomial: s_j(x) the line's own,
///   of `degree`
///
/// This takes structure along the slow axis with it: whatever is constant along a line is gone, real waves and the tilt
/// along y too. The median keeps islands that cover less than half of each line, the median of differences those that
/// cover more as well, as long as neighbouring lines agree in most points. Points outside the region do not count but
/// are moved with their line. A line without a point that counts moves with the line before it (the first ones with the
/// next that has some); with `polynomial` it becomes undefined.
struct AlignRows {
    RowAlignment method = RowAlignment::median;
    Index degree = 1;                    ///< of `polynomial`, 0 … 12
    Direction direction = Direction::x;  ///< along which lines run
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

/// @throws InvalidArgument for a degree outside 0 … 12 and for lines, which have no rows: level_polynomial levels them;
/// UndefinedDataError where no line has points enough.
/// Cost: linear; holds 64 lines a thread.
[[nodiscard]] Processed apply(const AlignRows& step, topography::Measurement measurement,
                              parallel::Threads threads = {});

}  // namespace setae::processing
