// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/file_figures/look.hpp"
#include "setae/processing/pipeline.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::file_figures {

/// Heights before and after processing, from their mean: maps with colour bars, undefined points white, lines over x.
///
/// Maps are drawn with at most 256 cells per side, each the mean of its defined pixels.
[[nodiscard]] StudyFigure level_figure(const topography::Measurement& before, const processing::PipelineResult& after,
                                       const Look& look);

}  // namespace setae::file_figures
