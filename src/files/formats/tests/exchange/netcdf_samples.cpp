// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdint>
#include <utility>

#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "hdf5_builder.hpp"
#include "setae/core/constants.hpp"

// Built from the specification of the classic format: magic and version, records, dimensions, attributes, variables,
// values; all big-endian, counts 4 bytes wide, 8 in version 5; offsets 4 bytes wide in version 1, otherwise 8.
using namespace setae::tests;

namespace setae::formats::tests {
namespace {

class Classic {
public:
    explicit Classic(int version) : version_(version) {}

    Classic& dimension(const std::string& name, std::uint64_t extent) {
        dimensions_.emplace_back(name, extent);
        return *this;
    }
    static std::string text_attribute(const Classic& file, const std::string& name, const std::string& text) {
        ByteBuilder part(std::endian::big);
        file.name(part, name);
        part.number(std::uint32_t{2});
        file.name(part, text);
        return part.content();
    }
    static std::string number_attribute(const Classic& file, const std::string& name, double number) {
        ByteBuilder part(std::endian::big);
        file.name(part, name);
        part.number(std::uint32_t{6});
        file.count(part, 1);
        return part.number(number).content();
    }
    Classic& about(const std::string& attribute) {
        attributes_.push_back(attribute);
        return *this;
    }
    /// `values` as in the file; for a record variable those of the records in sequence, each of `record` bytes.
    Classic& variable(const std::string& name, std::uint32_t type, std::vector<std::uint32_t> dimensions,
                      std::vector<std::string> attributes, std::string values, std::size_t record = 0) {
        variables_.push_back({name, type, std::move(dimensions), std::move(attributes), std::move(values), record});
        return *this;
    }
    [[nodiscard]] std::string content() const {
        auto header = header_with({});
        std::vector<std::uint64_t> offsets;
        auto at = header.size();
        for (const auto& variable : variables_)
            if (!variable.record) {
                offsets.push_back(at);
                at += padded(variable.values.size());
            }
        const auto records_at = at;
        for (const auto& variable : variables_)
            if (variable.record) {
                offsets.push_back(at);
                at += padded(variable.record);
            }
        header = header_with(offsets);
        for (const auto& variable : variables_)
            if (!variable.record)
                header += variable.values + std::string(padded(variable.values.size()) - variable.values.size(), '\0');
        if (at == records_at) return header;
        for (std::uint64_t record = 0; record < records(); ++record)
            for (const auto& variable : variables_)
                if (variable.record)
                    header += variable.values.substr(record * variable.record, variable.record) +
                              std::string(padded(variable.record) - variable.record, '\0');
        return header;
    }
    void count(ByteBuilder& part, std::uint64_t number) const {
        if (version_ == 5) part.number(number);
        else part.number(static_cast<std::uint32_t>(number));
    }
    void name(ByteBuilder& part, const std::string& text) const {
        count(part, text.size());
        part.text(text, padded(text.size()));
    }

private:
    struct Variable {
        std::string name;
        std::uint32_t type;
        std::vector<std::uint32_t> dimensions;
        std::vector<std::string> attributes;
        std::string values;
        std::size_t record;
    };

    static std::uint64_t padded(std::uint64_t bytes) { return (bytes + 3) / 4 * 4; }
    [[nodiscard]] std::uint64_t records() const {
        for (const auto& variable : variables_)
            if (variable.record) return variable.values.size() / variable.record;
        return 0;
    }
    void list(ByteBuilder& part, std::uint32_t tag, std::uint64_t entries) const {
        part.number(entries ? tag : std::uint32_t{0});
        count(part, entries);
    }
    /// The header; record variables come last, and offsets in the order of variables (zero if not given).
    [[nodiscard]] std::string header_with(const std::vector<std::uint64_t>& offsets) const {
        ByteBuilder part(std::endian::big);
        part.text("CDF").number(static_cast<std::uint8_t>(version_));
        count(part, records());
        list(part, 10, dimensions_.size());
        for (const auto& [title, extent] : dimensions_) {
            name(part, title);
            count(part, extent);
        }
        list(part, 12, attributes_.size());
        for (const auto& attribute : attributes_) part.text(attribute);
        list(part, 11, variables_.size());
        for (std::size_t k = 0; k < variables_.size(); ++k) {
            const auto& variable = variables_[k];
            name(part, variable.name);
            count(part, variable.dimensions.size());
            for (const auto id : variable.dimensions) count(part, id);
            list(part, 12, variable.attributes.size());
            for (const auto& attribute : variable.attributes) part.text(attribute);
            part.number(variable.type);
            count(part, variable.record ? variable.record : variable.values.size());
            const auto offset = k < offsets.size() ? offsets[k] : 0;
            if (version_ == 1) part.number(static_cast<std::uint32_t>(offset));
            else part.number(offset);
        }
        return part.content();
    }

