// SPDX-License-Identifier: GPL-3.0-or-later
#include "json_writer.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <nlohmann/json.hpp>

namespace setae::output {
namespace {

/// The shortest text that represents the number exactly, always a real one: "1.0". null for numbers that JSON cannot
/// represent.
void append_real(std::string& text, double value) {
    if (!std::isfinite(value)) {
        text += "null";
        return;
    }
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    const std::string_view digits(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
    text += digits;
    if (digits.find_first_of(".e") == std::string_view::npos) text += ".0";
}

bool is_list(const Json& json) {
    return json.is_array() &&
           std::all_of(json.begin(), json.end(), [](const Json& item) { return !item.is_structured(); });
}

/// Whether a document ends with a bracket that end() has written.
bool ended_by_bracket(const Json& json) { return json.is_structured() && !is_list(json); }

void append_scalar(std::string& text, const Json& json) {
    if (json.is_number_float()) append_real(text, json.get<double>());
    else text += json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

void JsonWriter::flush(std::size_t least) {
    if (text_.size() < least) return;
    write_(text_);
    text_.clear();
}

void JsonWriter::line() {
    constexpr std::size_t piece = 1 << 20;
    flush(piece);
    text_ += '\n';
    text_.append(2 * depth_, ' ');
}

void JsonWriter::begin(char bracket) {
    text_ += bracket;
    ++depth_;
    first_ = true;
}

void JsonWriter::end(char bracket) {
    --depth_;
    if (!first_) line();
    text_ += bracket;
    first_ = false;
    if (depth_ == 0) finish();
}

void JsonWriter::finish() {
    text_ += '\n';
    flush(0);
}

void JsonWriter::key(std::string_view name) {
    if (!first_) text_ += ',';
    line();
    first_ = false;
    append_scalar(text_, Json(name));
    text_ += ": ";
}

void JsonWriter::value(const Json& json) {
    append(json);
    if (depth_ == 0 && !ended_by_bracket(json)) finish();
}

void JsonWriter::element(const Json& json) {
    if (!first_) text_ += ',';
    line();
    first_ = false;
    append(json);
}

void JsonWriter::element_as(std::string_view text) {
    if (!first_) text_ += ',';
    line();
    first_ = false;
    text_ += text;
}

std::string JsonWriter::text_within(std::size_t depth, const Json& json) {
    std::string text;
    JsonWriter writer([&](std::string_view piece) { text += piece; });
    writer.depth_ = depth;
    writer.append(json);
    writer.flush(0);
    return text;
}

void JsonWriter::append_list(const Json& json) {
    text_ += '[';
    for (auto item = json.begin(); item != json.end(); ++item) {
        if (item != json.begin()) text_ += ", ";
        append_scalar(text_, *item);
    }
    text_ += ']';
}

void JsonWriter::append(const Json& json) {
    if (!json.is_structured()) return append_scalar(text_, json);
    if (is_list(json)) return append_list(json);
    begin(json.is_object() ? '{' : '[');
    if (json.is_object())
        for (const auto& [name, item] : json.items()) {
            key(name);
            append(item);
        }
    else
        for (const auto& item : json) element(item);
    end(json.is_object() ? '}' : ']');
}

}  // namespace setae::output
