// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "setae/topography/mask.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::reference {

/// Gaussian self-affine surfaces without fault: H of 0.3, 0.5, 0.7, 0.9 in turn, roll-off at an eighth of the size,
/// every other one sampled from a surface that has shorter waves than its points show.
[[nodiscard]] topography::HeightMap faultless_map(int number);  ///< 128², 1 µm
[[nodiscard]] topography::LineScan faultless_line(int number);  ///< 512 points, 4 µm

/// Points at least 5 apart (of lines 8), raised or lowered by ten times the rms of what a point departs from the median
/// around it.
struct TrueValues {
    topography::Measurement measurement;
    topography::Mask mask;
};
[[nodiscard]] TrueValues with_spikes(const topography::HeightMap& map, int count, std::uint64_t seed);
[[nodiscard]] TrueValues with_spikes(const topography::LineScan& scan, int count, std::uint64_t seed);

/// What a survey of surfaces came to.
struct Survey {
    int surfaces = 0;
    int alarmed = 0;                                            ///< surfaces with any finding
    std::map<std::string, int> codes;                           ///< of those findings
    int spikes_added = 0, spikes_found = 0, points_blamed = 0;  ///< blamed: found but not added
    [[nodiscard]] double alarm_share() const { return static_cast<double>(alarmed) / surfaces; }
    [[nodiscard]] double found_share() const { return static_cast<double>(spikes_found) / spikes_added; }
};
[[nodiscard]] Survey survey_maps(int surfaces);
[[nodiscard]] Survey survey_lines(int surfaces);

}  // namespace setae::reference
