// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <variant>

#include "program/exit_code.hpp"
#include "program/options.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::cli {

/// Options all commands share.
struct Common {
    bool json = false;
    bool explain = false;
    int threads = 0;

    /// --json, --explain and --threads.
    void add_to(Options& options);
    [[nodiscard]] parallel::Threads workers() const { return {threads}; }
};

/// What a command does when it was the one named.
using Action = std::function<ExitCode()>;

/// What --explain prints: a text, or what makes it.
using Explanation = std::variant<const char*, std::string (*)()>;

/// Prints an explanation; done.
[[nodiscard]] ExitCode explained(const Explanation& explanation);

/// Declares the options all commands share behind those of the command; what runs it with the values its options got.
template <class Arguments>
[[nodiscard]] Action action(Options& options, std::shared_ptr<Arguments> arguments, Explanation explanation,
                            ExitCode (*run)(const Arguments&)) {
    arguments->common.add_to(options);
    return [arguments, explanation, run] {
        parallel::limit_threads(arguments->common.workers());
        return arguments->common.explain ? explained(explanation) : run(*arguments);
    };
}

/// A command of the program, or of one of its groups of commands.
struct Command {
    const char* topic;  ///< heading of the help under which it stands: "Inspect"
    const char* group;  ///< "jkr" of `setae jkr fit`; empty for most
    const char* name;
    const char* description;
    Action (*declare)(Options&);  ///< its options; what runs it
};

/// A group of commands, in the topic of its first.
struct CommandGroup {
    const char* name;
    const char* description;
};

/// All commands in the order of the help, those of a group beside each other.
[[nodiscard]] std::span<const Command> commands();
[[nodiscard]] std::span<const CommandGroup> command_groups();

}  // namespace setae::cli
