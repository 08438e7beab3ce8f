// SPDX-License-Identifier: GPL-3.0-or-later
#include "container_yaml.hpp"

#include <yaml-cpp/yaml.h>

#include <cmath>

#include <fmt/format.h>

#include "setae/bytes/yaml_text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"

namespace setae::formats {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

json scalar(const YAML::Node& node) {
    const auto& text = node.Scalar();
    if (node.Tag() == "!") return text;  // quoted
    if (text == "true" || text == "false") return text == "true";
    if (text == "null" || text == "~" || text.empty()) return nullptr;
    if (const auto whole = spelled<std::int64_t>(text)) return *whole;
    if (const auto number = spelled<double>(text); number && std::isfinite(*number)) return *number;
    return text;
}

json to_json(const YAML::Node& node) {
    if (node.IsMap()) {
        auto object = json::object();
        for (const auto& entry : node) {
            if (!entry.first.IsScalar()) throw YAML::Exception(entry.first.Mark(), "a key is not a text");
            object[entry.first.Scalar()] = to_json(entry.second);
        }
        return object;
    }
    if (node.IsSequence()) {
        auto array = json::array();
        for (const auto& entry : node) array.push_back(to_json(entry));
        return array;
    }
    return node.IsScalar() ? scalar(node) : json(nullptr);
}

/// A text in double quotes; characters that YAML counts as line ends or does not print are escaped.
std::string quoted(const std::string& text) {
    const auto escaped = json(text).dump(-1, ' ', false, json::error_handler_t::replace);
    std::string result;
    const auto code = [&](std::size_t i) { return static_cast<unsigned char>(i < escaped.size() ? escaped[i] : '\0'); };
    for (std::size_t i = 0; i < escaped.size(); ++i) {
        if (code(i) == 0x7f) {
            result += "\\x7f";
        } else if (code(i) == 0xc2 && code(i + 1) < 0xa0) {
            result += fmt::format("\\x{:02x}", code(++i));
        } else if (code(i) == 0xe2 && code(i + 1) == 0x80 && (code(i + 2) == 0xa8 || code(i + 2) == 0xa9)) {
            result += code(i + 2) == 0xa8 ? "\\u2028" : "\\u2029";
            i += 2;
        } else if (code(i) == 0xef &&
                   ((code(i + 1) == 0xbb && code(i + 2) == 0xbf) || (code(i + 1) == 0xbf && code(i + 2) >= 0xbe))) {
            result += code(i + 1) == 0xbb ? "\\ufeff" : code(i + 2) == 0xbe ? "\\ufffe" : "\\uffff";
            i += 2;
        } else {
            result += escaped[i];
        }
    }
    return result;
}

/// In YAML 1.1 1e-09 is a text and 1.0e-09 a number.
std::string number(const ordered_json& value) {
    auto text = value.dump();
    const auto exponent = text.find('e');
    if (exponent != std::string::npos && text.find('.') == std::string::npos) text.insert(exponent, ".0");
    return text;
}

bool is_block(const ordered_json& value) { return value.is_structured() && !value.empty(); }

std::string inline_value(const ordered_json& value) {
    if (value.is_string()) return quoted(value.get<std::string>());
    return value.is_number() ? number(value) : value.dump();
}

void emit(const ordered_json& value, std::size_t indent, std::string& out);

/// Writes the part after "key:" or "-".
void emit_value(const ordered_json& value, std::size_t indent, std::string& out) {
    if (!is_block(value)) {
        out += " " + inline_value(value) + "\n";
        return;
    }
    out += "\n";
    emit(value, indent, out);
}

void emit(const ordered_json& value, std::size_t indent, std::string& out) {
    const std::string margin(indent, ' ');
    if (!is_block(value)) {
        out += margin + inline_value(value) + "\n";
        return;
    }
    for (const auto& [key, entry] : value.items()) {
        out += margin + (value.is_object() ? quoted(key) + ":" : std::string("-"));
        emit_value(entry, indent + 2, out);
    }
}

}  // namespace

json json_from_yaml(const std::string& text, const std::string& name) {
    try {
        return to_json(bytes::parsed_yaml(text, name));
    } catch (const YAML::Exception& error) {
        const auto line = static_cast<std::uint64_t>(std::max(error.mark.line, 0)) + 1;
        throw FormatError(name, {.line = line}, fmt::format("YAML: {}", error.msg));
    }
}

std::string yaml_from_json(const ordered_json& value) {
    std::string out;
    emit(value, 0, out);
    return out;
}

}  // namespace setae::formats
