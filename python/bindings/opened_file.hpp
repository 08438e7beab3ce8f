// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "heights.hpp"
#include "setae/formats/channel.hpp"

namespace setae::python {

/// The channels of a file, kept for to_be_read() until another file is looked at: one file at a time is held, however
/// many scans wait for their heights. From any thread. @throws as formats::open().
[[nodiscard]] std::vector<formats::Channel> looked_at(const Item& item);

/// The channels of a file. Those that looked_at() kept, which it then forgets, where the same was said of the file and
/// nobody has changed it since; else it is opened. From any thread. @throws as formats::open().
[[nodiscard]] std::vector<formats::Channel> to_be_read(const Item& item);

}  // namespace setae::python
