// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/study/surface_analysis.hpp"

namespace setae::study {

/// Names of a measurement's uncertain inputs: that of the study file, "afm tip", which surfaces may share, or one of
/// the instrument on its surface, "tip radius of afm (10 nm), PUNCD". Empty without an error.
struct InputNames {
    std::string tip_radius;  ///< input of the reliable band of the average
    std::string probe_size;  ///< tip or foil in the likelihood
    std::string height_calibration, lateral_calibration;
};
[[nodiscard]] InputNames input_names(const MeasurementResult& measurement, const std::string& surface);
[[nodiscard]] InputNames input_names(const PreparedMeasurement& prepared, const std::string& surface);

/// Standard error over value; 0 without one.
[[nodiscard]] double relative_error(const Estimate& estimate);

}  // namespace setae::study
