// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/topography/measurement.hpp"

namespace setae::topography {

/// The ny line scans along x (the fast axis) of a map.
[[nodiscard]] std::vector<LineScan> line_scans(const HeightMap& map);

/// The polyline through the points of a scan, x from 0 to (n − 1) steps; undefined points are left out.
[[nodiscard]] Profile to_profile(const LineScan& scan);

/// A scan with equal steps from points on a regular grid to within 2 % of a step (files round their x); otherwise
/// empty. Empty also for a profile with standard errors or the response of its trace, which scans cannot store.
[[nodiscard]] std::optional<LineScan> to_line_scan(const Profile& profile);

}  // namespace setae::topography
