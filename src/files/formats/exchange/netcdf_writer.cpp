// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/formats/netcdf.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "netcdf_classic.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::formats {
namespace {

enum Type : std::uint32_t { byte = 1, characters = 2, float64 = 6 };
constexpr std::uint64_t max_bytes = 0xFFFFFFFCU;  // of a variable

template <class T>
void append(std::string& bytes, T value) {
    for (int shift = 8 * (static_cast<int>(sizeof(T)) - 1); shift >= 0; shift -= 8)
        bytes += static_cast<char>((value >> shift) & 0xFF);
}

void append(std::string& bytes, double number) { append(bytes, std::bit_cast<std::uint64_t>(number)); }

void append(std::string& bytes, const std::string& text) {
    append(bytes, static_cast<std::uint32_t>(text.size()));
    bytes += text + std::string((4 - text.size() % 4) % 4, '\0');
}

/// A list of a header: kind, number of elements, elements.
struct List {
    std::uint32_t tag = 0, count = 0;
    std::string elements{};

    [[nodiscard]] std::string bytes() const {
        std::string all;
        append(all, count > 0 ? tag : 0);
        append(all, count);
        return all + elements;
    }
};

/// A dataset of the classic model with offsets of 64 bits; all numbers big-endian.
/// Source: NetCDF Users Guide, appendix B.
class Dataset {
public:
    explicit Dataset(std::string name) : name_(std::move(name)) {}

    /// The number of a dimension.
    std::uint32_t dimension(const std::string& name, Index length) {
        refuse_name(name, dimension_names_);
        append(dimensions_.elements, name);
        append(dimensions_.elements, static_cast<std::uint32_t>(length));
        return dimensions_.count++;
    }

    class Variable {
    public:
        void put(const std::string& name, double number) {
            begin(name, float64, 1);
            append(attributes_.elements, number);
        }
        void put(const std::string& name, const std::string& text) {
            begin(name, characters, {});
            append(attributes_.elements, text);
        }

    private:
        friend class Dataset;
        void begin(const std::string& name, Type type, std::optional<std::uint32_t> count) {
            append(attributes_.elements, name);
            append(attributes_.elements, static_cast<std::uint32_t>(type));
            if (count) append(attributes_.elements, *count);
            ++attributes_.count;
        }

        std::string head_;  ///< name and dimensions
        List attributes_{attribute_tag};
        Type type_ = float64;
        std::string values_;
    };

    Variable& variable(const std::string& name, std::span<const std::uint32_t> dimensions, const ArrayView1D& values) {
        auto& made = begin(name, dimensions, float64, 8 * static_cast<std::uint64_t>(values.size()));
        for (const double value : values) append(made.values_, value);
        return made;
    }
    /// One byte per value, 1 if it is undefined.
    void mask(const std::string& name, std::span<const std::uint32_t> dimensions, const ArrayView1D& values) {
        auto& made = begin(name, dimensions, byte, static_cast<std::uint64_t>(values.size()) + 3);
        for (const double value : values) made.values_ += std::isnan(value) ? '\1' : '\0';
        made.values_.resize((made.values_.size() + 3) / 4 * 4, '\x81');  // the fill value of the format
    }
    void put(const std::string& name, const std::string& text) { about_.put(name, text); }

    [[nodiscard]] std::string bytes() const {
        const std::string before = std::string("CDF\2\0\0\0\0", 8) + dimensions_.bytes() + about_.attributes_.bytes();
        List list{variable_tag};
        std::uint64_t begin = before.size() + 8;
        for (const auto& variable : variables_)
            begin += variable.head_.size() + variable.attributes_.bytes().size() + 4 + 4 + 8;
        for (const auto& variable : variables_) {
            list.elements += variable.head_ + variable.attributes_.bytes();
            append(list.elements, static_cast<std::uint32_t>(variable.type_));
            append(list.elements, static_cast<std::uint32_t>(variable.values_.size()));
            append(list.elements, begin);
            begin += variable.values_.size();
            ++list.count;
        }
        std::string file = before + list.bytes();
        file.reserve(begin);
        for (const auto& variable : variables_) file += variable.values_;
        return file;
    }

private:
    Variable& begin(const std::string& name, std::span<const std::uint32_t> dimensions, Type type,
                    std::uint64_t bytes) {
        refuse_name(name, variable_names_);
        if (bytes > max_bytes)
            throw InvalidArgument(
                fmt::format("{}: NetCDF: '{}' needs {} bytes; a variable may have {}", name_, name, bytes, max_bytes));
        auto& made = variables_.emplace_back();
        made.type_ = type;
        append(made.head_, name);
        append(made.head_, static_cast<std::uint32_t>(dimensions.size()));
        for (const auto dimension : dimensions) append(made.head_, dimension);
        made.values_.reserve(bytes);
        return made;
    }
    void refuse_name(const std::string& name, std::vector<std::string>& taken) const {
        const bool sound =
            !name.empty() && name.back() != ' ' && std::all_of(name.begin(), name.end(), [](unsigned char letter) {
                return letter >= ' ' && letter != '/' && letter != 127;
            });
        if (!sound) throw InvalidArgument(fmt::format("{}: NetCDF: '{}' is not a valid name", name_, name));
        if (std::find(taken.begin(), taken.end(), name) != taken.end())
            throw InvalidArgument(fmt::format("{}: NetCDF: two variables are named '{}'", name_, name));
        taken.push_back(name);
    }

