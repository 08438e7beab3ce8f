// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "setae/imaging/micrograph.hpp"
#include "setae/study/contours.hpp"

namespace setae::answers {

/// Size of a pixel, "0.05 nm" or "0.05 nm x 0.1 nm". @throws InvalidArgument.
[[nodiscard]] imaging::PixelSize pixel_size_of(const std::string& text);

/// How the contour in a micrograph is traced, as `setae contour` is told.
struct ContourRequest {
    std::string vacuum = "automatic", shape = "envelope";
    std::string pixel, scale_bar, calibration, foil_thickness;  ///< calibration: a file
    std::vector<std::string> hidden;                            ///< "x,y,width,height" in pixels
    std::optional<double> smoothing, least_length;              ///< [px]
    double denoise = 0;                                         ///< [px]
    std::string image;  ///< of a file of several: its number, counted from 0, or its title; empty: the first picture
    bool ignore_stated = false, whole_picture = false;

    /// @throws InvalidArgument for malformed texts and a calibration given twice.
    [[nodiscard]] study::ContourOptions options() const;
};

}  // namespace setae::answers
