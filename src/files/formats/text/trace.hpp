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

/// The passes that positions run through. More than one where each is monotonic over half the range of all or more and
/// has 8 points or more; else all points are one pass, which may turn back here and there, as contours do.
[[nodiscard]] std::vector<Pass> passes_of(const Array1D& positions);

/// Whether positions jump about, as those of scattered points do: ten points or more, half of which lie a tenth of the
/// range or more from the point before.
[[nodiscard]] bool are_scattered(const Array1D& positions);

/// The least decimal place that positions have as a file spells them: 0.1 for 24.9, 0.005 is 0.001. 0 for those that
/// use all digits of a number.
[[nodiscard]] double last_digit(const Array1D& positions);

/// What a pass of a profile is, and what was made of its points.
struct Trace {
    topography::Measurement measurement;
    std::vector<Alert> alerts;
};

/// A line scan where positions have equal steps, within 2 % of a step or within their last digit; missing rows, steps
/// that are whole multiples of the usual one, become undefined heights (ROWS_MISSING). A profile as traced of other
/// positions, heights at the same one averaged (POSITIONS_REPEATED). One that runs backwards is turned.
/// stated: the positions as the file spells them, `unit` metres each. Cost: linear.
[[nodiscard]] Trace traced(topography::Profile profile, const Array1D& stated, double unit, const std::string& subject);

}  // namespace setae::formats
