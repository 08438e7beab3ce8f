// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/study/surface_analysis.hpp"

namespace setae::study {

/// Distribution of the slopes of a surface's maps; A_true/A_app from it where the fit found a stretch, or where more
/// than half of the area of maps has the warning NON_GAUSSIAN or ANISOTROPIC. The warning MEASURED_SLOPES states it.
void use_measured_slopes(SurfaceResult& surface);

}  // namespace setae::study
