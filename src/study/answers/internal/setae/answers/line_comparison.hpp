// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "setae/answers/contact_line.hpp"
#include "setae/tables/tidy_table.hpp"

namespace setae::answers {

/// Comparison of two edges of the same contact, such as a recording and the simulation from which it was rendered.
struct LineComparison {
    LineAnswer other;
    Index frames = 0;                  ///< whose times the other has, too
    std::optional<double> difference;  ///< rms of the radii there, at the angles of the coarser one and without the
                                       ///< place of the centre [m]; none where no times are shared
};

[[nodiscard]] LineComparison beside(const LineAnswer& answer, RecordedEdge other, const LineRequest& request);

/// Results of both edges in two columns, headed by their names.
[[nodiscard]] tables::TidyTable comparison_table(const LineAnswer& answer, const LineComparison& comparison,
                                                 const std::string& name, const std::string& other_name);

}  // namespace setae::answers
