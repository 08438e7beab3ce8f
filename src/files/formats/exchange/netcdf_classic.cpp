// SPDX-License-Identifier: GPL-3.0-or-later
#include "netcdf_classic.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

#include <fmt/format.h>

#include "setae/bytes/cursor.hpp"
#include "setae/bytes/stored_numbers.hpp"
#include "setae/core/errors.hpp"

namespace setae::formats {
namespace {

constexpr std::uint32_t character = 2;
constexpr std::uint64_t max_values = std::uint64_t{1} << 40;  // along a dimension, or of an attribute
constexpr std::size_t max_dimensions_of_netcdf = 1024;        // of a variable, the limit of the library

/// The types in the order of their numbers, characters as bytes.
constexpr Sample netcdf_samples[] = {Sample::int8,   Sample::int8,    Sample::uint8,   Sample::int16,
                                     Sample::int32,  Sample::float32, Sample::float64, Sample::uint8,
                                     Sample::uint16, Sample::uint32,  Sample::int64,   Sample::uint64};

/// Walks through a header.
class NetcdfHeader {
public:
    explicit NetcdfHeader(const bytes::Source& source)
        : cursor_(source, "NetCDF", 3, std::endian::big), version_(cursor_.number<std::uint8_t>()) {}

    [[noreturn]] void fail(const std::string& what) const { cursor_.fail(what + "; the file is damaged"); }
    std::uint32_t word() { return cursor_.number<std::uint32_t>(); }
    std::uint64_t offset() { return version_ == 1 ? word() : cursor_.number<std::uint64_t>(); }
    std::uint64_t count() { return version_ == 5 ? cursor_.number<std::uint64_t>() : word(); }
    [[nodiscard]] bool is_streaming(std::uint64_t records) const {
        return records == (version_ == 5 ? ~std::uint64_t{0} : 0xffffffffu);
    }

    /// Elements of a list, each of which takes at least 8 bytes.
    std::uint64_t list(std::uint32_t tag) {
        const auto got = word();
        const auto n = count();
        if (got == 0 && n == 0) return 0;
        if (got != tag) fail(fmt::format("tag {} in the header, expected {}", got, tag));
        if (n > cursor_.remaining() / 8) cursor_.skip(8 * std::min(n, max_values));
        return n;
    }

    std::string name() { return padded(count()); }

    /// `length` bytes and the padding to a multiple of 4.
    std::string padded(std::uint64_t length) {
        auto text = cursor_.bytes(length);
        cursor_.skip(std::min<std::uint64_t>((4 - length % 4) % 4, cursor_.remaining()));
        return text;
    }

    Sample sample() {
        type_ = word();
        if (type_ == 0 || type_ >= std::size(netcdf_samples)) fail(fmt::format("values of type {}", type_));
        return netcdf_samples[type_];
    }
    [[nodiscard]] bool was_character() const { return type_ == character; }

private:
    bytes::Cursor cursor_;
    std::uint8_t version_;
    std::uint32_t type_ = 0;
};

Attributes parse_attributes(NetcdfHeader& header) {
    Attributes attributes;
    for (auto left = header.list(attribute_tag); left > 0; --left) {
        Attribute attribute;
        attribute.name = header.name();
        const auto sample = header.sample();
        const bool text = header.was_character();
        const auto n = header.count();
        if (n > max_values) header.fail(fmt::format("attribute '{:.40}' of {} values", attribute.name, n));
        const auto values = header.padded(n * bytes_of(sample));
        if (text) attribute.text = values.substr(0, values.find('\0'));
        else
            for (std::size_t at = 0; at < values.size(); at += bytes_of(sample))
                attribute.numbers.push_back(loaded(values.data() + at, sample, std::endian::big));
        attributes.push_back(std::move(attribute));
    }
    return attributes;
}

/// A variable as in the header: its extent along the unlimited dimension is 0.
struct Variable {
    StoredArray array;
    bool is_character = false;
    bool has_records = false;
    std::uint64_t record_bytes = 0;  ///< of its part of a record, without padding

    [[nodiscard]] std::uint64_t padded_bytes() const { return (record_bytes + 3) / 4 * 4; }
};

Variable parse_variable(NetcdfHeader& header, const std::vector<std::uint64_t>& dimensions,
                        const bytes::Source& source) {
    Variable variable;
    auto& array = variable.array;
    array.name = header.name();
    const auto n = header.count();
    if (n > max_dimensions_of_netcdf) header.fail(fmt::format("variable '{:.40}' has {} dimensions", array.name, n));
    std::uint64_t values = 1;
    for (std::uint64_t i = 0; i < n; ++i) {
        const auto id = header.count();
        if (id >= dimensions.size() || dimensions[id] > max_values)
            header.fail(fmt::format("variable '{:.40}' has an unknown dimension", array.name));
        const auto extent = dimensions[id];
        if (extent == 0 && i > 0)
            header.fail(fmt::format("variable '{:.40}' has the unlimited dimension after others", array.name));
        variable.has_records = variable.has_records || extent == 0;
        if (extent > 0 && values > max_values / extent)
            header.fail(fmt::format("variable '{:.40}' has more than {} values", array.name, max_values));
        values *= extent == 0 ? 1 : extent;
        array.shape.push_back(static_cast<Index>(extent));
    }
    array.attributes = parse_attributes(header);
    array.sample = header.sample();
    array.order = std::endian::big;
    variable.is_character = header.was_character();
    variable.record_bytes = values * bytes_of(array.sample);
    (void)header.count();  // its size in bytes, which follows from shape and type
    array.offset = header.offset();
    array.data = source;
    return variable;
}

/// Records in sequence: the parts of all variables, each padded to four bytes unless it is the only one.
void place_records(std::vector<Variable>& variables, std::uint64_t records, const NetcdfHeader& header) {
    std::uint64_t together = 0, number = 0, single = 0;
    for (const auto& variable : variables) {
        if (!variable.has_records) continue;
        ++number;
        single = variable.record_bytes;
        together += variable.padded_bytes();
        if (together > max_values) header.fail(fmt::format("records of more than {} bytes", max_values));
    }
    if (number > 0 && header.is_streaming(records))
        header.fail("the number of records was never written: copy the file with nccopy");
    for (auto& variable : variables) {
        if (!variable.has_records) continue;
        variable.array.shape[0] = static_cast<Index>(std::min(records, max_values));
        variable.array.first_distance = number == 1 ? single : together;
    }
}

}  // namespace

const StoredArray* ArrayFile::find(const std::string& name) const {
    const auto found =
        std::find_if(arrays.begin(), arrays.end(), [&](const StoredArray& array) { return array.name == name; });
    return found == arrays.end() ? nullptr : &*found;
}

ArrayFile classic_netcdf(const bytes::Source& source) {
    NetcdfHeader header(source);
    const auto records = header.count();
    std::vector<std::uint64_t> dimensions;
    for (auto left = header.list(dimension_tag); left > 0; --left) {
        (void)header.name();
        dimensions.push_back(header.count());
    }
    ArrayFile file{parse_attributes(header), {}};
    std::vector<Variable> variables;
    for (auto left = header.list(variable_tag); left > 0; --left)
        variables.push_back(parse_variable(header, dimensions, source));
    place_records(variables, records, header);
    for (auto& variable : variables)
        if (!variable.is_character) file.arrays.push_back(std::move(variable.array));
    return file;
}

}  // namespace setae::formats
