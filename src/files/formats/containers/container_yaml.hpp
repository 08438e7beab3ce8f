// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace setae::formats {

/// YAML as JSON. Tags are ignored: `!!python/tuple` is a sequence, `!!python/object…` the content after it; nothing is
/// executed or constructed. Aliases may repeat nodes up to the length of the text, texts up to sixteen times it.
/// @throws FormatError with the line for text that is no YAML or exceeds these bounds. `name` begins the message.
[[nodiscard]] nlohmann::json json_from_yaml(const std::string& text, const std::string& name);

/// JSON as YAML that YAML 1.1 readers read with the same content: block style, every text in double quotes.
[[nodiscard]] std::string yaml_from_json(const nlohmann::ordered_json& value);

}  // namespace setae::formats
