// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "setae/parallel/for_each.hpp"
#include "setae/processing/parameters.hpp"
#include "setae/processing/processed.hpp"

namespace setae::processing {

/// Sets invalid heights undefined: those with a value that marks missing heights, and those beyond limits.
///
/// A height has a value if it differs from it by a relative 1e-7 at most, the precision of single-precision numbers.
/// Limits refer to heights at this step: before levelling, those of the file.
struct Undefine {
    std::optional<double> value = {};  ///< [m]
    std::optional<double> above = {};  ///< [m]: higher points become undefined
    std::optional<double> below = {};  ///< [m]: lower points become undefined
};

inline constexpr std::string_view step_name(const Undefine&) { return "undefine"; }
template <class Visitor>
void visit_parameters(Undefine& step, Visitor& visitor) {
    visitor.optional_length("value", step.value, "heights of this value become undefined, such as `-9999 um`");
    visitor.optional_length("above", step.above, "heights above it become undefined");
    visitor.optional_length("below", step.below, "heights below it become undefined");
}

/// Points of a polyline are removed instead, since polylines contain no undefined heights.
/// @throws InvalidArgument for a step without value and limits; UndefinedDataError if no defined height would remain.
[[nodiscard]] Processed apply(const Undefine& step, topography::Measurement measurement,
                              parallel::Threads threads = {});

}  // namespace setae::processing
