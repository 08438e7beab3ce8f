// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/answers/contact_radii.hpp"

namespace setae::cli {

/// Prints frames without a radius, and the number of frames in each state, on standard error.
void report_frames(const imaging::ContactRadii& radii);

}  // namespace setae::cli
