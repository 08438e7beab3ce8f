// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/imaging/frames.hpp"

namespace setae::imaging {

/// A scale bar drawn into a picture. Lengths in pixels, places as FramePixels.
struct ScaleBar {
    double begin_x = 0, end_x = 0;  ///< edges of the bar (the first pixel begins at −0.5); where it has an outline, or
                                    ///< like ticks at both ends, their middles
    double y = 0, thickness = 0;  ///< of its middle; of the bar without ornaments at its ends
    double length = 0;            ///< end_x − begin_x
    double length_standard_error = 0;
    std::string label;                      ///< as read, such as "5 nm", right or not; empty where none is legible
    std::optional<double> labelled_length;  ///< [m]; nothing where the label is no length or its reading is in doubt
    PictureRegion annotation;               ///< bar, label and their surroundings: no picture of the sample
    double confidence = 0;                  ///< in [0, 1]
};

/// Scale bars of a picture, best first: long uniform horizontal runs of one grey level (black, white, outlined, or with
/// ticks at their ends) with straight ends, apart from what surrounds them, and the text nearby. Depends on the pixels
/// alone. Reads labels by Tesseract.
[[nodiscard]] std::vector<ScaleBar> find_scale_bars(const FramePixels& pixels);

/// Parts of a picture that are no image of the sample: bars with their labels, bars of data along an edge, text.
/// What is hidden by them is not traced.
[[nodiscard]] std::vector<PictureRegion> annotations(const FramePixels& pixels);

}  // namespace setae::imaging
