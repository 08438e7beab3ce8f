// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "observed_groups.hpp"
#include "setae/core/quantity.hpp"

namespace setae::spectral_fit {

/// Agreement of each instrument with the fit, by decade, over the groups of modes used in the fit.
[[nodiscard]] std::vector<Agreement> agreement(const std::vector<ObservedGroup>& groups, const WhittleFit& fit);

/// INSTRUMENTS_DISAGREE for rows that chance does not explain.
[[nodiscard]] std::vector<Alert> agreement_alerts(const std::vector<Agreement>& rows);

}  // namespace setae::spectral_fit
