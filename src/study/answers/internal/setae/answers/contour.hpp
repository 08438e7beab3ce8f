// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "setae/core/units.hpp"
#include "setae/fields/option.hpp"
#include "setae/imaging/micrograph.hpp"
#include "setae/output/contour_file.hpp"
#include "setae/study/contours.hpp"

namespace setae::answers {

/// Size of a pixel, "0.05 nm" or "0.05 nm x 0.1 nm". @throws InvalidArgument.
[[nodiscard]] imaging::PixelSize pixel_size_of(const std::string& text);

/// Options of a trace, and the picture that they belong to.
struct RepeatedTrace {
    study::ContourOptions options;
    bool is_whole = false;              ///< whether a stored trace is repeated with its own options
    std::optional<std::string> digest;  ///< of the picture of that trace

    /// @throws InvalidArgument where a whole trace is repeated on another picture.
    void require_picture(const study::TracedPicture& picture, const std::string& stored) const;
};

/// Request of `setae contour`: tracing of the contour in a micrograph.
struct ContourRequest {
    std::string vacuum = "automatic", shape = "envelope";
    std::string pixel, scale_bar, calibration, foil_thickness;
    std::vector<std::string> hidden;
    std::optional<double> smoothing, min_length;
    double denoise = 0;
    std::string image;
    bool ignore_stated = false, whole_picture = false;

    /// @throws InvalidArgument for malformed texts and a calibration given twice.
    [[nodiscard]] study::ContourOptions options() const;
    /// The options with the anchors of a file, or those of a whole trace in this file; without a file the options.
    /// @throws as options(); as output::read_trace(); InvalidArgument for a whole trace and options.
    [[nodiscard]] RepeatedTrace with_anchors(const std::string& file) const;
};

}  // namespace setae::answers

template <>
struct setae::fields::Asked<setae::answers::ContourRequest> {
    using R = answers::ContourRequest;
    static constexpr std::array options{
        option<&R::vacuum>("vacuum", "side of the picture that is vacuum, by grey level")
            .one_of(output::vacuum_words)
            .default_shown(),
        option<&R::shape>("shape",
                          "profile where the contour turns back: the highest point over each x, a cut, or the curve "
                          "itself (parametric)")
            .one_of(output::shape_words)
            .default_shown(),
        option<&R::pixel>("pixel", "size of a pixel, or width and height as \"1 nm x 0.2 nm\"")
            .read_by([](const std::string& text) { (void)answers::pixel_size_of(text); })
            .such_as("0.055 nm")
            .or_else("that of the file"),
        option<&R::scale_bar>("scale_bar", "length that the scale bar in the picture stands for")
            .of(positive(dimension::length))
            .such_as("5 nm"),
        option<&R::calibration>("calibration", "file of a calibration that was saved from another picture"),
        option<&R::ignore_stated>("ignore_stated_pixel_size",
                                  "pixel size or scale bar given hold even where the file contradicts them")
            .advanced(),
        option<&R::foil_thickness>("foil_thickness", "thickness of the sample along the beam")
            .of(positive(dimension::length))
            .such_as("20 nm"),
        option<&R::hidden>("hide",
                           "part of the picture without sample as x,y,width,height in pixels, given once per part")
            .such_as("0,900,300,124")
            .in_python("hidden"),
        option<&R::whole_picture>("whole_picture", "scale bars and text that are found are not hidden").advanced(),
        option<&R::smoothing>("smoothing", "length of the smoothing spline in pixels")
            .or_else("that of the smallest expected error")
            .advanced(),
        option<&R::denoise>("denoise", "standard deviation in pixels of a Gaussian that smooths the picture first")
            .default_shown()
            .advanced(),
        option<&R::min_length>("least_length", "shortest length in pixels of a segment that is kept")
            .or_else("50, of masks 0")
            .advanced(),
        option<&R::image>("image", "image of a file that holds several: a number, counted from 0, or a title")
            .or_else("the first that is no spectrum and no Fourier transform"),
    };
};
