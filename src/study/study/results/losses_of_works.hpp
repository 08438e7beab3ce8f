// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/study/study_result.hpp"

namespace setae::study {

/// Energy loss of a loop [J] with W_app on approach and W_ret on retraction, and its largest contact area.
struct LossOfWorks {
    TracedValue energy;         ///< [J]
    double contact_area = 0.0;  ///< π a_max² [m²]
};

/// For the elastomer's sphere under its preload; empty where one of the two, or W_app > 0, is unknown. W_ret below
/// W_app is set to W_app.
/// Source: hysteresis::sphere_loop().
[[nodiscard]] std::optional<LossOfWorks> loss_of_works(const ElastomerResult& elastomer, const TracedValue& approach,
                                                       const TracedValue& retraction);

/// Warnings for references and pairs whose loss differs from that of their own works by more than three standard errors
/// and a fifth: LOSS_CONTRADICTS_WORKS. One of the works at pull-off is then not that of the whole retraction.
void compare_losses_with_works(StudyResult& result);

/// Loss per true area [J/m²] of loops with the measured works: least squares of E_loss against A_true = α r π a_max²
/// through the origin, with equal weights; empty for fewer than two.
[[nodiscard]] std::optional<LossSlope> loss_slope_of_works(const StudyResult& result);

}  // namespace setae::study
