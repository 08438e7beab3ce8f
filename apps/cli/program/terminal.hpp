// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "setae/output/screen.hpp"

namespace setae::cli {

/// Size of standard output if it is a terminal, else 100 × 40 characters. The width is 60 to 120 characters, because
/// longer lines are hard to read.
[[nodiscard]] output::Screen output_size();

/// Columns of standard error if it is a terminal, else 80.
[[nodiscard]] std::size_t columns_of_errors();

}  // namespace setae::cli
