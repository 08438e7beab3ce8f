// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/imaging/micrograph.hpp"
#include "setae/imaging/scale_bar.hpp"

namespace setae::imaging {

/// Pixel size of a picture, its origin and its standard error.
struct Calibration {
    PixelSize pixel_size;                  ///< [m]
    double relative_standard_error = 0.0;  ///< of both; 0 if the source is exact
    std::string source;                    ///< "file: DM4 calibration", "scale bar 5 nm = 90.1 px", "given"
    std::optional<ScaleBar> scale_bar;     ///< if a scale bar was found
    std::vector<Alert>
        alerts;  ///< SCALE_BAR_UNCONFIRMED, SCALE_BAR_DISAGREES, SCALE_BAR_AMBIGUOUS, PIXEL_SIZE_DISAGREES
};

struct CalibrationOptions {
    std::optional<PixelSize> pixel_size;     ///< given by the user [m]
    std::optional<double> scale_bar_length;  ///< length of the scale bar, confirmed by the user [m]
    bool ignore_stated_pixel_size = false;   ///< use the given size or the bar even if the file contradicts it
};

/// The pixel size, in this order: given; stated by the file; the scale bar with the given length; the scale bar with
/// the length read.
///
/// Any two of these that are known are compared: a difference above 1 % and above three standard errors of the bar is
/// an error, unless ignore_stated_pixel_size. A bar whose label was read and not confirmed gives SCALE_BAR_UNCONFIRMED
/// with the option that confirms it (--scale-bar "5 nm"). Pixels of bars are square.
/// @throws InvalidArgument for sizes that contradict each other, no size at all (no bar, or a bar without a readable
/// label), a bar announced but not found, sizes that are not positive.
[[nodiscard]] Calibration calibrate(const Micrograph& micrograph, const CalibrationOptions& options = {});

/// Checks whether a calibration made with one picture applies to another: the size stated by its file, and that from
/// its scale bar with a label that can be read, differ from the calibration by at most 1 % and three standard errors of
/// the bars. A picture without either passes.
/// @throws InvalidArgument with the names of the picture and both sizes.
void check_same_magnification(const Calibration& calibration, const Micrograph& micrograph);

}  // namespace setae::imaging
