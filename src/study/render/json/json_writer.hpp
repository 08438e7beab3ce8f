// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "setae/output/json.hpp"

namespace setae::output {

/// Writes JSON piece by piece, so that a document need never be in memory as a whole: objects and lists of them
/// indented by two, a list of numbers and texts on one line. Bytes that are no UTF-8 become U+FFFD.
class JsonWriter {
public:
    /// `write` gets the text in pieces of about a megabyte.
    explicit JsonWriter(std::function<void(std::string_view)> write) : write_(std::move(write)) {}

    void begin_object() { begin('{'); }
    void end_object() { end('}'); }
    void begin_array() { begin('['); }
    void end_array() { end(']'); }
    void key(std::string_view name);
    /// Value of the preceding key, or the whole document.
    void value(const Json& json);
    /// Element of the open array.
    void element(const Json& json);
    /// The same made before, on another thread, by text_within().
    void element_as(std::string_view text);
    /// Objects and arrays that were begun and not ended.
    [[nodiscard]] std::size_t depth() const { return depth_; }
    /// An element at a depth of `depth` objects or arrays.
    [[nodiscard]] static std::string text_within(std::size_t depth, const Json& json);

private:
    void begin(char bracket);
    void end(char bracket);
    void line();
    void append(const Json& json);
    void append_list(const Json& json);
    void flush(std::size_t least);
    void finish();

    std::function<void(std::string_view)> write_;
    std::string text_;
    std::size_t depth_ = 0;
    bool first_ = true;  ///< whether it is the first entry of the innermost object or array
};

}  // namespace setae::output
