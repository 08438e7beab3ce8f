// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "setae/parallel/for_each.hpp"
#include "setae/processing/parameters.hpp"
#include "setae/processing/processed.hpp"

namespace setae::processing {

/// The heights of another measurement of the same kind added. Metres on both sides, whatever unit their files have.
///
/// Both lie with their first points on each other; with `align` the other one is shifted first by what shift_between
/// finds. On equal grids and without a shift heights are added point by point; otherwise the other one is taken by
/// linear interpolation at the points of the first. Points that it does not cover, or where either is undefined, are
/// undefined. The result is periodic where both are and their sizes agree to 1e-10.
struct AddMap {
    std::string file = {};     ///< of the other measurement
    std::string channel = {};  ///< in that file; empty: its only or first one
    bool align = false;        ///< shift the other one onto this one first
};

/// The same with the other one's heights subtracted: a reference map or a repeated scan.
struct SubtractMap {
    std::string file = {};
    std::string channel = {};
    bool align = false;
};

/// `other`: what the caller read from `file` and `channel`. The record has the shift applied.
/// @throws InvalidArgument where one is a line and the other a map, for polylines, or where nothing overlaps; with
/// `align` also for lines.
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
