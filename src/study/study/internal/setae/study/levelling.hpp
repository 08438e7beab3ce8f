// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "setae/processing/pipeline.hpp"
#include "setae/topography/detrend.hpp"

namespace setae::study {

/// What may say how heights are levelled, the strongest first.
struct LevellingAsked {
    std::optional<topography::Trend> given;        ///< by the user
    std::optional<topography::Trend> recommended;  ///< by the file
    std::string instrument;                        ///< "stylus", "afm", "tem", "optical"; empty where unknown
};

/// What is subtracted from measured heights after a pipeline.
///
/// The trend that was given; without it nothing after a pipeline that levels (a step level_… other than level_mean),
/// else the file's, else a parabola of a stylus and a tilt of everything else. Source: [D19], supplement: stylus
/// parabola, AFM and TEM tilt.
[[nodiscard]] topography::Trend trend_after(const processing::Pipeline& pipeline, const LevellingAsked& asked);

}  // namespace setae::study
