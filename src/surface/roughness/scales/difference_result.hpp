// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/scales/scale_dependent.hpp"

namespace setae::scales {

/// Moments of differences at one distance.
struct DifferenceMoments {
    double distance = 0.0;
    double count = 0.0;  ///< or length
    double origin = 0.0;
    double powers[4] = {0.0, 0.0, 0.0, 0.0};  ///< Σ (d − origin)^k, k = 1 … 4
    double minimum = 0.0, maximum = 0.0;
};

/// Statistics at the given distances.
/// @throws InvalidArgument without a distance.
[[nodiscard]] DifferenceStatistics statistics_of(const std::vector<DifferenceMoments>& moments,
                                                 const DifferenceOptions& options,
                                                 const topography::Metadata& metadata);

/// @throws InvalidArgument for an order outside 1 … 3, order 3 along both, or a distance that is not positive.
void require_differences(const DifferenceOptions& options, const topography::Metadata& metadata);

}  // namespace setae::scales
