// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "setae/study/study_result.hpp"

namespace setae::study {

/// The same data listed more than once give no more information than once: SAME_MEASUREMENT where measurements of a
/// surface hold the same numbers, whatever the format, line ends and names of their files.
///
/// contents: what tells the content of each measurement's file and its channel, in the order of the measurements; empty
/// where a file has several measurements.
/// Cost: n log n for n measurements.
void look_for_copies(SurfaceResult& surface, const std::vector<std::string>& contents);

/// The same for the records of loops, those that are left out apart.
void look_for_same_loops(StudyResult& result);

}  // namespace setae::study
