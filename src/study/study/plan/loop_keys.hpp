// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "keys.hpp"
#include "setae/study/study.hpp"

namespace setae::study {

/// Keys of [loops], which every experiment may contain for its own loop: analysis, and models that are fitted.
[[nodiscard]] const Keys<ExperimentInput>& loop_keys();

}  // namespace setae::study
