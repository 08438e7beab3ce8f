// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "setae/processing/steps.hpp"

namespace setae::processing {

/// A parameter as text: its value with its unit, as in pipeline files.
struct ParameterText {
    std::string name;
    std::string value;

    friend bool operator==(const ParameterText&, const ParameterText&) = default;
};

/// Sets a parameter from text such as "8 um", "30 deg", "true", "median".
/// @throws InvalidArgument for an unknown parameter (with the nearest name) and for text that is no value of it.
void set_parameter(Step& step, const ParameterText& parameter);

/// All parameters of a step as text for set_parameter(); absent ones are left out.
[[nodiscard]] std::vector<ParameterText> parameters(const Step& step);

/// Parameters that differ from their defaults.
[[nodiscard]] std::vector<ParameterText> changed_parameters(const Step& step);

/// A step from one line, as on the command line: its name, then NAME=VALUE for each parameter, values with blanks in
/// double quotes:
///   align_rows method=median region="exclude heights above 20 nm"
/// @throws InvalidArgument.
[[nodiscard]] Step step_from_text(std::string_view text);

/// The line from which step_from_text() restores the step.
[[nodiscard]] std::string text(const Step& step);

}  // namespace setae::processing
