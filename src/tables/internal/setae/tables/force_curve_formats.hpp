// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/core/arrays.hpp"
#include "setae/tables/force_curve.hpp"

namespace setae::tables {

/// What a detector's reading is.
enum class Reading { volts, amperes, deflection, force };

/// One stretch of a force curve, in SI.
struct ForceSegment {
    std::string name;  ///< "extend", "pause", "retract"
    Array1D height;    ///< [m] as the file has it
    Array1D reading;
    double duration = 0.0;  ///< [s]; 0 where the file does not tell
};

/// What every format comes down to.
struct ForceCurveData {
    std::vector<ForceSegment> segments;
    Reading reading = Reading::volts;
    double travel_sign = 1.0;  ///< travel of the base into the sample over height: −1 where heights fall on approach
    ForceCurveOptions constants;
    std::map<std::string, std::string> metadata;
};

[[nodiscard]] bool is_jpk_force(const bytes::Source& source);
[[nodiscard]] ForceCurveData read_jpk_force(const bytes::Source& source);

[[nodiscard]] bool is_afm_workshop(const bytes::Source& source);
[[nodiscard]] ForceCurveData read_afm_workshop(const bytes::Source& source);

[[nodiscard]] bool is_nt_mdt_text(const bytes::Source& source);
[[nodiscard]] ForceCurveData read_nt_mdt_text(const bytes::Source& source);

[[nodiscard]] bool is_igor_force(const bytes::Source& source);
[[nodiscard]] ForceCurveData read_igor_force(const bytes::Source& source);

}  // namespace setae::tables
