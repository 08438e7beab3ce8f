// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/file_figures/look.hpp"
#include "setae/study/surface_analysis.hpp"

namespace setae::file_figures {

/// Contributions of waves to the parameters of a surface: the shares of h_rms², h'_rms², h''_rms² and U_el of waves
/// longer than λ, against λ.
[[nodiscard]] StudyFigure parameter_figure(const study::SurfaceResult& surface, const Look& look);

}  // namespace setae::file_figures
