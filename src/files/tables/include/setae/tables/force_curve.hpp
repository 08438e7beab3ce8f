// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/core/table.hpp"

namespace setae::tables {

/// What a file of force curves may not say itself; where it does, these overrule it.
struct ForceCurveOptions {
    std::optional<double> spring_constant;  ///< k of the cantilever [N/m], > 0
    std::optional<double> sensitivity;      ///< s of the deflection: [m/V], of NT-MDT [m/A], > 0
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

/// The format of a source by its content; nothing where it is no force curve setae reads.
[[nodiscard]] std::optional<std::string> force_curve_format(const bytes::Source& source);

/// The same of formats that say in their header what they are: not the text of NT-MDT, which may as well be heights.
[[nodiscard]] std::optional<std::string> stated_force_curve_format(const bytes::Source& source);

/// A force curve: approach, pause and retraction one after the other, in the order of the record.
///
///   force = k s (reading of the detector)      displacement = travel of the base − deflection
///
/// Columns: "force" [N], "displacement" [m] growing into the sample, "height" [m] as the file has it, "deflection" [m],
/// "reading" [V or A] of the detector, "time" [s] where the file tells durations, "segment" [1] numbered from 0.
/// Without k there is no force, without k and s or deflection in metres no displacement: then the columns stand as
/// measured and metadata["missing"] names the constants. metadata: "format", "spring_constant" [N/m] and "sensitivity"
/// where known, "segments" (their names), the file's own lines.
/// @throws FileError; FormatError with member, key or line for a truncated or damaged file, channels of different
/// length, an unknown scaling, a file of several curves (open_force_curves); InvalidArgument for k or s ≤ 0.
[[nodiscard]] Table read_force_curve(const bytes::Source& source, const ForceCurveOptions& options = {});
[[nodiscard]] Table read_force_curve(const std::string& path, const ForceCurveOptions& options = {});

}  // namespace setae::tables
