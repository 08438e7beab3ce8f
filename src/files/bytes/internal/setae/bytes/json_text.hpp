// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "setae/bytes/nesting.hpp"
#include "setae/core/errors.hpp"

namespace setae::bytes {

/// JSON of `name`, at most max_levels deep. @throws FormatError at the byte of the error, "…: `complaint`".
template <class Json = nlohmann::json>
[[nodiscard]] Json parsed_json(std::string_view text, const std::string& name, const std::string& complaint) {
    if (const auto at = json_too_deep(text))
        throw FormatError(name, {.offset = *at},
                          complaint + "; JSON of more than " + std::to_string(max_levels) + " levels is not read");
    try {
        return Json::parse(text);
    } catch (const nlohmann::json::exception& error) {
        const auto* parse_error = dynamic_cast<const nlohmann::json::parse_error*>(&error);
        throw FormatError(name, {.offset = parse_error ? parse_error->byte : 0}, complaint);
    }
}

/// JSON of optional content: null for text that is no JSON or too deep.
[[nodiscard]] inline nlohmann::json json_or_null(std::string_view text) {
    if (json_too_deep(text)) return nullptr;
    auto json = nlohmann::json::parse(text, nullptr, false);
    return json.is_discarded() ? nlohmann::json() : json;
}

}  // namespace setae::bytes
