// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/core/table.hpp"

namespace setae::tables {

/// Constants that a file of force curves may lack; they replace values stated by the file.
struct ForceCurveOptions {
    std::optional<double> spring_constant;  ///< k of the cantilever [N/m], > 0
    std::optional<double> sensitivity;      ///< s of the deflection: [m/V], for NT-MDT [m/A], > 0
};

/// A sensitivity in SI, [m/V] or [m/A], from text with its unit such as "55 nm/V".
/// @throws InvalidArgument for text that is neither.
[[nodiscard]] double parse_sensitivity(std::string_view text);

/// A file format of force curves.
struct ForceCurveFormat {
    std::string identifier;  ///< "jpk-force", "jpk-force-map", "jpk-text", "nanoscope-force", "nanosurf-force" …
    std::string name;
    std::string extensions;
    std::string description;
    std::string reference;
    bool tested_on_real_files = false;
};

[[nodiscard]] const std::vector<ForceCurveFormat>& force_curve_formats();

/// The format of a source by its content; empty if it is no known force curve.
[[nodiscard]] std::optional<std::string> force_curve_format(const bytes::Source& source);

/// The format of a source if its header states it: excludes the text of NT-MDT, which can also contain heights.
[[nodiscard]] std::optional<std::string> stated_force_curve_format(const bytes::Source& source);

/// A force curve: approach, pause and retraction one after the other, in the order of the record.
///
///   force = k s (reading of the detector)      displacement = travel of the base − deflection
///
/// Columns: "force" [N], "displacement" [m] increasing into the sample, "height" [m] as in the file, "deflection" [m],
/// "reading" [V or A] of the detector, "time" [s] if the file states durations, "segment" [1] numbered from 0. Without
/// k there is no force, without k and s or deflection in metres no displacement: the columns are then as measured and
/// metadata["missing"] names the constants. metadata: "format", "spring_constant" [N/m] and "sensitivity" if known,
/// "segments" (their names), the lines of the file.
/// @throws FileError; FormatError with member, key or line for a truncated or damaged file, channels of different
/// length, an unknown scaling, a file of several curves (open_force_curves); InvalidArgument for k or s ≤ 0.
[[nodiscard]] Table read_force_curve(const bytes::Source& source, const ForceCurveOptions& options = {});
[[nodiscard]] Table read_force_curve(const std::string& path, const ForceCurveOptions& options = {});

}  // namespace setae::tables
