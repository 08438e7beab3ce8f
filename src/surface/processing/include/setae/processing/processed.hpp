// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::processing {

/// Result of a step in numbers: the removed slope, the number of spikes.
struct StepRecord {
    std::string step;  ///< its name in pipeline files, such as "level_plane"
    std::vector<Quantity> numbers;
    std::vector<Alert> alerts;
};

/// A measurement after a step.
///
/// Every step of a pipeline is an aggregate with its parameters (LevelPlane, GaussianFilter …) and
///     Processed apply(const Step& step, topography::Measurement measurement, parallel::Threads threads = {});
/// which takes ownership of the measurement, so a map is changed in place if possible. A step that does not apply to a
/// kind of measurement throws InvalidArgument with step, measurement and alternative.
struct Processed {
    topography::Measurement measurement;
    StepRecord record;
};

/// Direction on a map: its scan lines run along x.
enum class Direction { x, y };

}  // namespace setae::processing
