// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "setae/output/screen.hpp"

namespace setae::cli {

/// The size that standard output has as a terminal; 100 × 40 characters where it is none. Never wider than 120, where
/// lines are hard to read, nor narrower than 60.
[[nodiscard]] output::Screen output_size();

/// Columns of the terminal that standard error is, 80 where it is none.
[[nodiscard]] std::size_t columns_of_errors();

}  // namespace setae::cli
