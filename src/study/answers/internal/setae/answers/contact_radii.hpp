// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/imaging/contact_radius.hpp"
#include "setae/output/json.hpp"

namespace setae::answers {

/// How contact radii are measured in the frames of a recording, as `setae jkr radius` is told.
struct RadiusRequest {
    std::string pixel, region;                              ///< "1.82 um"; "x,y,width,height" in pixels
    std::string polarity = "automatic";                     ///< "dark", "bright"
    std::string reason;                                     ///< why frames are left out
    std::optional<double> micrometres_a_pixel, frame_rate;  ///< frame_rate: [1/s]
    std::optional<long> first, last;                        ///< numbers of frames
    std::vector<long> exclude;
    double smallest_radius = imaging::ContactFrameOptions{}.smallest_radius,
           least_confidence = imaging::ContactFrameOptions{}.least_confidence;
    bool fringes = false, ignore_stated_pixel_size = false;

    /// @throws InvalidArgument for a malformed text, and where the pixel's size is given twice.
    [[nodiscard]] imaging::FrameOptions frame_options() const;
    /// @throws InvalidArgument for frames left out without a reason.
    [[nodiscard]] imaging::RadiusOptions radius_options(parallel::Threads threads = {}) const;
};

/// "pixel_size", "frame_rate", "polarity", "summary", "notes" and "frames".
[[nodiscard]] output::Json to_json(const imaging::ContactRadii& radii);

}  // namespace setae::answers
