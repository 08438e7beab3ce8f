// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "heights.hpp"
#include "setae/formats/channel.hpp"

namespace setae::python {

/// Opens a file and returns its channels, which are kept for kept_or_opened() until the next call. Only one file is
/// kept at a time, for any number of scans. Can be called from any thread. @throws as formats::open().
[[nodiscard]] std::vector<formats::Channel> open_and_keep(const Item& item);

/// The channels that open_and_keep() kept, which are then released, if the options are the same and the file has not
/// changed; otherwise the file is opened. Can be called from any thread. @throws as formats::open().
[[nodiscard]] std::vector<formats::Channel> kept_or_opened(const Item& item);

}  // namespace setae::python
