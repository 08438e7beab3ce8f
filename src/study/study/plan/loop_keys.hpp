// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "keys.hpp"
#include "setae/study/study.hpp"

namespace setae::study {

/// Keys of [loops], which every experiment may hold for its own loop: how it is analysed, and what is fitted to it.
[[nodiscard]] const Keys<ExperimentInput>& loop_keys();

}  // namespace setae::study
