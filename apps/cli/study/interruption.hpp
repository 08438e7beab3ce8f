// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

namespace setae::cli {

/// Becomes true with the first Ctrl-C or SIGTERM from now on; the second one ends the program at once.
[[nodiscard]] const std::atomic<bool>& interruption();

/// Ends the program by the signal that interrupted it, so that the shell knows.
[[noreturn]] void end_as_interrupted();

}  // namespace setae::cli
