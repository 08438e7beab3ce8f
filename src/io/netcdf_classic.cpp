// SPDX-License-Identifier: GPL-3.0-or-later
#include "netcdf_classic.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "bytes.hpp"
#include "setae/core/errors.hpp"

namespace setae::io {
namespace {

constexpr auto order = std::endian::big;
constexpr std::uint32_t dimension_tag = 0x0a, variable_tag = 0x0b, attribute_tag = 0x0c;

/// Bytes of one value of a type, 0 for a type the format does not know.
std::size_t type_bytes(std::uint32_t type) {
    constexpr std::size_t bytes[] = {0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
    return type < std::size(bytes) ? bytes[type] : 0;
}

constexpr std::uint32_t character = 2;

double load_value(const char* from, std::uint32_t type) {
    switch (type) {
        case 1: return load<std::int8_t>(from, order);
        case 3: return load<std::int16_t>(from, order);
        case 4: return load<std::int32_t>(from, order);
        case 5: return static_cast<double>(load<float>(from, order));
        case 6: return load<double>(from, order);
        case 8: return load<std::uint16_t>(from, order);
        case 9: return load<std::uint32_t>(from, order);
        case 10: return static_cast<double>(load<std::int64_t>(from, order));
        case 11: return static_cast<double>(load<std::uint64_t>(from, order));
        default: return load<std::uint8_t>(from, order);
    }
}

/// Reads a header from front to back and never past its end.
class Cursor {
public:
    Cursor(const std::string& content, const std::string& name) : content_(content), name_(name) {
        version_ = content.size() > 3 ? content[3] : 0;
        at_ = 4;
    }

    [[noreturn]] void fail(const std::string& what) const {
        throw FormatError(name_, {.offset = at_}, fmt::format("NetCDF: {}; the file is damaged or truncated", what));
    }

    std::uint32_t word() { return load<std::uint32_t>(take(4), order); }
    std::uint64_t wide() { return load<std::uint64_t>(take(8), order); }
    std::uint64_t offset() { return version_ == 1 ? word() : wide(); }
    std::uint64_t count() { return version_ == 5 ? wide() : word(); }

    /// Elements of a list, each of which takes at least 8 bytes.
    std::uint64_t list(std::uint32_t tag) {
        const auto got = word();
        const auto n = count();
        if (got == 0 && n == 0) return 0;
        if (got != tag) fail(fmt::format("tag {} in the header, expected {}", got, tag));
        if (n > (content_.size() - at_) / 8) fail(fmt::format("{} entries announced in {} bytes", n, content_.size() - at_));
        return n;
    }

    std::string name() {
        const auto length = count();
        return padded(length);
    }

    /// `length` bytes and what fills them up to a multiple of 4.
    std::string padded(std::uint64_t length) {
        if (length > content_.size()) fail(fmt::format("{} bytes announced", length));
        std::string text(take(length), length);
        take(std::min<std::uint64_t>((4 - length % 4) % 4, content_.size() - at_));
        return text;
    }

private:
    const char* take(std::uint64_t bytes) {
        if (bytes > content_.size() - at_) fail(fmt::format("the header ends {} bytes short", bytes - (content_.size() - at_)));
        const char* from = content_.data() + at_;
        at_ += bytes;
        return from;
    }

    const std::string& content_;
    const std::string& name_;
    char version_ = 0;
    std::uint64_t at_ = 0;
};

std::vector<ClassicNetcdf::Attribute> parse_attributes(Cursor& cursor) {
    std::vector<ClassicNetcdf::Attribute> attributes;
    for (auto left = cursor.list(attribute_tag); left > 0; --left) {
        ClassicNetcdf::Attribute attribute;
        attribute.name = cursor.name();
        const auto type = cursor.word();
        const auto n = cursor.count();
        const auto bytes = type_bytes(type);
        if (bytes == 0 || n > (std::uint64_t{1} << 40)) cursor.fail(fmt::format("attribute '{:.40}' of type {}", attribute.name, type));
        const auto values = cursor.padded(n * bytes);
        if (type == character)
            attribute.text = values.substr(0, values.find('\0'));
        else
            for (std::size_t at = 0; at < values.size(); at += bytes) attribute.numbers.push_back(load_value(values.data() + at, type));
        attributes.push_back(std::move(attribute));
    }
    return attributes;
}

ClassicNetcdf::Variable parse_variable(Cursor& cursor, const std::vector<std::uint64_t>& dimensions) {
    ClassicNetcdf::Variable variable;
    variable.name = cursor.name();
    const auto n = cursor.count();
    if (n > dimensions.size()) cursor.fail(fmt::format("variable '{:.40}' has {} dimensions of {}", variable.name, n, dimensions.size()));
    for (std::uint64_t i = 0; i < n; ++i) {
        const auto id = cursor.count();
        if (id >= dimensions.size() || dimensions[id] == 0 || dimensions[id] > (std::uint64_t{1} << 40))
            cursor.fail(fmt::format("variable '{:.40}' has an unlimited or unknown dimension", variable.name));
        variable.shape.push_back(static_cast<Index>(dimensions[id]));
    }
    variable.attributes = parse_attributes(cursor);
    variable.type = cursor.word();
    if (type_bytes(variable.type) == 0) cursor.fail(fmt::format("variable '{:.40}' of type {}", variable.name, variable.type));
    (void)cursor.count();  // its size in bytes, which follows from shape and type
    variable.offset = cursor.offset();
    return variable;
}

const ClassicNetcdf::Attribute* find_attribute(const ClassicNetcdf::Variable& variable, const std::string& name) {
    for (const auto& attribute : variable.attributes)
        if (attribute.name == name) return &attribute;
    return nullptr;
}

}  // namespace

std::string ClassicNetcdf::Variable::text(const std::string& attribute) const {
    const auto* found = find_attribute(*this, attribute);
    return found ? found->text : std::string{};
}

std::optional<double> ClassicNetcdf::Variable::number(const std::string& attribute) const {
    const auto* found = find_attribute(*this, attribute);
    return found && found->numbers.size() == 1 ? std::optional(found->numbers.front()) : std::nullopt;
}

ClassicNetcdf::ClassicNetcdf(const Source& source) : name_(source.name), content_(source.all()) {
    Cursor cursor(content_, name_);
    (void)cursor.count();  // records along an unlimited dimension
    std::vector<std::uint64_t> dimensions;
    for (auto left = cursor.list(dimension_tag); left > 0; --left) {
        (void)cursor.name();
        dimensions.push_back(cursor.count());
    }
    (void)parse_attributes(cursor);
    for (auto left = cursor.list(variable_tag); left > 0; --left) variables_.push_back(parse_variable(cursor, dimensions));
}

const ClassicNetcdf::Variable* ClassicNetcdf::find(const std::string& name) const {
    for (const auto& variable : variables_)
        if (variable.name == name) return &variable;
    return nullptr;
}

std::vector<double> ClassicNetcdf::values(const Variable& variable) const {
    const auto bytes = type_bytes(variable.type);
    const auto available = variable.offset < content_.size() ? (content_.size() - variable.offset) / bytes : 0;
    std::uint64_t count = 1;
    for (const auto extent : variable.shape) {
        if (count > available / static_cast<std::uint64_t>(extent))
            throw FormatError(name_, {.offset = content_.size()},
                              fmt::format("NetCDF: the file ends here, before the end of '{:.40}'; it is truncated", variable.name));
        count *= static_cast<std::uint64_t>(extent);
    }
    if (count > available)
        throw FormatError(name_, {.offset = content_.size()}, fmt::format("NetCDF: '{:.40}' lies outside the file", variable.name));
    std::vector<double> values(count);
    const char* from = content_.data() + variable.offset;
    for (auto& value : values) {
        value = load_value(from, variable.type);
        from += bytes;
    }
    return values;
}

}  // namespace setae::io
