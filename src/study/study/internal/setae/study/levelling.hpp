// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "setae/processing/pipeline.hpp"
#include "setae/topography/detrend.hpp"

namespace setae::study {

/// Sources of the levelling of heights, the strongest first.
struct LevellingAsked {
    std::optional<topography::Trend> given;        ///< given by the user
    std::optional<topography::Trend> recommended;  ///< recommended by the file
    std::string instrument;                        ///< "stylus", "afm", "tem", "optical"; empty where unknown
};

/// Trend that is subtracted from measured heights after a pipeline.
///
/// The given trend; without it none after a pipeline that levels (a step level_… other than level_mean), else that of
/// the file, else a parabola for a stylus and a tilt for all other instruments. Source: [D19], supplement: stylus
/// parabola, AFM and TEM tilt.
[[nodiscard]] topography::Trend trend_after(const processing::Pipeline& pipeline, const LevellingAsked& asked);

}  // namespace setae::study
