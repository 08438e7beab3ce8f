// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/bytes/source.hpp"

namespace setae::bytes {

/// Largest file whose heaps are checked before the HDF5 library opens it: the check reads the whole file.
inline constexpr std::uint64_t max_searched_for_heaps = std::uint64_t{16} << 20;

/// Refuses an HDF5 file with an inconsistent global heap (texts and lists of variable length). HDF5 1.10 does not check
/// heaps: of the random changes of bytes that ended the program or caused an endless loop, four of five were in heaps.
/// Larger files are not checked.
/// @throws FormatError with the place of the heap.
/// Source: HDF5 File Format Specification 3.0, III.E.
void require_sound_heaps(const Source& source);

}  // namespace setae::bytes
