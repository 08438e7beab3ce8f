// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session.hpp"

namespace setae::cli {

/// `setae lab contours`: errors of contours traced in rendered micrographs, on curves that are known.
void add_lab_contours(CLI::App& group, Action& action);

}  // namespace setae::cli
