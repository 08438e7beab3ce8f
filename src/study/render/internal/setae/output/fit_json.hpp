// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/loops/crack_speed_fit.hpp"
#include "setae/loops/force_curve_fit.hpp"
#include "setae/loops/global_fit.hpp"
#include "setae/loops/model_fits.hpp"
#include "setae/loops/profile_likelihood.hpp"
#include "setae/loops/range_scan.hpp"
#include "setae/output/json.hpp"
#include "setae/study/loop_models.hpp"

/// Fits of contact models as JSON: quantities as to_json(Quantity) has them, curves as lists of numbers in SI.
namespace setae::output {

[[nodiscard]] Json to_json(const loops::ModelFit& fit);

/// "models", each with its fit or the reason, "best", "sentence".
[[nodiscard]] Json to_json(const loops::ModelComparison& comparison);

[[nodiscard]] Json to_json(const loops::GlobalFit& fit);
[[nodiscard]] Json to_json(const loops::CrackSpeedFit& fit);
[[nodiscard]] Json to_json(const std::vector<loops::NamedCurveFit>& segments);

/// "contact_modulus", "work_of_adhesion": the estimate with the profile's interval, "values", "chi_squared_rise",
/// "threshold".
[[nodiscard]] Json to_json(const loops::ProfileLikelihood& profile);

/// "fits", "comparison", "profile_likelihood", "crack_speed", "failures", each on request.
[[nodiscard]] Json to_json(const study::LoopModels& models);

/// "by_start", "by_end", "slope", "ellipse_slope".
[[nodiscard]] Json to_json(const loops::RangeScan& scan);

}  // namespace setae::output
