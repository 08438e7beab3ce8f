// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "setae/study/study_result.hpp"

namespace setae::output {

/// A screen of text.
struct Screen {
    std::size_t width = 100;
    std::size_t lines = 40;
};

/// What a terminal shows of a study: the verdict with its most important reservations, then one row per surface, pair
/// and balance, then alerts by kind, the worst first. No more lines than the screen has, less `reserved` for what
/// follows; what is left out is in the files, rows and alerts are counted.
[[nodiscard]] std::string screen(const study::StudyResult& result, const Screen& size = {}, std::size_t reserved = 0);

/// Every table, in the units of the field, with the verdict first and all alerts last.
[[nodiscard]] std::string summary(const study::StudyResult& result, std::size_t width = 100);

}  // namespace setae::output
