// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/loops/loop.hpp"
#include "setae/simulation/calibrations.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::simulation {

/// What an instrument states of true lengths: divided by its factors, whatever they are a part of, tilts and noise
/// included.
[[nodiscard]] topography::LineScan stated(topography::LineScan scan, const InstrumentCalibration& factors);
[[nodiscard]] topography::HeightMap stated(topography::HeightMap map, const InstrumentCalibration& factors);
[[nodiscard]] topography::Profile stated(topography::Profile contour, const InstrumentCalibration& factors);
[[nodiscard]] loops::Loop stated(loops::Loop loop, const Calibrations& factors);

}  // namespace setae::simulation
