// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/imaging/frames.hpp"

namespace setae::imaging {

/// A scale bar drawn into a picture. Lengths in pixels, coordinates as FramePixels.
struct ScaleBar {
    double begin_x = 0, end_x = 0;  ///< edges of the bar (the first pixel begins at −0.5); the middles of the lines if
                                    ///< the bar has an outline, or equal ticks at both ends
    double y = 0, thickness = 0;  ///< of its middle; thickness of the bar without ornaments at its ends
    double length = 0;            ///< end_x − begin_x
    double length_standard_error = 0;
    std::string label;                      ///< as read, such as "5 nm", possibly wrong; empty if none is legible
    std::optional<double> labelled_length;  ///< [m]; empty if the label is no length or the reading is doubtful
    PictureRegion annotation;               ///< bar, label and their surroundings: not part of the sample
    double confidence = 0;                  ///< in [0, 1]
};

/// Scale bars of a picture, best first: long uniform horizontal runs of one grey level (black, white, outlined, or with
/// ticks at their ends) with straight ends, separate from their surroundings, and the text nearby. Depends only on the
/// pixels. Reads labels by Tesseract.
[[nodiscard]] std::vector<ScaleBar> find_scale_bars(const FramePixels& pixels);

/// Parts of a picture that are no image of the sample: bars with their labels, data bars along an edge, text. Hidden
/// parts are not traced.
[[nodiscard]] std::vector<PictureRegion> annotations(const FramePixels& pixels);

}  // namespace setae::imaging
