// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/answers/json_schemas.hpp"
#include "setae/simulation/data_set.hpp"
#include "setae/simulation/projection_bias.hpp"
#include "setae/simulation/recording.hpp"
#include "setae/validation/contour_summary.hpp"
#include "setae/validation/law_recovery.hpp"
#include "setae/validation/loop_coverage.hpp"
#include "setae/validation/next_trials.hpp"
#include "setae/validation/record_trials.hpp"
#include "setae/validation/summary.hpp"
#include "setae/validation/true_area_of_maps.hpp"

namespace setae::validation {

/// JSON output of the commands `setae lab …` for answers::JsonSchemas. A table in a header, so that a program that only
/// describes these outputs contains nothing else of the laboratory.
inline constexpr answers::DescribedOutput described_outputs[]{
    {"lab area", &fields::Described<AreaOutput>::description},
    {"lab causes", &fields::Described<RecipeSummary>::of_causes},
    {"lab closure", &fields::Described<RecipeSummary>::description},
    {"lab contours", &fields::Described<ContoursOutput>::description},
    {"lab foil", &fields::Described<simulation::FoilOutput>::description},
    {"lab loops", &fields::Described<LoopsOutput>::description},
    {"lab loops", &fields::Described<MechanismsOutput>::description},
    {"lab make", &fields::Described<simulation::MakeOutput>::description},
    {"lab next", &fields::Described<NextOutput>::description},
    {"lab recording", &fields::Described<simulation::RecordingOutput>::description},
    {"lab records", &fields::Described<RecordsOutput>::description},
};

}  // namespace setae::validation
