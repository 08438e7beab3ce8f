// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/core/table.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::io {

/// Writes a table as NetCDF (classic model, 64-bit offsets): dimension "row", one float64 variable a column with
/// attributes "units" and "long_name"; the table's metadata as global text attributes. As a whole.
/// @throws FileError; InvalidArgument for columns of different length or two columns of one name.
/// Source: NetCDF Users Guide; CF conventions 1.8, sections 3.1 and 3.2.
void write_netcdf(const std::string& path, const Table& table);

/// Writes a topography as NetCDF (classic model, 64-bit offsets) that open() reads back with its size, unit and
/// periodicity: float64 variables heights(x[, y]), x and y in metres, attributes "unit", "length" and "periodic"; a profile's
/// x has no length. NaN is undefined. As a whole.
/// @throws FileError; InvalidArgument for what NetCDF refuses, such as 2³² bytes of heights or more.
/// Source: the layout of topographies in contact.engineering containers.
void write_netcdf(const std::string& path, const topography::Measurement& measurement);

}  // namespace setae::io
