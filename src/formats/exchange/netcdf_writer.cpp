// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/formats/netcdf.hpp"

#include <netcdf.h>
#include <netcdf_mem.h>

#include <cstdlib>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::formats {
namespace {

/// A NetCDF dataset being written in memory.
class Dataset {
public:
    explicit Dataset(std::string path) : path_(std::move(path)) {
        check(nc_create_mem(path_.c_str(), NC_64BIT_OFFSET, 0, &id_));
    }
    Dataset(const Dataset&) = delete;
    Dataset& operator=(const Dataset&) = delete;
    ~Dataset() {
        if (id_ >= 0) nc_abort(id_);
    }

    [[nodiscard]] int id() const { return id_; }

    void check(int status) const {
        if (status != NC_NOERR) throw InvalidArgument(fmt::format("{}: NetCDF: {}", path_, nc_strerror(status)));
    }

    void put_number(int variable, const char* name, double number) const {
        check(nc_put_att_double(id_, variable, name, NC_DOUBLE, 1, &number));
    }
    void put_text(int variable, const char* name, const std::string& text) const {
        check(nc_put_att_text(id_, variable, name, text.size(), text.data()));
    }

    /// Closes and gives up the bytes written.
    [[nodiscard]] std::string release() {
        NC_memio memory{};
        check(nc_close_memio(std::exchange(id_, -1), &memory));
        const std::unique_ptr<void, decltype(&std::free)> owned(memory.memory, &std::free);
        return {static_cast<const char*>(memory.memory), memory.size};
    }

private:
    std::string path_;
    int id_ = -1;
};

/// The length unit that files are written in, its name in ASCII as readers of old NetCDF want it.
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

/// A topography's heights and coordinates, as the reader of topographies expects them. Undefined points are NaN and,
/// where there are any, marked in a variable "mask".
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
    struct Axis {
        const char* name;
        const char* dimension;
        Array1D positions;
        std::optional<double> length;  ///< of equal steps alone
        bool periodic;
    };

    static Axis equidistant(const char* name, Index points, double length, bool periodic) {
        return {name, name,
                length / static_cast<double>(points) * Array1D::LinSpaced(points, 0.0, static_cast<double>(points - 1)),
                length, periodic};
    }

    void write(std::span<const Axis> axes, const ArrayView1D& heights) const {
        std::vector<int> dimensions, variables;
        for (const auto& axis : axes) {
            dimensions.emplace_back();
            variables.emplace_back();
            dataset_.check(nc_def_dim(dataset_.id(), axis.dimension, static_cast<std::size_t>(axis.positions.size()),
                                      &dimensions.back()));
            dataset_.check(nc_def_var(dataset_.id(), axis.name, NC_DOUBLE, 1, &dimensions.back(), &variables.back()));
            dataset_.put_text(variables.back(), "unit", unit_.name);
            if (!axis.length) continue;
            dataset_.put_number(variables.back(), "length", *axis.length / unit_.factor);
            dataset_.put_number(variables.back(), "periodic", axis.periodic ? 1.0 : 0.0);
        }
        const int values = define("heights", NC_DOUBLE, dimensions);
        dataset_.put_text(values, "unit", unit_.name);
        const bool any_undefined = heights.isNaN().any();
        const int mask = any_undefined ? define("mask", NC_BYTE, dimensions) : -1;
        dataset_.check(nc_enddef(dataset_.id()));
        for (std::size_t i = 0; i < variables.size(); ++i) put(variables[i], axes[i].positions / unit_.factor);
        put(values, heights / unit_.factor);
        if (!any_undefined) return;
        const Eigen::Array<signed char, Eigen::Dynamic, 1> undefined_points = heights.isNaN().cast<signed char>();
        dataset_.check(nc_put_var_schar(dataset_.id(), mask, undefined_points.data()));
    }

    [[nodiscard]] int define(const char* name, nc_type type, const std::vector<int>& dimensions) const {
        int variable = 0;
        dataset_.check(
            nc_def_var(dataset_.id(), name, type, static_cast<int>(dimensions.size()), dimensions.data(), &variable));
        return variable;
    }
    void put(int variable, const ArrayView1D& values) const {
        dataset_.check(nc_put_var_double(dataset_.id(), variable, values.data()));
    }

    Dataset& dataset_;
    WrittenUnit unit_;
};

}  // namespace

std::string netcdf_content(const topography::Measurement& measurement, const std::string& unit) {
    Dataset dataset(topography::label(topography::metadata(measurement)));
    std::visit(HeightsWriter(dataset, written_unit(unit)), measurement);
    return dataset.release();
}

void write_netcdf(const std::string& path, const topography::Measurement& measurement) {
    bytes::write_whole_file(path, netcdf_content(measurement));
}

void write_netcdf(const std::string& path, const Table& table) {
    for (const auto& column : table.columns)
        if (column.values.size() != table.rows())
            throw InvalidArgument(fmt::format("{}: column '{}' has {} rows, expected {}", path, column.name,
                                              column.values.size(), table.rows()));
    Dataset dataset(path);
    int rows = 0;
    dataset.check(nc_def_dim(dataset.id(), "row", static_cast<std::size_t>(table.rows()), &rows));
    std::vector<int> variables;
    for (const auto& column : table.columns) {
        variables.emplace_back();
        dataset.check(nc_def_var(dataset.id(), column.name.c_str(), NC_DOUBLE, 1, &rows, &variables.back()));
        dataset.put_text(variables.back(), "units", column.unit);
        dataset.put_text(variables.back(), "long_name", column.name);
    }
    for (const auto& [key, value] : table.metadata) dataset.put_text(NC_GLOBAL, key.c_str(), value);
    dataset.check(nc_enddef(dataset.id()));
    for (std::size_t k = 0; k < variables.size(); ++k)
        dataset.check(nc_put_var_double(dataset.id(), variables[k], table.columns[k].values.data()));
    bytes::write_whole_file(path, dataset.release());
}

}  // namespace setae::formats
