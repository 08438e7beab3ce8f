// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "program/options.hpp"
#include "setae/answers/contact_radii.hpp"

namespace setae::cli {

/// Options of verbs that look at contacts in the frames of a recording.
void add_recording_options(Options& options, answers::RadiusRequest& request);

/// Frames without a radius, and what the whole gave, for the user.
void tell(const imaging::ContactRadii& radii);

}  // namespace setae::cli
