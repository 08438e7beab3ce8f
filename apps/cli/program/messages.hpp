// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "program/exit_code.hpp"
#include "setae/core/quantity.hpp"
#include "setae/fields/option.hpp"
#include "setae/output/alert_groups.hpp"

namespace setae::cli {

/// Prints data on standard output.
void print(const std::string& text);

/// Sets how messages spell options in back quotes (fields::spelled); called when the command is known.
void spell_options_by(fields::Spelling spelling);

/// Prints a text for the reader on standard error, beside data on standard output.
void print_for_reader(const std::string& text);

/// Prints a message, "setae: …", on standard error.
void print_message(const std::string& message);
/// Prints warnings on standard error as output::warning_lines(), or each in full.
void show(const std::vector<Alert>& alerts);
/// Lets show() print every warning in full.
void show_every_warning(bool every);
/// Lines of warnings as show() prints them.
[[nodiscard]] std::vector<std::string> lines_of(const std::vector<Alert>& alerts,
                                                std::string (*line_of)(const Alert&) = output::warning_line);

/// Prints the warnings about reading of files and returns the others. Called before results are printed.
[[nodiscard]] std::vector<Alert> show_reading_warnings(std::vector<Alert> alerts);

/// Runs body for every item. A setae::Error of one item is printed; the other items are run.
[[nodiscard]] ExitCode for_each_item(const std::vector<std::string>& items,
                                     const std::function<void(const std::string&)>& body);

}  // namespace setae::cli
