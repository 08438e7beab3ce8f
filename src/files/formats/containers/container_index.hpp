// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "setae/bytes/archive.hpp"
#include "setae/formats/container.hpp"

namespace setae::formats {

/// Names of the index in the archive; the first existing one is used.
inline constexpr const char* json_index = "index.json";
inline constexpr const char* yaml_index = "meta.yml";

[[nodiscard]] inline bool has_index(const bytes::Archive& archive) {
    return archive.has(json_index) || archive.has(yaml_index);
}

/// The index of any generation, converted to the keys of generation C without other changes.
/// @throws FormatError for an index that is missing, does not parse, has more than 64 levels or lists no surfaces.
[[nodiscard]] nlohmann::json parsed_index(const bytes::Archive& archive, const bytes::Source& source);

/// Content of an index of generation C.
struct IndexContent {
    Container container;
    std::vector<Alert> alerts;
};
[[nodiscard]] IndexContent index_content(nlohmann::json index);

/// The index of generation C with the content of a container.
[[nodiscard]] nlohmann::ordered_json index_of(const Container& container);

}  // namespace setae::formats
