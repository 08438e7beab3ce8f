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
    bool all = false;  ///< every warning and column in full
    int threads = 0;

    /// --json, --explain, --threads, and --all where the command has no option of this name.
    void add_to(Options& options);
    /// Sets what these options ask of the program.
    void apply() const;
    [[nodiscard]] parallel::Threads workers() const { return {threads}; }
};

/// Runs a command with the values of its options.
using Action = std::function<ExitCode()>;

/// Text of --explain, or a function that makes the text.
using Explanation = std::variant<const char*, std::string (*)()>;

/// Prints an explanation; returns `done`.
[[nodiscard]] ExitCode explained(const Explanation& explanation);

/// Declares the common options after the options of the command; returns the action that runs the command.
template <class Arguments>
[[nodiscard]] Action action(Options& options, std::shared_ptr<Arguments> arguments, Explanation explanation,
                            ExitCode (*run)(const Arguments&)) {
    arguments->common.add_to(options);
    return [arguments, explanation, run] {
        arguments->common.apply();
        return arguments->common.explain ? explained(explanation) : run(*arguments);
    };
}

/// A command of the program, or of one of its groups of commands.
struct Command {
    const char* topic;  ///< heading of the help: "Inspect"
    const char* group;  ///< "jkr" of `setae jkr fit`; empty for most
    const char* name;
    const char* description;
    Action (*declare)(Options&);  ///< declares the options; returns the action
};

/// A group of commands. Its topic is that of its first command.
struct CommandGroup {
    const char* name;
    const char* description;
};

/// All commands in the order of the help; commands of a group follow each other.
[[nodiscard]] std::span<const Command> commands();
[[nodiscard]] std::span<const CommandGroup> command_groups();

}  // namespace setae::cli
