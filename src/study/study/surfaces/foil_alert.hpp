// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/core/quantity.hpp"

namespace setae::study {

/// FOIL_PROJECTION: the projection of a foil is its silhouette; the effects are measured in
/// docs/concepts/tem-projection.md. thickness: along the beam [m], > 0.
[[nodiscard]] Alert foil_projection_alert(const std::string& subject, double thickness);

}  // namespace setae::study
