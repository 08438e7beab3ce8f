// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "setae/imaging/calibration.hpp"
#include "setae/imaging/contour_trace.hpp"

namespace setae::imaging {

/// Additional elements of the overlay.
struct OverlayOptions {
    std::vector<PictureRegion> hidden;       ///< outlined
    std::optional<Calibration> calibration;  ///< its scale bar is marked from end to end
    std::vector<std::vector<Anchor>> anchors;
    long longest_side = 4000;  ///< larger pictures are reduced by averaging, small ones enlarged
};

/// The picture as PNG, from its 0.5th to its 99.5th percentile of grey, with segments in colour (that of the first
/// differs), anchors as rings, the scale bar and hidden regions, and levels and errors as text. The bytes depend only
/// on pixels and trace.
[[nodiscard]] std::string overlay_png(const FramePixels& pixels, const ContourTrace& trace,
                                      const OverlayOptions& options = {});

}  // namespace setae::imaging
