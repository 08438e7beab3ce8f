// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/imaging/micrograph.hpp"
#include "setae/imaging/scale_bar.hpp"

namespace setae::imaging {

/// Pixel size of a picture, with where it is from and how sure it is.
struct Calibration {
    PixelSize pixel_size;                  ///< [m]
    double relative_standard_error = 0.0;  ///< of both; 0 where the source is taken for exact
    std::string source;                    ///< "file: DM4 calibration", "scale bar 5 nm = 90.1 px", "given"
    std::optional<ScaleBar> scale_bar;     ///< where one was found
    std::vector<Alert>
        alerts;  ///< SCALE_BAR_UNCONFIRMED, SCALE_BAR_DISAGREES, SCALE_BAR_AMBIGUOUS, PIXEL_SIZE_DISAGREES
};

struct CalibrationOptions {
    std::optional<PixelSize> pixel_size;     ///< given by the user [m]
    std::optional<double> scale_bar_length;  ///< what the bar stands for, as the user confirms it [m]
    bool ignore_stated_pixel_size = false;   ///< go by option or bar even where the file contradicts it
};

/// The pixel size, in this order: given; the file's; the scale bar with the length given; the scale bar with the length
/// read.
///
/// Any two of these that are known are compared: a difference above 1 % and above three standard errors of the bar is
/// an error, unless ignore_stated_pixel_size. A bar whose label was read and that nothing confirms gives
/// SCALE_BAR_UNCONFIRMED with the words that confirm it (--scale-bar "5 nm"). Pixels of bars are square.
/// @throws InvalidArgument for sizes that contradict each other, no size at all (no bar, or a bar without a readable
/// label), a bar announced but not found, sizes that are not positive.
[[nodiscard]] Calibration calibrate(const Micrograph& micrograph, const CalibrationOptions& options = {});

/// Whether a calibration made with one picture may serve another: the size that its file states, and the one by its
/// scale bar where the label is read, differ from the calibration's by at most 1 % and three standard errors of the
/// bars. A picture that says nothing passes.
/// @throws InvalidArgument, which names the picture and both sizes.
void check_same_magnification(const Calibration& calibration, const Micrograph& micrograph);

}  // namespace setae::imaging
