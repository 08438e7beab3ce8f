// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace setae::cli {

/// Exit codes of every command.
enum class ExitCode : int {
    done = 0,          ///< all done, with or without warnings
    some_failed = 1,   ///< some items failed, the rest is done
    nothing_done = 2,  ///< nothing done, or a usage error
};

}  // namespace setae::cli
