// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/answers/contact_radii.hpp"

namespace setae::cli {

/// Frames without a radius, and what the whole gave, for the user.
void tell(const imaging::ContactRadii& radii);

}  // namespace setae::cli
