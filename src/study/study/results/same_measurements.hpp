// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "setae/study/study_result.hpp"

namespace setae::study {

/// Finds data that are listed more than once, which give no additional information: SAME_MEASUREMENT where measurements
/// of a surface contain the same numbers, regardless of format, line ends and names of their files.
///
/// contents: identity of the content of each measurement's file and its channel, in the order of the measurements;
/// empty where a file has several measurements.
/// Cost: n log n for n measurements.
void look_for_copies(SurfaceResult& surface, const std::vector<std::string>& contents);

/// Finds repeated records of loops; excluded loops are compared separately.
void look_for_same_loops(StudyResult& result);

}  // namespace setae::study
