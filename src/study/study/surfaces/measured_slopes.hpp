// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/study/surface_analysis.hpp"

namespace setae::study {

/// How the slopes of a surface's maps are distributed; A_true/A_app by that where the fit found a stretch, or where
/// more than half of the area of maps has the alert NON_GAUSSIAN or ANISOTROPIC. The alert MEASURED_SLOPES says so.
void use_measured_slopes(SurfaceResult& surface);

}  // namespace setae::study
