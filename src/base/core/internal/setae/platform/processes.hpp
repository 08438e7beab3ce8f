// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace setae::platform {

using ProcessId = long;

[[nodiscard]] ProcessId this_process();
/// Whether no process has this number.
[[nodiscard]] bool is_gone(ProcessId process);

/// NAME=VALUE of this process.
[[nodiscard]] std::vector<std::string> environment();

/// How another process ended.
struct ProcessEnd {
    std::error_code start;  ///< reason if the process could not be started, of the generic category
    int exit_code = 0;      ///< if the process exited
    std::string signal;     ///< signal that ended the process, such as "signal 11, Segmentation fault"; empty if the
                            ///< process exited
    bool out_of_time = false;

    [[nodiscard]] bool well() const { return !start && exit_code == 0 && signal.empty(); }
};

/// Another program.
struct Command {
    std::vector<std::string> words;        ///< name, found as by a shell, and arguments
    std::vector<std::string> environment;  ///< NAME=VALUE
    std::string folder;                    ///< working directory
    std::string output;                    ///< file for all its output
};

/// Runs a command without input, and waits.
[[nodiscard]] ProcessEnd run(const Command& command);

/// Output of a shell command line; empty if it cannot be run or fails. The line must not contain text from users.
[[nodiscard]] std::optional<std::string> output_of(const std::string& line);

/// Runs `use` in a child of this process, without output, for at most so many seconds; exceptions are lost. @returns
/// empty if the child was lost.
[[nodiscard]] std::optional<ProcessEnd> run_in_child(const std::function<void()>& use, unsigned max_seconds);

/// Called in each child of this process before anything else.
void in_every_child(void (*function)());

/// A mutex of the process that every fork() waits for: the child finds the mutex free and the data behind it complete.
/// For mutexes without destruction that are held for a short time, and not by a thread that forks. @returns the mutex.
std::mutex& free_in_every_child(std::mutex& mutex);

/// Writing beyond `ulimit -f` is an error after this call and no longer ends the process.
void survive_full_files();

}  // namespace setae::platform
