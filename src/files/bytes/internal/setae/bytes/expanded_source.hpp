// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "setae/bytes/source.hpp"

namespace setae::bytes {

/// Bytes that are expanded when first asked for, by whichever thread asks, and then kept. `expand` gives exactly `size`
/// bytes.
/// @throws (reading) FormatError where `expand` gives another number of bytes, and what it throws.
[[nodiscard]] Source expanded_source(std::string name, std::uint64_t size, std::function<std::string()> expand);

}  // namespace setae::bytes
