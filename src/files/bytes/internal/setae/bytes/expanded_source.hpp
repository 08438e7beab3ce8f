// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "setae/bytes/source.hpp"

namespace setae::bytes {

/// Bytes that are expanded at the first request, from any thread, and then kept. `expand` returns exactly `size` bytes.
/// @throws (reading) FormatError if `expand` returns another number of bytes; exceptions of `expand`.
[[nodiscard]] Source expanded_source(std::string name, std::uint64_t size, std::function<std::string()> expand);

}  // namespace setae::bytes
