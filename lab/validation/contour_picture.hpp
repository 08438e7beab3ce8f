// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/validation/contour_trials.hpp"

namespace setae::validation {

/// Writes KIND_RUN.png, the picture twice as large with the curve in blue and the trace in orange, KIND_RUN_bare.png
/// without them, and KIND_RUN_truth.csv, the curve's points [px].
/// @throws FileError.
void write_contour_picture(const std::string& folder, const ContourTrial& trial, const imaging::FramePixels& pixels,
                           const simulation::PixelCurve& truth, const imaging::ContourTrace& trace);

}  // namespace setae::validation
