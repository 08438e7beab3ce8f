// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>

#include "setae/core/arrays.hpp"
#include "setae/core/table.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::formats {

/// Writes a table as NetCDF (classic model, 64-bit offsets): dimension "row", one float64 variable per column with
/// attributes "units" and "long_name"; the metadata of the table as global text attributes. As a whole.
/// @throws FileError; InvalidArgument for columns of different length or two columns with one name.
/// Source: NetCDF Users Guide; CF conventions 1.8, sections 3.1 and 3.2.
void write_netcdf(const std::string& path, const Table& table);

/// Values at the points of a grid, x the first index.
struct GridMap {
    std::string name, unit;
    Array2D values;
};

/// Writes maps of one grid as NetCDF (classic model, 64-bit offsets): float64 variables name(x, y) with the attribute
/// "units", coordinates x and y [m] with the attributes "unit", "length" and "periodic". As a whole.
/// size: extents of the grid [m].
/// @throws FileError; InvalidArgument for no map, maps of different shape, two maps with one name.
void write_netcdf(const std::string& path, std::span<const GridMap> maps, const std::array<double, 2>& size,
                  bool periodic);

/// A topography as the bytes of a NetCDF file (classic model, 64-bit offsets) that open() reads back with its size,
/// unit and periodicity: float64 variables heights(x[, y]), x and y in `unit`, attributes "unit", "length" and
/// "periodic"; heights(n) and x(n) of a profile have no length. Undefined points are NaN and 1 in a variable "mask",
/// which exists only if there are undefined points.
/// @throws InvalidArgument for content that NetCDF refuses, such as 2³² bytes of heights or more, or a unit that is no
/// length.
/// Source: the layout of topographies in contact.engineering containers.
[[nodiscard]] std::string netcdf_content(const topography::Measurement& measurement, const std::string& unit = "m");

/// Writes netcdf_content in metres. As a whole.
/// @throws FileError; InvalidArgument as netcdf_content.
void write_netcdf(const std::string& path, const topography::Measurement& measurement);

}  // namespace setae::formats
