// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "observed_groups.hpp"
#include "setae/core/quantity.hpp"

namespace setae::spectral_fit {

/// How much measurements of an instrument differ from each other as wholes.
struct PlaceScatter {
    double variance = 0.0;     ///< τ², of ln of the power at a place
    double probability = 1.0;  ///< of departures as large without any
    int measurements = 0;

    /// What τ² of n places is worth in a normal distribution whose 95 % interval is that of Student's t with n − 1
    /// degrees of freedom.
    [[nodiscard]] double normal_variance() const;
};

/// By instrument, for those with two measurements or more. b_m = Σ ν (P/E − 1)/Σ ν scatters by 1/√Σν about zero, and by
/// τ more where the surface is not the same everywhere. τ² makes Σ b²/(τ² + 1/Σν) equal to their number less the one
/// that the fit has followed (Paule and Mandel), 0 where it is less already.
using Scatter = std::map<std::string, PlaceScatter>;
[[nodiscard]] Scatter scatter_between_places(const std::vector<ObservedGroup>& groups, const WhittleFit& fit);

/// MEASUREMENTS_SCATTER where chance hardly does it.
[[nodiscard]] std::vector<Alert> scatter_alerts(const Scatter& scatter);

}  // namespace setae::spectral_fit
