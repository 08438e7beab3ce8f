// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "setae/answers/contact_line.hpp"
#include "setae/tables/tidy_table.hpp"

namespace setae::answers {

/// An edge beside another of the same contact, such as a recording beside the simulation it was rendered from.
struct LineComparison {
    LineAnswer other;
    Index frames = 0;                  ///< whose times the other has, too
    std::optional<double> difference;  ///< rms of the radii there, at the angles of the coarser one and without the
                                       ///< place of the centre [m]; none where no times are shared
};

[[nodiscard]] LineComparison beside(const LineAnswer& answer, RecordedEdge other, const LineRequest& request);

/// What both say, side by side; the names head their columns.
[[nodiscard]] tables::TidyTable comparison_table(const LineAnswer& answer, const LineComparison& comparison,
                                                 const std::string& name, const std::string& other_name);

/// to_json() of the answer with the other's as "beside", "edge_difference" and "shared_frames".
[[nodiscard]] output::Json to_json(const LineAnswer& answer, const LineComparison& comparison);

}  // namespace setae::answers
