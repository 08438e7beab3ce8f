// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace setae::platform {

enum class Stream { output, errors };

[[nodiscard]] bool is_terminal(Stream stream);

/// Columns of the terminal; 0 if the stream is no terminal.
[[nodiscard]] std::size_t columns_of(Stream stream);

}  // namespace setae::platform
