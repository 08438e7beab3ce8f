// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "storage/stored_array.hpp"

namespace setae::formats {

/// Whether bytes begin as NumPy's NPY.
[[nodiscard]] bool is_npy(std::string_view head);

/// The array of an NPY file, versions 1 to 3. Records, objects, texts and complex or half precision numbers are
/// refused.
/// @throws FormatError for a damaged or truncated header, or fewer values than it announces.
/// Source: NumPy Enhancement Proposal 1 and numpy.lib.format.
[[nodiscard]] StoredArray npy_array(const bytes::Source& source);

}  // namespace setae::formats
