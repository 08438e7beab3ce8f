// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/bytes/source.hpp"

namespace setae::bytes {

/// The largest file whose heaps are looked at before the library sees it: all of it is read for that.
inline constexpr std::uint64_t max_searched_for_heaps = std::uint64_t{16} << 20;

/// Refuses an HDF5 file one of whose global heaps, where texts and lists of variable length lie, does not add up.
/// HDF5 1.10 trusts them: of the bytes changed at random that ended the program or kept it busy for ever, four of five
/// stood there. Larger files are not looked at.
/// @throws FormatError with the place of the heap.
/// Source: HDF5 File Format Specification 3.0, III.E.
void require_sound_heaps(const Source& source);

}  // namespace setae::bytes
