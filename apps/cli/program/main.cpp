// SPDX-License-Identifier: GPL-3.0-or-later
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>

#include "program/command_line.hpp"
#include "program/messages.hpp"
#include "program/parser.hpp"
#include "setae/bytes/protected_inputs.hpp"
#include "setae/core/errors.hpp"
#include "setae/parallel/memory.hpp"
#include "setae/platform/processes.hpp"

namespace setae::cli {
namespace {

int run(int argc, char** argv) {
    try {
        const bytes::ProtectedInputs inputs;
        const auto [action, exit_code] = parsed(argc, argv);
        return action ? static_cast<int>(action()) : exit_code;
    } catch (const std::exception& error) {
        print_message(reason_of(error));
    }
    return static_cast<int>(ExitCode::nothing_done);
}

/// True if standard output was written completely; otherwise the reason is printed.
bool output_arrived() {
    errno = 0;
    std::cout.flush();
    const bool flushed = std::fflush(stdout) == 0;
    if (flushed && std::ferror(stdout) == 0 && std::cout) return true;
    print_message(std::string("standard output cannot be written") +
                  (errno != 0 ? std::string(" (") + std::strerror(errno) + ")" : std::string()) +
                  "; the output is not complete");
    return false;
}

}  // namespace
}  // namespace setae::cli

int main(int argc, char** argv) {
    using namespace setae::cli;
    setae::parallel::keep_freed_memory();
    // a file above `ulimit -f` is refused with a reason and removed; the program does not end by a signal
    setae::platform::survive_full_files();
    store_command_line(argc, argv);
    const int exit_code = run(argc, argv);
    return output_arrived() ? exit_code : static_cast<int>(ExitCode::nothing_done);
}
