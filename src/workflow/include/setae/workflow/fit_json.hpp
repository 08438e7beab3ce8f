// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/experiment/crack_speed_fit.hpp"
#include "setae/experiment/force_curve_fit.hpp"
#include "setae/experiment/global_fit.hpp"
#include "setae/experiment/model_fits.hpp"
#include "setae/experiment/profile_likelihood.hpp"
#include "setae/experiment/range_scan.hpp"
#include "setae/workflow/json.hpp"
#include "setae/workflow/loop_models.hpp"

/// Fits of contact models as JSON: quantities as to_json(Quantity) has them, curves as lists of numbers in SI.
namespace setae::workflow {

[[nodiscard]] Json to_json(const experiment::ModelFit& fit);

/// "models", each with its fit or the reason, "best", "sentence".
[[nodiscard]] Json to_json(const experiment::ModelComparison& comparison);

[[nodiscard]] Json to_json(const experiment::GlobalFit& fit);
[[nodiscard]] Json to_json(const experiment::CrackSpeedFit& fit);
[[nodiscard]] Json to_json(const std::vector<experiment::NamedCurveFit>& segments);

/// "contact_modulus", "work_of_adhesion": the estimate with the profile's interval, "values", "chi_squared_rise", "threshold".
[[nodiscard]] Json to_json(const experiment::ProfileLikelihood& profile);

/// "fits", "comparison", "profile_likelihood", "crack_speed", "failures", each where it was asked for.
[[nodiscard]] Json to_json(const LoopModels& models);

/// "by_start", "by_end", "slope", "ellipse_slope".
[[nodiscard]] Json to_json(const experiment::RangeScan& scan);

}  // namespace setae::workflow
