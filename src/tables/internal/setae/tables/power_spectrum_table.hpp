// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/core/table.hpp"

namespace setae::tables {

/// A power spectrum from a table: columns "wavevector" [1/m] and "C1D" [m³], sorted as in the file; a third column
/// "standard_error" [m³] is kept where the header names it.
///
/// Units stand in the header, as "q [1/m];C1D [m3]" or in a unit row. Two columns without any unit are taken as SI,
/// which metadata["units"] = "assumed SI" records; this covers separator ';' with decimal comma and a first row that is
/// no data.
/// @throws FileError; FormatError for one column only, units of another dimension, or no positive wavevector.
/// Source of the dialect: [D19]'s data, two columns q [1/m] and C1D [m³].
[[nodiscard]] Table read_power_spectrum_table(const std::string& path);

}  // namespace setae::tables
