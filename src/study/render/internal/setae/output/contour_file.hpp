// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/study/contours.hpp"

namespace setae::output {

/// Format and version that a trace's file states.
inline constexpr std::string_view trace_format = "setae trace";
inline constexpr int trace_version = 1;

/// Words of options, in the order of the enumerators.
inline constexpr std::array<std::string_view, 3> vacuum_words{"automatic", "bright", "dark"};
inline constexpr std::array<std::string_view, 3> shape_words{"envelope", "cut", "parametric"};

/// Content of a trace's file or of a file with anchors only.
struct StoredTrace {
    std::vector<std::vector<imaging::Anchor>> anchors;
    std::optional<std::string> digest;             ///< digest of the picture; empty for a file with anchors only
    std::optional<study::ContourOptions> options;  ///< with anchors and the calibration as a shared one
};

/// Reads it: a trace (contour_fields.hpp), {"anchors": [[x, y], …]} for one segment, or {"anchors": [[[x, y], …], …]}.
/// @throws FileError; FormatError that names the key: no JSON, another format or version, an unknown key with its
/// nearest match, values of the wrong kind.
[[nodiscard]] StoredTrace read_trace(const std::string& path);

[[nodiscard]] std::string to_string(imaging::Vacuum vacuum);
[[nodiscard]] std::string to_string(study::ContourShape shape);
/// @throws InvalidArgument that lists the words.
[[nodiscard]] imaging::Vacuum vacuum_from_name(const std::string& name);
[[nodiscard]] study::ContourShape shape_from_name(const std::string& name);

}  // namespace setae::output
