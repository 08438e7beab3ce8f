// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/formats/channel.hpp"

namespace setae::formats {

/// The channel with markers of missing heights set undefined, read as a whole or by scan lines. The metadata contain
/// the warnings of topography::alerts_of().
[[nodiscard]] Channel without_no_data(Channel channel);

}  // namespace setae::formats
