// SPDX-License-Identifier: GPL-3.0-or-later
#include "gwy_writer.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/quantity_maps.hpp"
#include "writing.hpp"

namespace setae::formats {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written in the byte order of the memory");

/// Components of an object, in sequence. The items of its last array may be elsewhere: `outside` is their number of
/// bytes.
class Object {
public:
    Object& integer(const char* name, std::int32_t value) { return begin(name, 'i').raw(value); }
    Object& real(const char* name, double value) { return begin(name, 'd').raw(value); }
    Object& text(const std::string& name, const std::string& value) {
        begin(name, 's').bytes_ += value.substr(0, value.find('\0')) + '\0';
        return *this;
    }
    Object& object(const std::string& name, const char* type, const Object& value) {
        begin(name, 'o').bytes_ += value.framed(type);
        outside_ += value.outside_;
        return *this;
    }
    /// Numbers in these bytes.
    Object& reals(const char* name, const std::string& numbers) {
        begin(name, 'D').raw(static_cast<std::uint32_t>(numbers.size() / sizeof(double))).bytes_ += numbers;
        return *this;
    }
    /// `count` numbers that follow in bytes outside.
    Object& reals_outside(const char* name, std::uint32_t count) {
        begin(name, 'D').raw(count);
        outside_ += std::uint64_t{count} * sizeof(double);
        return *this;
    }

    /// Bytes including those outside.
    [[nodiscard]] std::uint64_t size() const { return bytes_.size() + outside_; }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }
    [[nodiscard]] std::string framed(const char* type) const {
        const auto size = static_cast<std::uint32_t>(this->size());
        return std::string(type) + '\0' + std::string(reinterpret_cast<const char*>(&size), sizeof(size)) + bytes_;
    }

private:
    Object& begin(const std::string& name, char type) {
        bytes_ += name + '\0' + type;
        return *this;
    }
    template <class Number>
    Object& raw(Number value) {
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof(value));
        return *this;
    }

    std::string bytes_;
    std::uint64_t outside_ = 0;
};

/// A field without its numbers, which come last.
Object field_of(const std::array<Index, 2>& shape, const std::array<double, 2>& size, const std::string& unit_z) {
    Object unit_xy, unit;
    unit_xy.text("unitstr", "m");
    unit.text("unitstr", unit_z);
    Object field;
    field.integer("xres", static_cast<std::int32_t>(shape[0])).integer("yres", static_cast<std::int32_t>(shape[1]));
    field.real("xreal", size[0]).real("yreal", size[1]).real("xoff", 0.0).real("yoff", 0.0);
    return field.object("si_unit_xy", "GwySIUnit", unit_xy).object("si_unit_z", "GwySIUnit", unit);
}

/// A field whose heights are elsewhere.
Object field_outside(const topography::HeightMap& map, const char* unit_z) {
    auto field = field_of(map.shape(), map.size, unit_z);
    return field.reals_outside("data", static_cast<std::uint32_t>(map.heights.size()));
}

constexpr std::uint64_t max_gwy_bytes = std::numeric_limits<std::uint32_t>::max() - (1u << 20);
constexpr const char* undefined_note = "masked, and given the mean height";

Object metadata_of(const topography::Metadata& metadata, bool masked) {
    Object object;
    for (const auto& [key, value] : metadata.attributes)
        if (!key.empty() && key.find('\0') == std::string::npos && key != "mask") object.text(key, value);
    if (!metadata.acquisition_time.empty()) object.text("Date", metadata.acquisition_time);
    if (!metadata.instrument.name.empty()) object.text("Instrument", metadata.instrument.name);
    if (!metadata.instrument.type.empty()) object.text("Instrument type", metadata.instrument.type);
    if (masked) object.text(gwy_undefined_key, undefined_note);
    return object;
}

/// Finite for all heights: replaces undefined ones.
double mean_height(const Array2D& heights) {
    const auto defined = !heights.isNaN();
    const double mean = defined.select(heights, 0.0).sum() / static_cast<double>(defined.count());
    return std::isfinite(mean) ? mean : 0.0;
}

}  // namespace

void write_gwy(const std::string& path, const topography::Measurement& measurement) {
    refuse_trace(measurement, path);
    const auto& map = required_map(measurement, path, "Gwyddion's format");
    const auto points = static_cast<std::uint64_t>(map.heights.size());
    const bool masked = map.heights.isNaN().any();
    Object container;
    container.text("/0/data/title", map.metadata.name)
        .object("/0/meta", "GwyContainer", metadata_of(map.metadata, masked));
    const auto field = field_outside(map, "m"), mask = field_outside(map, "");
    if (points * sizeof(double) * (masked ? 2 : 1) + container.size() > max_gwy_bytes)
        throw InvalidArgument(fmt::format(
            "{}: files of Gwyddion can hold less than 4 GiB, and {} × {} points need more; write the map as "
            ".x3p",
            path, map.heights.rows(), map.heights.cols()));
    const auto heights = row_bytes(map.heights, mean_height(map.heights));
    if (!masked) {
        container.object("/0/data", "GwyDataField", field);
        bytes::write_whole_file(path, {"GWYP", container.framed("GwyContainer"), heights});
        return;
    }
    const auto marks = row_bytes(map.heights.isNaN().cast<double>(), 0.0);
    Object trailer;
    trailer.object("/0/mask", "GwyDataField", mask);
    container.object("/0/data", "GwyDataField", field);
    auto first = container;  // with the size of both
    first.object("/0/mask", "GwyDataField", mask);
    auto framed = first.framed("GwyContainer");
    framed.resize(framed.size() - trailer.bytes().size());
    bytes::write_whole_file(path, {"GWYP", framed, heights, trailer.bytes(), marks});
}

void write_quantity_maps(const std::string& path, const std::vector<QuantityMap>& maps,
                         const std::array<double, 2>& size) {
    if (maps.empty()) throw InvalidArgument(path + ": there is no map to write");
    const std::array<Index, 2> shape{maps.front().values.rows(), maps.front().values.cols()};
    const auto points = static_cast<std::uint64_t>(shape[0] * shape[1]);
    if (2 * points * sizeof(double) * maps.size() > max_gwy_bytes)
        throw InvalidArgument(
            fmt::format("{}: files of Gwyddion can hold less than 4 GiB, and {} maps of {} × {} points need more", path,
                        maps.size(), shape[0], shape[1]));
    Object container;
    for (std::size_t k = 0; k < maps.size(); ++k) {
        const auto& [name, unit, values] = maps[k];
        if (values.rows() != shape[0] || values.cols() != shape[1])
            throw InvalidArgument(fmt::format("{}: '{}' has {} × {} points, but the maps before {} × {}", path, name,
                                              values.rows(), values.cols(), shape[0], shape[1]));
        const auto channel = [k](const char* what) { return fmt::format("/{}/{}", k, what); };
        container.text(channel("data/title"), name)
            .object(channel("data"), "GwyDataField",
                    field_of(shape, size, unit).reals("data", row_bytes(values, mean_height(values))));
        if (!values.isNaN().any()) continue;
        container.object(channel("mask"), "GwyDataField",
                         field_of(shape, size, "").reals("data", row_bytes(values.isNaN().cast<double>(), 0.0)));
        container.object(channel("meta"), "GwyContainer", Object().text(gwy_undefined_key, undefined_note));
    }
    bytes::write_whole_file(path, {"GWYP", container.framed("GwyContainer")});
}

}  // namespace setae::formats
