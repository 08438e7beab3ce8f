// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "setae/parallel/for_each.hpp"
#include "setae/processing/processed.hpp"

namespace setae::processing {

/// An exact number of a record.
[[nodiscard]] Quantity recorded(std::string quantity, std::string symbol, double value, std::string unit);

/// A number of points, lines or strokes.
[[nodiscard]] Quantity recorded_count(std::string quantity, Index count);

/// Sq of a map, Rq of a line or polyline (exact on its segments) over defined points [m]; empty if none is defined.
[[nodiscard]] std::optional<Quantity> rms_height(const topography::Measurement& measurement, parallel::Threads threads);

/// @throws InvalidArgument: the step needs a map; remedy is the alternative for a line.
[[noreturn]] void refuse_line(std::string_view step, const topography::Measurement& measurement,
                              std::string_view remedy);

}  // namespace setae::processing
