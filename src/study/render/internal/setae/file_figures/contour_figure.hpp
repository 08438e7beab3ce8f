// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "setae/file_figures/look.hpp"
#include "setae/study/contours.hpp"

namespace setae::file_figures {

/// Profiles of the segments traced in a picture, counted from 0, each with the 95 % band of its heights; of
/// ContourShape::parametric the curve itself.
[[nodiscard]] StudyFigure contour_figure(const study::TracedPicture& picture, const std::vector<std::size_t>& segments,
                                         study::ContourShape shape, const Look& look);

}  // namespace setae::file_figures
