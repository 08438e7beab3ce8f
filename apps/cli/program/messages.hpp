// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "program/exit_code.hpp"
#include "setae/core/quantity.hpp"
#include "setae/fields/option.hpp"

namespace setae::cli {

/// Prints data on standard output.
void print(const std::string& text);

/// Sets how messages spell options in back quotes (fields::spelled); called when the command is known.
void spell_options_by(fields::Spelling spelling);

/// Prints a message, "setae: …", on standard error.
void print_message(const std::string& message);
/// Prints warnings on standard error, one per line.
void show(const std::vector<Alert>& alerts);

/// Prints the warnings about reading of files and returns the others. Called before results are printed.
[[nodiscard]] std::vector<Alert> show_reading_warnings(std::vector<Alert> alerts);

/// Runs body for every item. A setae::Error of one item is printed; the other items are run.
[[nodiscard]] ExitCode for_each_item(const std::vector<std::string>& items,
                                     const std::function<void(const std::string&)>& body);

}  // namespace setae::cli
