// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "setae/output/json.hpp"

namespace setae::output {

/// Adds the JSON Schema of a study's results, "study_results", and those of all named parts of it.
void add_study_schemas(std::map<std::string, Json>& schemas);

}  // namespace setae::output
