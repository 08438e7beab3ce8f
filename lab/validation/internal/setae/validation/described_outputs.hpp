// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "setae/answers/json_schemas.hpp"
#include "setae/validation/summary.hpp"
#include "setae/validation/true_area_of_maps.hpp"

namespace setae::validation {

/// JSON output of the commands `setae lab …` for answers::JsonSchemas. A table in a header, so that a program that only
/// describes these outputs contains nothing else of the laboratory.
inline constexpr std::array described_outputs{
    answers::DescribedOutput{.command = "lab area", .description = &fields::Described<AreaOutput>::description},
    answers::DescribedOutput{.command = "lab causes", .description = &fields::Described<RecipeSummary>::of_causes},
};

}  // namespace setae::validation
