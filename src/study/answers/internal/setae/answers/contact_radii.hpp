// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "setae/answers/camera_pictures.hpp"
#include "setae/fields/option.hpp"
#include "setae/imaging/contact_radius.hpp"

namespace setae::answers {

/// Request of `setae jkr radius`: measurement of contact radii in the frames of a recording.
struct RadiusRequest : CameraPictures {
    std::string region, polarity = "automatic", reason;
    std::optional<double> micrometres_per_pixel;
    std::optional<long> first, last;
    std::vector<long> exclude;
    double smallest_radius = imaging::ContactFrameOptions{}.smallest_radius,
           min_confidence = imaging::ContactFrameOptions{}.min_confidence;
    bool ignore_stated_pixel_size = false;

    /// @throws InvalidArgument for a malformed text, and where the pixel's size is given twice.
    [[nodiscard]] imaging::FrameOptions frame_options() const;
    /// @throws InvalidArgument for frames left out without a reason.
    [[nodiscard]] imaging::RadiusOptions radius_options(parallel::Threads threads = {}) const;
};

}  // namespace setae::answers

template <>
struct setae::fields::Asked<setae::answers::RadiusRequest> {
    using R = answers::RadiusRequest;
    static constexpr std::array<std::string_view, 3> polarities{"automatic", "dark", "bright"};
    static constexpr std::array options{
        option<&R::micrometres_per_pixel>("um_per_px", "size of a pixel in micrometres").such_as("1.82").advanced(),
        option<&R::ignore_stated_pixel_size>("ignore_stated_pixel_size",
                                             "the given size of a pixel counts, even where a file states another")
            .advanced(),
        option<&R::first>("first", "number of the first frame that is analysed"),
        option<&R::last>("last", "number of the last frame that is analysed"),
        option<&R::region>("region", "part of the frames that is analysed: x,y,width,height in pixels")
            .such_as("100,80,320,240"),
        option<&R::polarity>("polarity", "grey level of the contact relative to the surroundings")
            .one_of(polarities)
            .default_shown(),
        option<&R::smallest_radius>("smallest_radius", "smallest radius of a contact, in pixels")
            .default_shown()
            .advanced(),
        option<&R::min_confidence>("min_confidence", "smallest confidence of a reported contact, from 0 to 1")
            .default_shown()
            .advanced(),
        option<&R::exclude>("exclude", "numbers of frames that are left out").such_as("12,17").separated_by(','),
        option<&R::reason>("reason", "reason why frames are left out").such_as("glare"),
    };
};
