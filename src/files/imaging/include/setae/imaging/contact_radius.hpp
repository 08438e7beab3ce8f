// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/core/table.hpp"
#include "setae/imaging/contact_frame.hpp"
#include "setae/imaging/frames.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::imaging {

/// A frame excluded by the user.
struct ExcludedFrame {
    long number = 0;  ///< see FrameSource::number
    std::string reason;
};

struct RadiusOptions {
    ContactFrameOptions frame;
    std::vector<ExcludedFrame> excluded;
    parallel::Threads threads;
};

/// Result of one frame with number, time and SI lengths.
struct ContactRadius {
    long number = 0;
    std::string name;
    double time = 0;                        ///< [s]
    double radius = 0, standard_error = 0;  ///< [m]
    ContactFrame contact;                   ///< [px] of the whole frame
};

/// Number of frames per result.
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
    std::vector<std::string> notes;  ///< on the source and on the frames
};

/// Contact radius in every frame of a recording.
///
/// Frames are measured separately, in parallel: results depend neither on neighbours nor on the number of threads. If
/// the polarity is automatic, frames that differ from the majority (weighted by confidence) are measured again with it.
/// @throws InvalidArgument if no pixel size is known or an excluded frame is not in the recording or has no reason;
/// also as measure_contact_frame.
[[nodiscard]] ContactRadii measure_contact_radii(const FrameSource& source, const RadiusOptions& options = {});

/// Columns time [s], contact_radius [m], contact_radius_standard_error [m], frame, semi_major [m], semi_minor [m],
/// roundness, confidence, agreeing_rays, visible_share, contrast_to_noise, centre_x [m], centre_y [m], state (the
/// number of FrameState); one row per frame, NaN for missing values. Input of tables::merged_by_time as the table of a
/// camera.
[[nodiscard]] Table as_table(const ContactRadii& radii);

/// as_table as CSV below "# key: value" lines: results of the whole recording, and "# frame 12: excluded: glare" for
/// every frame without a radius or with a warning.
[[nodiscard]] std::string as_csv(const ContactRadii& radii);

/// "measured", "no contact", "not found", "bad frame", "excluded".
[[nodiscard]] std::string to_string(FrameState state);
[[nodiscard]] std::string to_string(Polarity polarity);

/// Writes frame `index` of the source as PNG with the edge in colour, a cross at its centre, and number, state, radius
/// and confidence as text; small frames are enlarged. A frame that cannot be read gives text only.
/// @throws FileError.
void write_overlay(const std::string& path, const FrameSource& source, std::size_t index, const ContactRadius& found);

}  // namespace setae::imaging
