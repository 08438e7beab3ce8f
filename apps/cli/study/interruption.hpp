// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

namespace setae::cli {

/// Becomes true at the first Ctrl-C or SIGTERM after this call; the second one ends the program.
[[nodiscard]] const std::atomic<bool>& interruption();

/// Ends the program by the signal that interrupted it, so that the shell can detect it.
[[noreturn]] void end_as_interrupted();

}  // namespace setae::cli
