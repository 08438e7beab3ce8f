// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "setae/core/quantity.hpp"
#include "setae/core/units.hpp"
#include "setae/formats/channel.hpp"
#include "setae/output/json.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::cli {

/// Exit codes of every verb.
enum class ExitCode : int {
    done = 0,          ///< all done, alerts included
    some_failed = 1,   ///< some items failed, the rest is done
    nothing_done = 2,  ///< nothing done, or a usage error
};

/// Options all verbs share.
struct Common {
    bool json = false;
    bool explain = false;
    int threads = 0;

    [[nodiscard]] parallel::Threads workers() const { return {threads}; }
};

/// Registers --json, --explain and --threads.
void add_common(CLI::App& verb, Common& common);

/// Prints an explanation; done.
[[nodiscard]] ExitCode explained(const char* explanation);

/// What a verb does when it was the one named.
using Action = std::function<ExitCode()>;

/// Sets `action` to run the verb with its arguments if the command line names it, with the options all verbs share;
/// --explain prints `explanation` instead.
template <class Arguments>
void on_named(CLI::App& verb, Action& action, std::shared_ptr<Arguments> arguments, const char* explanation,
              ExitCode (*run)(const Arguments&)) {
    add_common(verb, arguments->common);
    verb.callback([&action, arguments, explanation, run] {
        action = [arguments, explanation, run] {
            return arguments->common.explain ? explained(explanation) : run(*arguments);
        };
    });
}

/// Prints data on standard output.
void print(const std::string& text);
void print_json(const output::Json& json);

/// Prints a message, "setae: …", on standard error.
void complain(const std::string& message);
/// Prints alerts on standard error, one a line.
void show(const std::vector<Alert>& alerts);

/// Runs body for every item; a setae::Error of one item is printed and the others go on.
[[nodiscard]] ExitCode for_each_item(const std::vector<std::string>& items,
                                     const std::function<void(const std::string&)>& body);

/// A quantity on one line for a reader: name, value with its unit and error, band.
[[nodiscard]] std::string as_line(const Quantity& quantity);

/// Registers --as matrix|columns: how text is to be read whose columns have two meanings.
void add_layout_option(CLI::App& verb, std::string& as);

/// Options for files that leave something open: --size "1 mm x 1 mm", --unit um, --as columns, --channel K.
struct FileOptions {
    std::string size;
    std::string unit;
    std::string as;
    std::optional<std::size_t> channel;

    void add_to(CLI::App& verb);
    /// @throws InvalidArgument for a malformed size.
    [[nodiscard]] formats::ReadOptions read_options() const;
};

}  // namespace setae::cli
