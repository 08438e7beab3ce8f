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

/// Output of a study on a terminal: the verdict with its most important reservations, then one row per surface, pair
/// and balance, then warnings by kind, the worst first. Limited to the lines of the screen minus `reserved`; omitted
/// rows and warnings are counted and are in the files.
[[nodiscard]] std::string screen(const study::StudyResult& result, const Screen& size = {}, std::size_t reserved = 0);

/// Every table, in the units of the field, with the verdict first and all warnings last.
[[nodiscard]] std::string summary(const study::StudyResult& result, std::size_t width = 100);

}  // namespace setae::output
