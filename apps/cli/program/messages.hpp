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

/// How messages spell options that stand in back quotes (fields::spelled); set when the command is known.
void spell_options_by(fields::Spelling spelling);

/// Prints a message, "setae: …", on standard error.
void complain(const std::string& message);
/// Prints alerts on standard error, one a line.
void show(const std::vector<Alert>& alerts);

/// Prints the alerts about how files were read and returns the others: called before the numbers that depend on them.
[[nodiscard]] std::vector<Alert> show_of_reading(std::vector<Alert> alerts);

/// Runs body for every item; a setae::Error of one item is printed and the others go on.
[[nodiscard]] ExitCode for_each_item(const std::vector<std::string>& items,
                                     const std::function<void(const std::string&)>& body);

}  // namespace setae::cli
