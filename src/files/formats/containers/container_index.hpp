// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "setae/bytes/archive.hpp"
#include "setae/formats/container.hpp"

namespace setae::formats {

/// Names of the index in the archive; the first that is there counts.
inline constexpr const char* json_index = "index.json";
inline constexpr const char* yaml_index = "meta.yml";

[[nodiscard]] inline bool has_index(const bytes::Archive& archive) {
    return archive.has(json_index) || archive.has(yaml_index);
}

/// The index with the keys of generation C, whatever generation it is; nothing else is changed.
/// @throws FormatError for an index that is missing, does not parse, nests deeper than 64 levels or lists no surfaces.
[[nodiscard]] nlohmann::json parsed_index(const bytes::Archive& archive, const bytes::Source& source);

/// What an index of generation C says.
struct IndexContent {
    Container container;
    std::vector<Alert> alerts;
};
[[nodiscard]] IndexContent index_content(nlohmann::json index);

/// The index of generation C that says the same.
[[nodiscard]] nlohmann::ordered_json index_of(const Container& container);

}  // namespace setae::formats
