// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/validation/contour_trials.hpp"

namespace setae::validation {

/// A rendered curve and the size of its picture.
struct RenderedContour {
    simulation::RoughCurve truth;  ///< as it is in the picture, vacuum on the left of the direction of the curve
    long width = 0, height = 0;
    double shortest_wave = 0.0;  ///< [px]; spectra are compared down to it
};

/// All numbers of a trial but run and kind. @throws UndefinedDataError for a trace without segments.
[[nodiscard]] ContourTrial compared(const imaging::ContourTrace& trace, const RenderedContour& rendered);

}  // namespace setae::validation
