// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/adhesion/predicted_loop.hpp"
#include "setae/output/json.hpp"
#include "setae/study/contact_answers.hpp"
#include "setae/tables/tidy_table.hpp"

namespace setae::output {

/// W_app of contact without load, as every command answers: work_of_adhesion.
[[nodiscard]] Quantity recommended_quantity(const study::ContactAnswer& answer);

/// "recommended", "reason" and "theories" with each theory's name, title, assumption, work_of_adhesion and
/// area_fraction.
[[nodiscard]] Json to_json(const study::ContactAnswers& answers);

/// One row per theory: W_app [mJ/m²], area in contact [%], assumptions; the recommended one first and marked.
[[nodiscard]] tables::TidyTable theory_table(const study::ContactAnswers& answers);

/// One row per retraction model of a sphere: W_ret [mJ/m²], pull-off force and loss, and the pull-off force of the
/// model for a smooth sphere with that of JKR.
[[nodiscard]] tables::TidyTable retraction_table(const adhesion::PredictedLoop& loop);

}  // namespace setae::output
