// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "byte_builder.hpp"

/// Entries of Vision64's tree, byte by byte: a name, a type, the content.
namespace setae::formats::tests::vca {

using namespace setae::tests;

inline std::string name(std::string_view text) {
    return ByteBuilder().number(static_cast<std::uint32_t>(text.size())).text(text).content();
}

/// A length in the minimum number of bytes, and the content of that length.
inline std::string sized(const std::string& content) {
    ByteBuilder bytes;
    if (content.size() < 256) bytes.number<std::uint8_t>(1).number(static_cast<std::uint8_t>(content.size()));
    else if (content.size() < 65536) bytes.number<std::uint8_t>(2).number(static_cast<std::uint16_t>(content.size()));
    else bytes.number<std::uint8_t>(4).number(static_cast<std::uint32_t>(content.size()));
    return bytes.text(content).content();
}

inline std::string item(std::string_view title, unsigned type, const std::string& content) {
    return ByteBuilder().text(name(title)).number(static_cast<std::uint8_t>(type)).text(content).content();
}

template <class T>
std::string number(std::string_view title, unsigned type, T value) {
    return item(title, type, ByteBuilder().number(value).content());
}

inline std::string string(std::string_view title, const std::string& text) { return item(title, 0x12, sized(text)); }

inline std::string quantity(std::string_view title, double value, const std::string& unit, const std::string& symbol) {
    ByteBuilder content;
    content.number(value)
        .text(name(unit))
        .text(name(symbol))
        .number(1e6)
        .number<std::int32_t>(1)
        .number<std::int32_t>(0)
        .number<std::int32_t>(0);
    return item(title, 0x13, sized(content.content()));
}

inline std::string container(std::string_view title, std::initializer_list<std::string> items, unsigned type = 0x7d) {
    std::string content;
    for (const auto& one : items) content += one;
    return item(title, type, sized(content + item("", 0x7f, "\xff\xff")));
}

inline std::string string_list(std::string_view title, std::initializer_list<std::string_view> texts) {
    std::string content;
    for (const auto text : texts) content += name(text);
    return item(title, 0x42, name("vector<wstring>") + sized(content));
}

/// Elements of 8 bytes and type 0x0d, or of 4 and 0x0c.
template <class T>
std::string array(std::string_view title, const Array1D& values) {
    ByteBuilder content;
    content.number<std::uint8_t>(sizeof(T) == 8 ? 0x0d : 0x0c).number<std::uint32_t>(sizeof(T));
    for (const double value : values) content.number(static_cast<T>(value));
    return item(title, 0x40, name("double * __ptr64") + sized(content.content()));
}

/// Rows first, then columns; values row after row.
template <class T>
std::string matrix(std::string_view title, const Array2D& values, bool anonymous) {
    ByteBuilder content;
    content.number(static_cast<std::uint32_t>(values.cols()))
        .number(static_cast<std::uint32_t>(values.rows()))
        .rows<T>(values);
    if (anonymous) return item(title, 0x45, name("Matrix<float>") + sized(content.content()));
    return item(title, 0x00,
                name("Matrix<float>") + ByteBuilder().number<std::uint32_t>(0).content() + name("Matrix") +
                    sized(content.content()));
}

}  // namespace setae::formats::tests::vca
