// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/io/netcdf.hpp"

#include <netcdf.h>
#include <netcdf_mem.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "readers.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/io/whole_file.hpp"
#include "setae/topography/line_scans.hpp"

namespace setae::io {
namespace {

/// An open NetCDF dataset that lives in memory.
class Dataset {
public:
    Dataset(int id, std::string name) : id_(id), name_(std::move(name)) {}
    Dataset(const Dataset&) = delete;
    Dataset& operator=(const Dataset&) = delete;
    ~Dataset() {
        if (id_ >= 0) nc_close(id_);
    }

    [[nodiscard]] int id() const { return id_; }
    [[nodiscard]] const std::string& name() const { return name_; }

    /// Closes and gives up the bytes written.
    [[nodiscard]] std::string release() {
        NC_memio memory{};
        check(nc_close_memio(std::exchange(id_, -1), &memory));
        std::string content(static_cast<const char*>(memory.memory), memory.size);
        std::free(memory.memory);
        return content;
    }

    void check(int status) const {
        if (status != NC_NOERR) throw FormatError(name_, {}, fmt::format("NetCDF: {}", nc_strerror(status)));
    }

private:
    int id_;
    std::string name_;
};

std::optional<int> find_variable(const Dataset& dataset, const char* name) {
    int id = 0;
    if (nc_inq_varid(dataset.id(), name, &id) != NC_NOERR) return std::nullopt;
    return id;
}

std::string text_attribute(const Dataset& dataset, int variable, const char* name) {
    std::size_t length = 0;
    nc_type type = NC_NAT;
    if (nc_inq_att(dataset.id(), variable, name, &type, &length) != NC_NOERR || type != NC_CHAR) return {};
    std::string text(length, '\0');
    dataset.check(nc_get_att_text(dataset.id(), variable, name, text.data()));
    return text;
}

std::optional<double> number_attribute(const Dataset& dataset, int variable, const char* name) {
    std::size_t length = 0;
    nc_type type = NC_NAT;
    if (nc_inq_att(dataset.id(), variable, name, &type, &length) != NC_NOERR || type == NC_CHAR || length != 1) return std::nullopt;
    double value = 0.0;
    dataset.check(nc_get_att_double(dataset.id(), variable, name, &value));
    return value;
}

std::vector<Index> shape_of(const Dataset& dataset, int variable) {
    int dimensions = 0;
    std::array<int, NC_MAX_VAR_DIMS> ids{};
    dataset.check(nc_inq_varndims(dataset.id(), variable, &dimensions));
    dataset.check(nc_inq_vardimid(dataset.id(), variable, ids.data()));
    std::vector<Index> shape;
    for (int i = 0; i < dimensions; ++i) {
        std::size_t length = 0;
        dataset.check(nc_inq_dimlen(dataset.id(), ids[static_cast<std::size_t>(i)], &length));
        shape.push_back(static_cast<Index>(length));
    }
    return shape;
}

/// Values of a variable, after checking that the file can hold them.
std::vector<double> values_of(const Dataset& dataset, int variable, const std::vector<Index>& shape, const Source& source) {
    nc_type type = NC_NAT;
    std::size_t bytes = 0;
    dataset.check(nc_inq_vartype(dataset.id(), variable, &type));
    dataset.check(nc_inq_type(dataset.id(), type, nullptr, &bytes));
    std::uint64_t count = 1;
    for (const auto extent : shape) {
        if (extent > 0 && count > source.size / static_cast<std::uint64_t>(extent) / std::max<std::size_t>(bytes, 1))
            throw FormatError(source.name, {.offset = source.size}, "NetCDF: a variable is larger than the file; it is truncated");
        count *= static_cast<std::uint64_t>(extent);
    }
    std::vector<double> values(count);
    if (count > 0) dataset.check(nc_get_var_double(dataset.id(), variable, values.data()));
    return values;
}

/// Extent along a coordinate: the attribute "length". Writers stored it in single precision: the coordinates, in
/// double precision, then give the same extent with all its digits.
double axis_length(const Dataset& dataset, const char* axis, Index points, const Source& source) {
    const auto variable = find_variable(dataset, axis);
    const auto length = variable ? number_attribute(dataset, *variable, "length") : std::nullopt;
    if (!length) throw FormatError(source.name, {}, fmt::format("NetCDF: no coordinate '{}' with an attribute 'length'", axis));
    const auto positions = values_of(dataset, *variable, shape_of(dataset, *variable), source);
    if (positions.size() < 2 || static_cast<Index>(positions.size()) != points) return *length;
    const double steps = static_cast<double>(positions.size() - 1);
    const double from_positions = (positions.back() - positions.front()) * static_cast<double>(positions.size()) / steps;
    return std::abs(from_positions / *length - 1.0) < 1e-6 ? from_positions : *length;
}

/// Heights in file order; undefined where a mask is set or the fill value stands.
std::vector<double> defined_heights(const Dataset& dataset, int variable, const std::vector<Index>& shape, const Source& source) {
    auto heights = values_of(dataset, variable, shape, source);
    for (const char* name : {"_FillValue", "missing_value"})
        if (const auto fill = number_attribute(dataset, variable, name))
            for (auto& height : heights)
                if (height == *fill) height = undefined;
    if (const auto mask = find_variable(dataset, "mask")) {
        const auto masked = values_of(dataset, *mask, shape_of(dataset, *mask), source);
        if (masked.size() != heights.size()) throw FormatError(source.name, {}, "NetCDF: mask and heights differ in shape");
        for (std::size_t i = 0; i < heights.size(); ++i)
            if (masked[i] != 0.0) heights[i] = undefined;
    }
    return heights;
}

bool is_periodic(const Dataset& dataset) {
    const auto x = find_variable(dataset, "x");
    return x && number_attribute(dataset, *x, "periodic").value_or(0.0) != 0.0;
}

topography::Measurement to_measurement(const Dataset& dataset, int variable, double factor, const Source& source,
                                       topography::Metadata metadata) {
    const auto shape = shape_of(dataset, variable);
    const auto heights = defined_heights(dataset, variable, shape, source);
    if (shape.size() == 2) {
        const Eigen::Map<const Array2D> map(heights.data(), shape[0], shape[1]);
        return topography::HeightMap{map * factor,
                                     {factor * axis_length(dataset, "x", shape[0], source), factor * axis_length(dataset, "y", shape[1], source)},
                                     is_periodic(dataset), std::move(metadata)};
    }
    if (shape.size() != 1) throw FormatError(source.name, {}, fmt::format("NetCDF: heights of {} dimensions, expected 1 or 2", shape.size()));
    const Eigen::Map<const Array1D> line(heights.data(), shape[0]);
    const auto x = find_variable(dataset, "x");
    if (x && !number_attribute(dataset, *x, "length")) {
        const auto positions = values_of(dataset, *x, shape_of(dataset, *x), source);
        if (positions.size() != heights.size()) throw FormatError(source.name, {}, "NetCDF: x and heights differ in length");
        return topography::Profile{Eigen::Map<const Array1D>(positions.data(), shape[0]) * factor, line * factor, std::move(metadata)};
    }
    return topography::LineScan{line * factor, factor * axis_length(dataset, "x", shape[0], source), is_periodic(dataset), std::move(metadata)};
}

}  // namespace

Match detect_netcdf(std::string_view head, const Source&) {
    const bool classic = head.size() > 3 && head.starts_with("CDF") && (head[3] == 1 || head[3] == 2 || head[3] == 5);
    return classic ? Match::yes : Match::no;
}

std::vector<Channel> open_netcdf(const Source& source, const ReadOptions& options) {
    auto content = source.all();
    int id = -1;
    const int status = nc_open_mem(source.name.c_str(), NC_NOWRITE, content.size(), content.data(), &id);
    if (status != NC_NOERR) throw FormatError(source.name, {}, fmt::format("NetCDF: {}; the file is damaged or truncated", nc_strerror(status)));
    const Dataset dataset(id, source.name);
    const auto variable = find_variable(dataset, "heights");
    if (!variable) throw FormatError(source.name, {}, "NetCDF: no variable 'heights'; tables are not read as topographies");
    ChannelInfo info{.name = "heights", .format = "nc"};
    topography::Metadata metadata;
    metadata.file = source.name;
    metadata.format = "nc";
    auto spelled = text_attribute(dataset, *variable, "unit");
    if (spelled.empty()) spelled = required_unit(options, source);
    const auto unit = length_unit(spelled, source);
    info.unit = metadata.unit = unit.name;
    return {loaded_channel(std::move(info), checked(to_measurement(dataset, *variable, unit.factor, source, metadata), source))};
}

void write_netcdf(const std::string& path, const Table& table) {
    for (const auto& column : table.columns)
        if (column.values.size() != table.rows())
            throw InvalidArgument(fmt::format("{}: column '{}' has {} rows, expected {}", path, column.name, column.values.size(), table.rows()));
    int id = -1;
    const int status = nc_create_mem(path.c_str(), NC_64BIT_OFFSET, 0, &id);
    if (status != NC_NOERR) throw FileError(fmt::format("{}: NetCDF: {}", path, nc_strerror(status)));
    Dataset dataset(id, path);
    const auto check = [&](int code) {
        if (code != NC_NOERR) throw InvalidArgument(fmt::format("{}: NetCDF: {}", path, nc_strerror(code)));
    };
    const auto put_text = [&](int variable, const char* name, const std::string& text) {
        check(nc_put_att_text(id, variable, name, text.size(), text.data()));
    };
    int rows = 0;
    check(nc_def_dim(id, "row", static_cast<std::size_t>(table.rows()), &rows));
    std::vector<int> variables;
    for (const auto& column : table.columns) {
        variables.emplace_back();
        check(nc_def_var(id, column.name.c_str(), NC_DOUBLE, 1, &rows, &variables.back()));
        put_text(variables.back(), "units", column.unit);
        put_text(variables.back(), "long_name", column.name);
    }
    for (const auto& [key, value] : table.metadata) put_text(NC_GLOBAL, key.c_str(), value);
    check(nc_enddef(id));
    for (std::size_t k = 0; k < variables.size(); ++k) check(nc_put_var_double(id, variables[k], table.columns[k].values.data()));
    write_whole_file(path, dataset.release());
}

}  // namespace setae::io
