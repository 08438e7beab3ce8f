// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/formats/channel.hpp"

namespace setae::formats {

/// The channel with the heights undefined that mark missing ones, whether they are read as a whole or by scan lines.
/// What was found is in the metadata's alerts, as topography::alerts_of() words it.
[[nodiscard]] Channel without_no_data(Channel channel);

}  // namespace setae::formats
