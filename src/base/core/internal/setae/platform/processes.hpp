// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace setae::platform {

using ProcessId = long;

[[nodiscard]] ProcessId this_process();
/// Whether no process has this number (any more).
[[nodiscard]] bool is_gone(ProcessId process);

/// NAME=VALUE of this process.
[[nodiscard]] std::vector<std::string> environment();

/// How another process ended.
struct ProcessEnd {
    std::error_code start;  ///< why it could not be started, of the generic category
    int exit_code = 0;      ///< of one that ended itself
    std::string signal;     ///< "signal 11, Segmentation fault" that ended it; empty: it ended itself
    bool out_of_time = false;

    [[nodiscard]] bool well() const { return !start && exit_code == 0 && signal.empty(); }
};

/// Another program.
struct Command {
    std::vector<std::string> words;        ///< its name, found as a shell does, and its arguments
    std::vector<std::string> environment;  ///< NAME=VALUE
    std::string folder;                    ///< where it runs
    std::string output;                    ///< file for all it says
};

/// Runs it, with nothing to read, and waits.
[[nodiscard]] ProcessEnd run(const Command& command);

/// What a line of the shell prints; nothing where it cannot be run or fails. The line holds nothing that users gave.
[[nodiscard]] std::optional<std::string> output_of(const std::string& line);

/// Does `use` in a child of this process, silently, for so many seconds at most; what it throws is lost. @returns
/// nothing where the child was lost.
[[nodiscard]] std::optional<ProcessEnd> run_in_child(const std::function<void()>& use, unsigned max_seconds);

/// Called in each child of this process before anything else.
void in_every_child(void (*function)());

/// Writing beyond `ulimit -f` fails from here on, and no longer ends the process.
void survive_full_files();

}  // namespace setae::platform
