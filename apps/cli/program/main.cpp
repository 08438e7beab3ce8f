// SPDX-License-Identifier: GPL-3.0-or-later
#include <exception>

#include "program/command_line.hpp"
#include "program/messages.hpp"
#include "program/parser.hpp"
#include "setae/core/errors.hpp"
#include "setae/parallel/memory.hpp"

int main(int argc, char** argv) {
    using namespace setae::cli;
    setae::parallel::keep_freed_memory();
    remember_command_line(argc, argv);
    try {
        const auto [action, exit_code] = parsed(argc, argv);
        return action ? static_cast<int>(action()) : exit_code;
    } catch (const setae::Error& error) {
        complain(error.what());
    } catch (const std::exception& error) {
        complain(std::string("internal error: ") + error.what());
    }
    return static_cast<int>(ExitCode::nothing_done);
}
