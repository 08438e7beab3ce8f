// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace setae::processing {

/// A length [m] as the shortest text with a unit from which parse_quantity() restores the number: "8 um".
[[nodiscard]] std::string length_text(double length);

/// An angle [rad] as text from which parsed_angle() restores the number: "30 deg", otherwise "0.1 rad".
[[nodiscard]] std::string angle_text(double angle);

/// "30 deg", "30°", "0.5 rad"; 0 needs no unit. @throws InvalidArgument.
[[nodiscard]] double parsed_angle(std::string_view text);

/// The shortest text from which a number is restored exactly.
[[nodiscard]] std::string number_text(double number);

/// "true" or "false". @throws InvalidArgument.
[[nodiscard]] bool parsed_flag(std::string_view text);

/// @throws InvalidArgument: the text is none of the values.
[[noreturn]] void refuse_choice(std::string_view text, std::string_view values);

/// A number without unit. @throws InvalidArgument.
[[nodiscard]] double parsed_number(std::string_view text);

/// A whole number. @throws InvalidArgument.
[[nodiscard]] long long parsed_count(std::string_view text);

}  // namespace setae::processing
