// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/core/quantity.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::formats {

/// Points of a profile that are measured one after the other: first to last, last included.
struct Pass {
    Index first = 0, last = 0;
    bool backward = false;
};

/// The passes of positions. There are several if each is monotonic over at least half of the whole range and has at
/// least 8 points; otherwise all points are one pass, which may turn back in places, as contours do.
[[nodiscard]] std::vector<Pass> passes_of(const Array1D& positions);

/// Whether positions are unordered, as for scattered points: ten points or more, half of which are a tenth of the range
/// or more from the previous point.
[[nodiscard]] bool are_scattered(const Array1D& positions);

/// The last decimal place of positions in the spelling of the file: 0.1 for 24.9, 0.001 for 0.005. 0 for those with all
/// digits of a number.
[[nodiscard]] double last_digit(const Array1D& positions);

/// A pass of a profile, and the changes to its points.
struct Trace {
    topography::Measurement measurement;
    std::vector<Alert> alerts;
};

/// A line scan if positions have equal steps, within 2 % of a step or within their last digit; missing rows, steps that
/// are multiples of the usual one, become undefined heights (ROWS_MISSING). Otherwise a profile, with heights at the
/// same position averaged (POSITIONS_REPEATED). One that runs backwards is reversed. stated: the positions as in the
/// file, `unit` metres each. Cost: linear.
[[nodiscard]] Trace traced(topography::Profile profile, const Array1D& stated, double unit, const std::string& subject);

}  // namespace setae::formats
