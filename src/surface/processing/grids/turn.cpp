// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/turn.hpp"

#include <utility>

#include <fmt/format.h>

#include "pipeline/step_record.hpp"
#include "setae/core/errors.hpp"

namespace setae::processing {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

void transpose(HeightMap& map) {
    map.heights = Array2D(map.heights.transpose());
    std::swap(map.size[0], map.size[1]);
}

void flip_x(HeightMap& map) { map.heights.colwise().reverseInPlace(); }
void flip_y(HeightMap& map) { map.heights.rowwise().reverseInPlace(); }

void flip(LineScan& scan) { scan.heights.reverseInPlace(); }

/// Positions mirrored about the middle, which keeps their range.
void flip(Profile& profile) {
    const double ends = profile.positions[0] + profile.positions[profile.positions.size() - 1];
    profile.positions = Array1D(ends - profile.positions.reverse());
    profile.heights.reverseInPlace();
    if (profile.standard_error.size() > 0) profile.standard_error.reverseInPlace();
}

HeightMap& map_of(std::string_view step, topography::Measurement& measurement) {
    auto* map = std::get_if<HeightMap>(&measurement);
    if (!map) refuse_line(step, measurement, "to reverse a line, use flip");
    return *map;
}

Processed turned(std::string_view step, topography::Measurement measurement) {
    return {std::move(measurement), {std::string(step), {}, {}}};
}

}  // namespace

Processed apply(const Transpose& step, topography::Measurement measurement, parallel::Threads) {
    transpose(map_of(step_name(step), measurement));
    return turned(step_name(step), std::move(measurement));
}

Processed apply(const Flip& step, topography::Measurement measurement, parallel::Threads) {
    if (auto* map = std::get_if<HeightMap>(&measurement)) {
        if (step.direction == Direction::x) flip_x(*map);
        else flip_y(*map);
    } else if (step.direction == Direction::y) {
        throw InvalidArgument(fmt::format("flip: {} is a line and has no y; expected direction x",
                                          topography::label(topography::metadata(measurement))));
    } else if (auto* scan = std::get_if<LineScan>(&measurement)) {
        flip(*scan);
    } else {
        flip(std::get<Profile>(measurement));
    }
    return turned(step_name(step), std::move(measurement));
}

Processed apply(const QuarterTurns& step, topography::Measurement measurement, parallel::Threads) {
    auto& map = map_of(step_name(step), measurement);
    const Index turns = ((step.turns % 4) + 4) % 4;
    if (turns % 2 == 1) transpose(map);
    if (turns == 1 || turns == 2) flip_x(map);
    if (turns == 2 || turns == 3) flip_y(map);
    return turned(step_name(step), std::move(measurement));
}

}  // namespace setae::processing
