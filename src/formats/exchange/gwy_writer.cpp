// SPDX-License-Identifier: GPL-3.0-or-later
#include "gwy_writer.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "writing.hpp"

namespace setae::formats {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as the memory holds them");

/// Components of an object, one after another. The items of its last array may stand elsewhere: `outside` tells their
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
    /// `count` numbers whose bytes follow what is here.
    Object& reals_outside(const char* name, std::uint32_t count) {
        begin(name, 'D').raw(count);
        outside_ += std::uint64_t{count} * sizeof(double);
        return *this;
    }

    /// Bytes with those outside.
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

/// A field but for its heights, which stand last.
Object field_of(const topography::HeightMap& map, const char* unit_z) {
    Object unit_xy, unit;
    unit_xy.text("unitstr", "m");
    unit.text("unitstr", unit_z);
    const auto [nx, ny] = map.shape();
    Object field;
    field.integer("xres", static_cast<std::int32_t>(nx)).integer("yres", static_cast<std::int32_t>(ny));
    field.real("xreal", map.size[0]).real("yreal", map.size[1]).real("xoff", 0.0).real("yoff", 0.0);
    field.object("si_unit_xy", "GwySIUnit", unit_xy).object("si_unit_z", "GwySIUnit", unit);
    return field.reals_outside("data", static_cast<std::uint32_t>(nx * ny));
}

Object metadata_of(const topography::Metadata& metadata, bool masked) {
    Object object;
    for (const auto& [key, value] : metadata.attributes)
        if (!key.empty() && key.find('\0') == std::string::npos && key != "mask") object.text(key, value);
    if (!metadata.acquisition_time.empty()) object.text("Date", metadata.acquisition_time);
    if (!metadata.instrument.name.empty()) object.text("Instrument", metadata.instrument.name);
    if (!metadata.instrument.type.empty()) object.text("Instrument type", metadata.instrument.type);
    if (masked) object.text(gwy_undefined_key, "masked, and given the mean height");
    return object;
}

/// Finite whatever the heights are: what stands where none is defined.
double mean_height(const Array2D& heights) {
    const auto defined = heights == heights;
    const double mean = defined.select(heights, 0.0).sum() / static_cast<double>(defined.count());
    return std::isfinite(mean) ? mean : 0.0;
}

}  // namespace

void write_gwy(const std::string& path, const topography::Measurement& measurement) {
    refuse_trace(measurement, path);
    const auto& map = required_map(measurement, path, "Gwyddion's format");
    const auto points = static_cast<std::uint64_t>(map.heights.size());
    const bool masked = map.heights.isNaN().any();
    constexpr std::uint64_t room = std::numeric_limits<std::uint32_t>::max() - (1u << 20);
    Object container;
    container.text("/0/data/title", map.metadata.name)
        .object("/0/meta", "GwyContainer", metadata_of(map.metadata, masked));
    const auto field = field_of(map, "m"), mask = field_of(map, "");
    if (points * sizeof(double) * (masked ? 2 : 1) + container.size() > room)
        throw InvalidArgument(
            fmt::format("{}: Gwyddion's files hold less than 4 GiB, {} × {} points need more; write it as .x3p", path,
                        map.heights.rows(), map.heights.cols()));
    const auto heights = row_bytes(map.heights, mean_height(map.heights));
    if (!masked) {
        container.object("/0/data", "GwyDataField", field);
        bytes::write_whole_file(path, {"GWYP", container.framed("GwyContainer"), heights});
        return;
    }
    const auto marks = row_bytes(map.heights.isNaN().cast<double>(), 0.0);
    Object behind;
    behind.object("/0/mask", "GwyDataField", mask);
    container.object("/0/data", "GwyDataField", field);
    auto first = container;  // with the size of both
    first.object("/0/mask", "GwyDataField", mask);
    auto framed = first.framed("GwyContainer");
    framed.resize(framed.size() - behind.bytes().size());
    bytes::write_whole_file(path, {"GWYP", framed, heights, behind.bytes(), marks});
}

}  // namespace setae::formats
