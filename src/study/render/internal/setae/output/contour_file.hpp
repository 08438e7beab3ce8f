// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "setae/output/json.hpp"
#include "setae/study/contours.hpp"

namespace setae::output {

/// A trace as JSON: settings that reproduce it to the last bit, and its results.
///
///   {"format": "setae trace", "version": 1, "image": {file, sha256, width, height, format, image}, "calibration": {…},
///    "options": {vacuum, smoothing_length, denoise, min_length, hidden, hide_annotations, shape, foil_thickness},
///    "anchors": [[[x, y], …], …], "segments": [{…}], "alerts": […], "setae": version}
///
/// Positions in pixels, the centre of the first one (0, 0), x to the right, y downwards; lengths in options in pixels,
/// foil_thickness and all of the calibration in metres.
[[nodiscard]] Json to_json(const study::TracedPicture& picture, const study::ContourOptions& options);

/// Content of a trace's file or of a file with anchors only.
struct StoredTrace {
    std::vector<std::vector<imaging::Anchor>> anchors;
    std::optional<std::string> digest;             ///< digest of the picture; empty for a file with anchors only
    std::optional<study::ContourOptions> options;  ///< with anchors and the calibration as a shared one
};

/// Reads it: a trace as above, {"anchors": [[x, y], …]} for one segment, or {"anchors": [[[x, y], …], …]}.
/// @throws FileError; FormatError that names the key: no JSON, another format or version, an unknown key with its
/// nearest match, values of the wrong kind.
[[nodiscard]] StoredTrace read_trace(const std::string& path);

/// "bright" …; the words of options.
[[nodiscard]] std::string to_string(imaging::Vacuum vacuum);
[[nodiscard]] std::string to_string(study::ContourShape shape);
/// @throws InvalidArgument that lists the words.
[[nodiscard]] imaging::Vacuum vacuum_from_name(const std::string& name);
[[nodiscard]] study::ContourShape shape_from_name(const std::string& name);

}  // namespace setae::output
