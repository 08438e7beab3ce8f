// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/core/arrays.hpp"
#include "setae/core/constants.hpp"
#include "setae/tables/force_curve.hpp"
#include "setae/tables/force_map.hpp"

namespace setae::tables {

/// Quantity of the detector reading.
enum class Reading { volts, amperes, deflection, force };

/// One segment of a force curve, in SI.
struct ForceSegment {
    std::string name;  ///< "extend", "pause", "retract"
    Array1D height;    ///< [m] as in the file
    Array1D reading;
    double duration = 0.0;  ///< [s]; 0 if unknown
};

/// Common content of all formats.
struct ForceCurveData {
    std::vector<ForceSegment> segments;
    Reading reading = Reading::volts;
    double travel_sign = 1.0;  ///< travel of the base into the sample over height: −1 if heights decrease on approach
    ForceCurveOptions constants;
    double x = undefined, y = undefined;  ///< position [m]; NaN if unknown
    std::map<std::string, std::string> metadata;
};

/// A file of several force curves, opened.
struct ForceCurveFile {
    std::optional<MapGrid> grid;
    std::vector<long> numbers;                        ///< numbers of the curves
    std::function<ForceCurveData(long number)> read;  ///< from any thread
};

[[nodiscard]] bool is_jpk_force(const bytes::Source& source);
[[nodiscard]] ForceCurveData read_jpk_force(const bytes::Source& source);

/// Force maps and QI data.
[[nodiscard]] bool is_jpk_map(const bytes::Source& source);
[[nodiscard]] ForceCurveFile open_jpk_map(const bytes::Source& source);

/// Spectroscopy of Nanosurf: the number of curves is the number of lines of its channels.
[[nodiscard]] bool is_nanosurf_force(const bytes::Source& source);
[[nodiscard]] ForceCurveFile open_nanosurf_force(const bytes::Source& source);

/// Force curves and force volumes of Nanoscope (Bruker, Veeco, Digital Instruments).
[[nodiscard]] bool is_nanoscope_force(const bytes::Source& source);
[[nodiscard]] ForceCurveFile open_nanoscope_force(const bytes::Source& source);

/// Text exported by JPK data processing.
[[nodiscard]] bool is_jpk_text(const bytes::Source& source);
[[nodiscard]] ForceCurveFile open_jpk_text(const bytes::Source& source);

[[nodiscard]] bool is_afm_workshop(const bytes::Source& source);
[[nodiscard]] ForceCurveData read_afm_workshop(const bytes::Source& source);

[[nodiscard]] bool is_nt_mdt_text(const bytes::Source& source);
[[nodiscard]] ForceCurveData read_nt_mdt_text(const bytes::Source& source);

[[nodiscard]] bool is_igor_force(const bytes::Source& source);
[[nodiscard]] ForceCurveData read_igor_force(const bytes::Source& source);

}  // namespace setae::tables
