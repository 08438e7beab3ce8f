// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/core/table.hpp"
#include "setae/imaging/contact_frame.hpp"
#include "setae/imaging/frames.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::imaging {

/// A frame left out by the user.
struct ExcludedFrame {
    long number = 0;  ///< as FrameSource::number
    std::string reason;
};

struct RadiusOptions {
    ContactFrameOptions frame;
    std::vector<ExcludedFrame> excluded;
    parallel::Threads threads;
};

/// What a frame gave, with number, time and SI lengths.
struct ContactRadius {
    long number = 0;
    std::string name;
    double time = 0;                        ///< [s]
    double radius = 0, standard_error = 0;  ///< [m]
    ContactFrame contact;                   ///< [px] of the whole frame
};

/// How many frames gave what.
struct RadiusSummary {
    std::size_t frames = 0, measured = 0, no_contact = 0, not_found = 0, bad = 0, excluded = 0, partial = 0,
                missing = 0;
};

/// Contact radii of a recording.
struct ContactRadii {
    double pixel_size = 0;                    ///< [m]
    double frame_rate = 0;                    ///< [1/s]
    Polarity polarity = Polarity::automatic;  ///< of most frames
    std::vector<ContactRadius> frames;        ///< in order of time
    RadiusSummary summary;
    std::vector<std::string> notes;  ///< of the source and on the frames
};

/// Contact radius in every frame of a recording.
///
/// Frames are measured each by itself, in parallel: results depend neither on neighbours nor on the number of threads.
/// Where the polarity is automatic, frames that differ from the majority (weighted by confidence) are measured again
/// with it.
/// @throws InvalidArgument where no pixel size is known, an excluded frame is not in the recording or has no reason,
/// and as measure_contact_frame.
[[nodiscard]] ContactRadii measure_contact_radii(const FrameSource& source, const RadiusOptions& options = {});

/// Columns time [s], contact_radius [m], contact_radius_standard_error [m], frame, semi_major [m], semi_minor [m],
/// roundness, confidence, agreeing_rays, visible_share, contrast_to_noise, centre_x [m], centre_y [m], state (the
/// number of FrameState); one row a frame, NaN where there is nothing. What tables::merged_by_time takes as the table
/// of a camera.
[[nodiscard]] Table as_table(const ContactRadii& radii);

/// as_table as CSV below "# key: value" lines: what the whole gave, and "# frame 12: excluded: glare" for every frame
/// that has no radius or a remark on it.
[[nodiscard]] std::string as_csv(const ContactRadii& radii);

/// "measured", "no contact", "not found", "bad frame", "excluded".
[[nodiscard]] std::string to_string(FrameState state);
[[nodiscard]] std::string to_string(Polarity polarity);

/// Writes frame `index` of the source as PNG with the edge that was found drawn in colour, a cross at its centre, and
/// number, state, radius and confidence in words; small frames are enlarged. A frame that cannot be read gives words
/// alone.
/// @throws FileError.
void write_overlay(const std::string& path, const FrameSource& source, std::size_t index, const ContactRadius& found);

}  // namespace setae::imaging
