// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "setae/parallel/for_each.hpp"
#include "setae/processing/parameters.hpp"
#include "setae/processing/processed.hpp"

namespace setae::processing {

/// Adds the heights of another measurement of the same kind. Both are in metres, regardless of the units of their
/// files.
///
/// The first points of both coincide; with `align` the other measurement is shifted first by the result of
/// shift_between. On equal grids and without a shift heights are added point by point; otherwise the other measurement
/// is interpolated linearly at the points of the first. Points outside the other measurement, or with an undefined
/// height in either, are undefined. The result is periodic if both are and their sizes agree to 1e-10.
struct AddMap {
    std::string file = {};     ///< file of the other measurement
    std::string channel = {};  ///< channel of that file; empty: its only or first one
    bool align = false;        ///< shift the other measurement onto this one first
};

/// Subtracts the heights of another measurement: a reference map or a repeated scan. Otherwise as AddMap.
struct SubtractMap {
    std::string file = {};
    std::string channel = {};
    bool align = false;
};

/// `other`: the measurement read from `file` and `channel`. The record contains the applied shift.
/// @throws InvalidArgument if one is a line and the other a map, for polylines, or without overlap; with `align` also
/// for lines.
[[nodiscard]] Processed apply(const AddMap& step, topography::Measurement measurement,
                              const topography::Measurement& other, parallel::Threads threads = {});
[[nodiscard]] Processed apply(const SubtractMap& step, topography::Measurement measurement,
                              const topography::Measurement& other, parallel::Threads threads = {});

inline constexpr std::string_view step_name(const AddMap&) { return "add_map"; }
inline constexpr std::string_view step_name(const SubtractMap&) { return "subtract_map"; }

template <class Visitor>
void visit_parameters(AddMap& step, Visitor& visitor) {
    visitor.text("file", step.file, "of the map that is added");
    visitor.text("channel", step.channel, "in that file");
    visitor.flag("align", step.align, "whether it is shifted onto this one first");
}
template <class Visitor>
void visit_parameters(SubtractMap& step, Visitor& visitor) {
    visitor.text("file", step.file, "of the map that is subtracted");
    visitor.text("channel", step.channel, "in that file");
    visitor.flag("align", step.align, "whether it is shifted onto this one first");
}

}  // namespace setae::processing
