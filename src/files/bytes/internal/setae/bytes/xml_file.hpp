// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pugixml.hpp>

#include <string>
#include <string_view>

#include "setae/bytes/source.hpp"

namespace setae::bytes {

/// XML of a file or member. Documents that define types or entities are refused: no instrument writes them, and
/// entities can expand small files to large ones.
/// @throws FormatError "<format>: …" with the offset of the error.
[[nodiscard]] pugi::xml_document parsed_xml(std::string_view text, const Source& source, const std::string& format);

/// A number in the text of an element, or the fallback if the element is missing or empty.
/// @throws FormatError for text that is no finite number.
[[nodiscard]] double xml_number(const pugi::xml_node& node, double fallback, const Source& source,
                                const std::string& format);

}  // namespace setae::bytes