    int version_;
    std::vector<std::pair<std::string, std::uint64_t>> dimensions_;
    std::vector<std::string> attributes_;
    std::vector<Variable> variables_;
};

template <class T, class Values>
std::string bytes_as(const Values& values) {
    ByteBuilder part(std::endian::big);
    for (Index i = 0; i < values.size(); ++i) part.number(static_cast<T>(values.data()[i]));
    return part.content();
}

/// An axis of n points `step` apart with its extent.
std::string positions(Index n, double step) {
    return bytes_as<double>(Array1D(step * Array1D::LinSpaced(n, 0.0, static_cast<double>(n - 1))));
}

constexpr const char* info =
    R"({"instrument": {"name": "NewView", "type": "optical", "parameters": {"tip_radius": {"value": 10.0, "unit": "nm"}}}, "acquisition_time": "2020-01-02 03:04:05", "operator": "A. B."})";

/// A map of 6 × 4 points in nm, masked at (3, 2) and of the fill value at (1, 1).
FormatSample map_sample(int version) {
    Array2D map = lopsided_heights(6, 4, 1.0);
    Array2D mask = Array2D::Zero(6, 4);
    mask(3, 2) = 1.0;
    map(1, 1) = -999.0;
    Classic file(version);
    file.dimension("x", 6).dimension("y", 4).about(Classic::text_attribute(file, "json", info));
    const auto axis = [&](double length) {
        return std::vector<std::string>{Classic::number_attribute(file, "length", length),
                                        Classic::number_attribute(file, "periodic", 1.0),
                                        Classic::text_attribute(file, "unit", "um")};
    };
    file.variable("mask", 1, {0, 1}, {}, bytes_as<std::int8_t>(mask))
        .variable("x", 6, {0}, axis(3.0), positions(6, 0.5));
    file.variable("y", 6, {1}, axis(1.0), positions(4, 0.25));
    file.variable("heights", 5, {0, 1},
                  {Classic::text_attribute(file, "unit", "nm"), Classic::number_attribute(file, "_FillValue", -999.0)},
                  bytes_as<float>(map));
    map(3, 2) = map(1, 1) = std::nan("");
    return {.format = "nc",
            .name = "map, version " + std::to_string(version),
            .content = file.content(),
            .shape = {6, 4},
            .size = {3e-6, 1e-6},
            .heights = map * units::nm};
}

/// The first index unlimited, its records padded: 3 heights of int16 and a byte between.
FormatSample records_sample() {
    const auto map = lopsided_heights(5, 3, 1.0);
    Classic file(2);
    file.dimension("x", 0).dimension("y", 3);
    file.variable("y", 6, {1},
                  {Classic::number_attribute(file, "length", 3.0), Classic::text_attribute(file, "unit", "um")},
                  positions(3, 1.0));
    file.variable("heights", 3, {0, 1},
                  {Classic::text_attribute(file, "unit", "nm"), Classic::number_attribute(file, "scale_factor", 0.5),
                   Classic::number_attribute(file, "add_offset", 7.0)},
                  bytes_as<std::int16_t>(map), 6);
    file.variable("x", 6, {0},
                  {Classic::number_attribute(file, "length", 5.0), Classic::text_attribute(file, "unit", "um")},
                  positions(5, 1.0), 8);
    return {.format = "nc",
            .name = "records",
            .content = file.content(),
            .shape = {5, 3},
            .size = {5e-6, 3e-6},
            .heights = (0.5 * map + 7.0) * units::nm};
}

FormatSample unequal_steps_sample() {
    const Array1D x{{0.0, 1.0, 1.5, 4.0}};
    Array2D heights(4, 1);
    heights << 3.0, 1.0, 2.0, 5.0;
    Classic file(1);
    file.dimension("n", 4);
    file.variable("x", 6, {0}, {Classic::text_attribute(file, "unit", "um")}, bytes_as<double>(x));
    file.variable("heights", 6, {0}, {Classic::text_attribute(file, "unit", "nm")}, bytes_as<double>(heights));
    return {.format = "nc",
            .name = "unequal steps",
            .content = file.content(),
            .shape = {4},
            .size = {4e-6},
            .heights = heights * units::nm};
}

/// NetCDF-4: dimensions are datasets, y one without values.
FormatSample version4_sample() {
    const auto map = lopsided_heights(6, 4, 1.0);
    Hdf5Builder file({.newest = true});
    file.dataset("/x", H5T_IEEE_F64LE, {6}, {0.0, 0.5, 1.0, 1.5, 2.0, 2.5})
        .attribute("/x", "length", std::vector<double>{3.0});
    file.attribute("/x", "unit", std::string("um")).attribute("/x", "periodic", std::vector<double>{1.0});
    file.dataset("/y", H5T_IEEE_F64LE, {4}, {0.0, 0.25, 0.5, 0.75})
        .variable_text("/y", "unit", "um")
        .variable_text("/y", "CLASS", "DIMENSION_SCALE");
    file.dataset("/heights", H5T_IEEE_F32LE, {6, 4}, first_index_x(map),
                 {.chunk = {3, 4}, .shuffled = true, .deflated = true});
    file.variable_text("/heights", "unit", "nm").variable_text("/", "_NCProperties", "version=2");
    return {.format = "nc",
            .name = "version 4, packed",
            .content = file.bytes(),
            .shape = {6, 4},
            .size = {3e-6, 1e-6},
            .heights = map * units::nm};
}

}  // namespace

std::vector<FormatSample> netcdf_samples() {
    return {map_sample(1), map_sample(2), map_sample(5), records_sample(), unequal_steps_sample(), version4_sample()};
}

}  // namespace setae::formats::tests
