// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/study/study_result.hpp"

namespace setae::study {

/// What a loop loses [J] whose edge needs W_app on its way in and W_ret all the way out, and its largest contact area.
struct LossOfWorks {
    TracedValue energy;         ///< [J]
    double contact_area = 0.0;  ///< π a_max² [m²]
};

/// Of the elastomer's sphere under its preload; nothing where one of the two, or W_app > 0, is not known. W_ret below
/// W_app counts as W_app.
/// Source: hysteresis::sphere_loop().
[[nodiscard]] std::optional<LossOfWorks> loss_of_works(const ElastomerResult& elastomer, const TracedValue& approach,
                                                       const TracedValue& retraction);

/// Alerts of references and pairs whose loss is not what their own works would lose, by three standard errors and a
/// fifth: LOSS_CONTRADICTS_WORKS. Of the works read at pull-off one is then not that of the whole retraction.
void compare_losses_with_works(StudyResult& result);

/// Loss per true area [J/m²] of loops with the measured works: least squares of E_loss against A_true = α r π a_max²
/// through the origin, all pairs alike; nothing for fewer than two.
[[nodiscard]] std::optional<LossSlope> loss_slope_of_works(const StudyResult& result);

}  // namespace setae::study
