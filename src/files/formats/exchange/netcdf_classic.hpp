// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "storage/stored_array.hpp"

namespace setae::formats {

/// Numbers that begin the lists of a classic header.
inline constexpr std::uint32_t dimension_tag = 10, variable_tag = 11, attribute_tag = 12;

/// Content of a file of named arrays.
struct ArrayFile {
    Attributes attributes;  ///< of the file
    std::vector<StoredArray> arrays;

    [[nodiscard]] const StoredArray* find(const std::string& name) const;
};

/// The header of a classic NetCDF file (CDF-1, -2, -5), with every count checked against the size of the file; the
/// NetCDF library does not check damaged headers and crashes on them. Values are not read; character variables are left
/// out.
/// @throws FormatError for a header that is damaged or truncated.
/// Source: NetCDF Classic Format Specification (netCDF Users Guide, appendix).
[[nodiscard]] ArrayFile classic_netcdf(const bytes::Source& source);

}  // namespace setae::formats
