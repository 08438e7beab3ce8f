// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <fmt/format.h>

#include "expression.hpp"
#include "setae/bytes/toml_text.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/tables/mapping.hpp"

namespace setae::tables {
namespace {

std::string key(const std::string& name) { return is_identifier(name) ? name : bytes::toml_quoted(name); }

void require_name(const std::string& name) {
    if (!is_identifier(name))
        throw InvalidArgument(fmt::format("'{}' cannot be a name in expressions; use letters, digits and _", name));
}

const char* word(bytes::Encoding encoding) {
    return encoding == bytes::Encoding::utf8 ? "utf-8" : encoding == bytes::Encoding::utf16 ? "utf-16" : "latin-1";
}

const char* word(char separator) {
    return separator == '\t' ? "tab" : separator == ',' ? "comma" : separator == ';' ? "semicolon" : "blank";
}

std::string file_section(const TableOptions& file) {
    if (file == TableOptions{}) return {};
    std::string text = "[file]\n";
    if (file.encoding != bytes::Encoding::detect) text += fmt::format("encoding = \"{}\"\n", word(file.encoding));
    if (file.separator) text += fmt::format("separator = \"{}\"\n", word(*file.separator));
    if (file.decimal_point) text += fmt::format("decimal = \"{}\"\n", *file.decimal_point == ',' ? "comma" : "point");
    if (file.header_end) text += fmt::format("header_end = {}\n", bytes::toml_quoted(*file.header_end));
    if (file.sheet) text += fmt::format("sheet = {}\n", bytes::toml_quoted(*file.sheet));
    return text + '\n';
}

std::string constants_section(const std::vector<MappedConstant>& constants) {
    if (constants.empty()) return {};
    std::string text = "[constants]\n";
    for (const auto& constant : constants) {
        require_name(constant.name);
        if (!std::isfinite(constant.value))
            throw InvalidArgument(
                fmt::format("constant '{}' is {}, expected a finite number", constant.name, constant.value));
        const bool spring = constant.dimension == dimension::stiffness;  // J/m2 would be equivalent
        text += fmt::format("{} = \"{} {}\"\n", constant.name, constant.value,
                            spring ? "N/m" : si_unit(constant.dimension));
    }
    return text + '\n';
}

std::string column_section(const MappedColumn& column) {
    require_name(column.name);
    std::string text = fmt::format("[columns.{}]\n", column.name);
    if (column.position) text += fmt::format("position = {}\n", *column.position);
    else text += fmt::format("header = {}\n", bytes::toml_quoted(column.header.value_or("")));
    if (column.unit) text += fmt::format("unit = {}\n", bytes::toml_quoted(*column.unit));
    return text + '\n';
}

bool has_known_dimension(const std::string& name) {
    return name == "force" || name == "displacement" || name == "contact_radius" || name == "time";
}

}  // namespace

std::string as_toml(const Mapping& mapping) {
    std::string text;
    for (const auto& note : mapping.notes) text += fmt::format("# {}\n", note);
    if (!text.empty()) text += '\n';
    text += file_section(mapping.file) + constants_section(mapping.constants);
    for (const auto& column : mapping.columns) text += column_section(column);
    text += "[table]\n";
    for (const auto& result : mapping.results) {
        if (has_known_dimension(result.name))
            text += fmt::format("{} = {}\n", key(result.name), bytes::toml_quoted(result.expression));
        else
            text += fmt::format("{} = {{ expression = {}, unit = \"{}\" }}\n", key(result.name),
                                bytes::toml_quoted(result.expression), si_unit(result.dimension));
    }
    return text;
}

void write_mapping(const std::string& path, const Mapping& mapping) { bytes::write_whole_file(path, as_toml(mapping)); }

}  // namespace setae::tables
