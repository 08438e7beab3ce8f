// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace setae::answers {

/// Present time, ISO 8601 in UTC: "2026-11-21T18:40:20Z"; or SOURCE_DATE_EPOCH where it is set.
/// Source: https://reproducible-builds.org/specs/source-date-epoch/.
[[nodiscard]] std::string time_of_run();

}  // namespace setae::answers
