// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/core/units.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::formats {

/// A key of a profile file: meaning, and dimension if it is a quantity.
struct ProfileKey {
    std::string_view name;
    std::string_view meaning;
    std::optional<Dimension> dimension;  ///< empty: text
};

/// The known keys; others are kept as attributes. docs/reference/profile-format.md lists them.
[[nodiscard]] const std::vector<ProfileKey>& profile_keys();

/// A profile as text in the open format of setae: '# key: value unit' lines, then CSV in SI.
///
///   # format: setae profile
///   # version: 1
///   # instrument: tem
///   # blur: 4.2e-10 m
///   x [m],h [m],standard_error [m]
///
/// Numbers have all their digits, NaN is an empty cell; the third column exists if errors are known. Keys without a
/// value are left out; attributes of the metadata are written as keys. Not written: the metadata's file, format and
/// unit.
/// @throws InvalidArgument for attributes whose key is a known key (foil_thickness, rotation and reentrant_share
/// excepted), is empty or holds a colon, entries with line breaks or outer blanks, quantities that do not parse, and
/// profiles that topography::validate refuses.
[[nodiscard]] std::string as_profile_file(const topography::Profile& profile);

/// Writes as_profile_file(profile) as a whole.
/// @throws FileError; InvalidArgument as as_profile_file.
void write_profile(const std::string& path, const topography::Profile& profile);

/// Whether bytes are the beginning of such a file.
[[nodiscard]] bool is_profile_file(std::string_view head);

/// The profile of a file: the output of write_profile is read exactly, to the last bit.
/// @throws FormatError with the line: another version, a head line that is no 'key: value', a key given twice, a
/// malformed quantity, a response that lacks a part; columns other than x, h and perhaps standard_error with units of
/// length; rows that read_raw_table refuses.
[[nodiscard]] topography::Profile read_profile(const bytes::Source& source);

}  // namespace setae::formats
