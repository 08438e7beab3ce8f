// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>
#include <string_view>

#include "setae/core/arrays.hpp"

namespace setae::tests {

/// Puts a file together, number after number.
class ByteBuilder {
public:
    explicit ByteBuilder(std::endian order = std::endian::little) : order_(order) {}

    template <class T>
    ByteBuilder& number(T value) {
        std::array<char, sizeof(T)> bytes{};
        std::memcpy(bytes.data(), &value, sizeof(T));
        if (order_ != std::endian::native) std::reverse(bytes.begin(), bytes.end());
        content_.append(bytes.data(), bytes.size());
        return *this;
    }
    ByteBuilder& text(std::string_view characters) {
        content_ += characters;
        return *this;
    }
    /// A text of fixed width, filled up.
    ByteBuilder& text(std::string_view characters, std::size_t width, char fill = '\0') {
        content_ += characters.substr(0, width);
        content_.append(width - std::min(width, characters.size()), fill);
        return *this;
    }
    /// Zeros up to an offset.
    ByteBuilder& pad_to(std::size_t offset) {
        content_.resize(std::max(offset, content_.size()), '\0');
        return *this;
    }
    /// A number put over what stands at an offset.
    template <class T>
    ByteBuilder& number_at(std::size_t offset, T value) {
        ByteBuilder one(order_);
        one.number(value);
        pad_to(offset + sizeof(T));
        content_.replace(offset, sizeof(T), one.content());
        return *this;
    }
    ByteBuilder& text_at(std::size_t offset, std::string_view characters) {
        pad_to(offset + characters.size());
        content_.replace(offset, characters.size(), characters);
        return *this;
    }
    /// Values h(x, y) row after row from the top, as numbers of type T.
    template <class T>
    ByteBuilder& rows(const Array2D& values) {
        for (Index j = 0; j < values.cols(); ++j)
            for (Index i = 0; i < values.rows(); ++i) number(static_cast<T>(values(i, j)));
        return *this;
    }

    [[nodiscard]] std::size_t size() const { return content_.size(); }
    [[nodiscard]] const std::string& content() const { return content_; }

private:
    std::endian order_;
    std::string content_;
};

}  // namespace setae::tests
