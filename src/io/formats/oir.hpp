// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/io/channel.hpp"
#include "setae/io/source.hpp"

namespace setae::io {

[[nodiscard]] std::vector<Channel> open_oir(const Source& source, const ReadOptions& options);

}  // namespace setae::io
