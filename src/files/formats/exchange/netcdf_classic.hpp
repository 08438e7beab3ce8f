// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "storage/stored_array.hpp"

namespace setae::formats {

/// Numbers that begin the lists of a classic header.
inline constexpr std::uint32_t dimension_tag = 10, variable_tag = 11, attribute_tag = 12;

/// What a file of named arrays holds.
struct ArrayFile {
    Attributes attributes;  ///< of the file
    std::vector<StoredArray> arrays;

    [[nodiscard]] const StoredArray* find(const std::string& name) const;
};

/// The header of a classic NetCDF file (CDF-1, -2, -5), every count checked against the bytes there are; the NetCDF
/// library trusts damaged headers and crashes on them. Values stay in the file; characters are no numbers and left out.
/// @throws FormatError for a header that is damaged or truncated.
/// Source: NetCDF Classic Format Specification (netCDF Users Guide, appendix).
[[nodiscard]] ArrayFile classic_netcdf(const bytes::Source& source);

}  // namespace setae::formats
