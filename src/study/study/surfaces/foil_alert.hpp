// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/core/quantity.hpp"

namespace setae::study {

/// FOIL_PROJECTION: a side view of a foil is its silhouette; what that costs is measured in
/// docs/concepts/tem-projection.md. thickness: along the beam [m], > 0.
[[nodiscard]] Alert foil_projection_alert(const std::string& subject, double thickness);

}  // namespace setae::study
