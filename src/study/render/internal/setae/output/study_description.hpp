// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/fields/row.hpp"

namespace setae::output {

/// Fields of a study's results, as in study.json.
extern const fields::Description study_description;

}  // namespace setae::output
