// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/loops/loop.hpp"
#include "setae/simulation/calibrations.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::simulation {

/// Lengths as an instrument states them: true lengths, including tilts and noise, divided by its factors.
[[nodiscard]] topography::LineScan stated(topography::LineScan scan, const InstrumentCalibration& factors);
[[nodiscard]] topography::HeightMap stated(topography::HeightMap map, const InstrumentCalibration& factors);
[[nodiscard]] topography::Profile stated(topography::Profile contour, const InstrumentCalibration& factors);
[[nodiscard]] loops::Loop stated(loops::Loop loop, const Calibrations& factors);

}  // namespace setae::simulation
