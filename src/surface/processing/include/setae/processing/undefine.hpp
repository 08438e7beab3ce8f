// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "setae/parallel/for_each.hpp"
#include "setae/processing/parameters.hpp"
#include "setae/processing/processed.hpp"

namespace setae::processing {

/// Heights that are none become undefined: those of a value that marks missing ones, and those beyond limits.
///
/// A height has a value where it differs by no more than 1e-7 of it, which is what single precision keeps of a number.
/// Limits are heights as they are when the step is done: before levelling, those of the file.
struct Undefine {
    std::optional<double> value = {};  ///< [m]
    std::optional<double> above = {};  ///< [m]: heights above it
    std::optional<double> below = {};  ///< [m]: heights below it
};

inline constexpr std::string_view step_name(const Undefine&) { return "undefine"; }
template <class Visitor>
void visit_parameters(Undefine& step, Visitor& visitor) {
    visitor.optional_length("value", step.value, "heights of this value become undefined, such as `-9999 um`");
    visitor.optional_length("above", step.above, "heights above it become undefined");
    visitor.optional_length("below", step.below, "heights below it become undefined");
}

/// Points of a polyline are left out instead, since polylines hold no undefined heights.
/// @throws InvalidArgument for a step without value and limits; UndefinedDataError where no defined height would be
/// left.
[[nodiscard]] Processed apply(const Undefine& step, topography::Measurement measurement,
                              parallel::Threads threads = {});

}  // namespace setae::processing
