// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/xml_file.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/bytes/nesting.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"

namespace setae::bytes {

pugi::xml_document parsed_xml(std::string_view text, const Source& source, const std::string& format) {
    for (const auto* declaration : {"<!DOCTYPE", "<!ENTITY"})
        if (const auto at = text.find(declaration); at != std::string_view::npos)
            throw FormatError(source.name, {.offset = at},
                              fmt::format("{}: XML with declarations of types or entities is not read; remove '{}'",
                                          format, declaration));
    if (const auto at = xml_too_deep(text))
        throw FormatError(source.name, {.offset = *at},
                          fmt::format("{}: XML with more than {} levels is not read", format, max_levels));
    pugi::xml_document document;
    const auto result = document.load_buffer(text.data(), text.size());
    if (!result)
        throw FormatError(source.name, {.offset = static_cast<std::uint64_t>(result.offset)},
                          fmt::format("{}: XML: {}", format, result.description()));
    return document;
}

double xml_number(const pugi::xml_node& node, double fallback, const Source& source, const std::string& format) {
    const auto text = trimmed(node.child_value());
    if (text.empty()) return fallback;
    double value = 0.0;
    if (!parse_cell(text, '.', value) || !std::isfinite(value))
        throw FormatError(source.name, {},
                          fmt::format("{}: '{:.40}' in {} is not a number", format, text, node.path()));
    return value;
}

}  // namespace setae::bytes
