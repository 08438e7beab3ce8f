// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::processing {

/// What a step did, in the numbers a reader wants: the slope that was removed, how many spikes.
struct StepRecord {
    std::string step;  ///< its name in pipeline files, such as "level_plane"
    std::vector<Quantity> numbers;
    std::vector<Alert> alerts;
};

/// A measurement after a step.
///
/// Every step of a pipeline is an aggregate with its parameters (LevelPlane, GaussianFilter …) and
///     Processed apply(const Step& step, topography::Measurement measurement, parallel::Threads threads = {});
/// which takes the measurement over, so that a map is changed in place where that is possible. A step that has no
/// meaning for a kind of measurement throws InvalidArgument that names step and measurement and says what to do
/// instead.
struct Processed {
    topography::Measurement measurement;
    StepRecord record;
};

/// Which way along a map: its scan lines run along x.
enum class Direction { x, y };

}  // namespace setae::processing
