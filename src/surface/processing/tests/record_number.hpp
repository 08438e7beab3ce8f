// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "setae/processing/processed.hpp"

namespace setae::processing {

/// A number of a record by its name; the test fails if it is missing.
inline double number_of(const StepRecord& record, const std::string& name) {
    for (const auto& number : record.numbers)
        if (number.quantity == name) return number.estimate.value;
    ADD_FAILURE() << record.step << " records no " << name;
    return NAN;
}

inline const topography::HeightMap& map_of(const Processed& processed) {
    return std::get<topography::HeightMap>(processed.measurement);
}
inline const topography::LineScan& line_of(const Processed& processed) {
    return std::get<topography::LineScan>(processed.measurement);
}
inline const topography::Profile& profile_of(const Processed& processed) {
    return std::get<topography::Profile>(processed.measurement);
}

/// Sq of defined heights.
inline double rms_of(const Array2D& heights) {
    double sum = 0.0, squares = 0.0, count = 0.0;
    for (Index k = 0; k < heights.size(); ++k)
        if (heights.data()[k] == heights.data()[k]) {
            sum += heights.data()[k];
            count += 1.0;
        }
    for (Index k = 0; k < heights.size(); ++k)
        if (heights.data()[k] == heights.data()[k]) squares += std::pow(heights.data()[k] - sum / count, 2);
    return std::sqrt(squares / count);
}

}  // namespace setae::processing