    std::string name_;
    std::vector<std::string> dimension_names_, variable_names_;
    List dimensions_{dimension_tag};
    Variable about_;  ///< contains the global attributes
    std::vector<Variable> variables_;
};

/// The length unit of written files, with an ASCII name for readers of old NetCDF.
struct WrittenUnit {
    std::string name;
    double factor = 1.0;  ///< to metres
};

WrittenUnit written_unit(const std::string& unit) {
    const double factor = unit_factor(unit, dimension::length);
    if (unit == "µm" || unit == "μm" || unit == "~m") return {"um", factor};
    if (unit == "Å") return {"A", factor};
    return {unit, factor};
}

/// A coordinate with its dimension.
struct Axis {
    const char* name;
    const char* dimension;
    Array1D positions;
    std::optional<double> length;  ///< only for equal steps
    bool periodic;
};

Axis equidistant(const char* name, Index points, double length, bool periodic) {
    return {name, name,
            length / static_cast<double>(points) * Array1D::LinSpaced(points, 0.0, static_cast<double>(points - 1)),
            length, periodic};
}

/// Adds coordinates in a unit. @returns the numbers of their dimensions.
std::vector<std::uint32_t> put_axes(Dataset& dataset, std::span<const Axis> axes, const WrittenUnit& unit) {
    std::vector<std::uint32_t> dimensions;
    for (const auto& axis : axes) {
        dimensions.push_back(dataset.dimension(axis.dimension, axis.positions.size()));
        auto& variable = dataset.variable(axis.name, std::span(&dimensions.back(), 1), axis.positions / unit.factor);
        variable.put("unit", unit.name);
        if (!axis.length) continue;
        variable.put("length", *axis.length / unit.factor);
        variable.put("periodic", axis.periodic ? 1.0 : 0.0);
    }
    return dimensions;
}

/// Heights and coordinates of a topography in the layout of the topography reader. Undefined points are NaN and, if
/// there are any, marked in a variable "mask".
class HeightsWriter {
public:
    HeightsWriter(Dataset& dataset, WrittenUnit unit) : dataset_(dataset), unit_(std::move(unit)) {}

    void operator()(const topography::HeightMap& map) const {
        const auto [nx, ny] = map.shape();
        const Axis axes[] = {equidistant("x", nx, map.size[0], map.periodic),
                             equidistant("y", ny, map.size[1], map.periodic)};
        write(axes, Eigen::Map<const Array1D>(map.heights.data(), map.heights.size()));
    }
    void operator()(const topography::LineScan& scan) const {
        const Axis axes[] = {equidistant("x", scan.heights.size(), scan.size, scan.periodic)};
        write(axes, scan.heights);
    }
    void operator()(const topography::Profile& profile) const {
        const Axis axes[] = {{"x", "n", profile.positions, {}, false}};
        write(axes, profile.heights);
    }

private:
    void write(std::span<const Axis> axes, const ArrayView1D& heights) const {
        const auto dimensions = put_axes(dataset_, axes, unit_);
        dataset_.variable("heights", dimensions, heights / unit_.factor).put("unit", unit_.name);
        if (heights.isNaN().any()) dataset_.mask("mask", dimensions, heights);
    }

    Dataset& dataset_;
    WrittenUnit unit_;
};

}  // namespace

std::string netcdf_content(const topography::Measurement& measurement, const std::string& unit) {
    Dataset dataset(topography::label(topography::metadata(measurement)));
    std::visit(HeightsWriter(dataset, written_unit(unit)), measurement);
    return dataset.bytes();
}

void write_netcdf(const std::string& path, const topography::Measurement& measurement) {
    bytes::write_whole_file(path, netcdf_content(measurement));
}

void write_netcdf(const std::string& path, std::span<const GridMap> maps, const std::array<double, 2>& size,
                  bool periodic) {
    if (maps.empty()) throw InvalidArgument(path + ": NetCDF: no map; expected at least one");
    const auto rows = maps.front().values.rows(), columns = maps.front().values.cols();
    for (const auto& map : maps)
        if (map.values.rows() != rows || map.values.cols() != columns)
            throw InvalidArgument(fmt::format("{}: NetCDF: map '{}' has {} x {} points; expected {} x {}", path,
                                              map.name, map.values.rows(), map.values.cols(), rows, columns));
    Dataset dataset(path);
    const Axis axes[] = {equidistant("x", rows, size[0], periodic), equidistant("y", columns, size[1], periodic)};
    const auto dimensions = put_axes(dataset, axes, {"m"});
    for (const auto& map : maps)
        dataset.variable(map.name, dimensions, Eigen::Map<const Array1D>(map.values.data(), map.values.size()))
            .put("units", map.unit);
    bytes::write_whole_file(path, dataset.bytes());
}

void write_netcdf(const std::string& path, const Table& table) {
    for (const auto& column : table.columns)
        if (column.values.size() != table.rows())
            throw InvalidArgument(fmt::format("{}: column '{}' has {} rows, expected {}", path, column.name,
                                              column.values.size(), table.rows()));
    Dataset dataset(path);
    const auto rows = dataset.dimension("row", table.rows());
    for (const auto& column : table.columns) {
        auto& variable = dataset.variable(column.name, std::span(&rows, 1), column.values);
        variable.put("units", column.unit);
        variable.put("long_name", column.name);
    }
    for (const auto& [key, value] : table.metadata) dataset.put(key, value);
    bytes::write_whole_file(path, dataset.bytes());
}

}  // namespace setae::formats
