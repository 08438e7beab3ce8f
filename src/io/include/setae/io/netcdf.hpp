// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/core/table.hpp"

namespace setae::io {

/// Writes a table as NetCDF (classic model, 64-bit offsets): dimension "row", one float64 variable a column with
/// attributes "units" and "long_name"; the table's metadata as global text attributes. As a whole.
/// @throws FileError; InvalidArgument for columns of different length or two columns of one name.
/// Source: NetCDF Users Guide; CF conventions 1.8, sections 3.1 and 3.2.
void write_netcdf(const std::string& path, const Table& table);

}  // namespace setae::io
