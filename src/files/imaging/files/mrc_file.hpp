// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "setae/bytes/source.hpp"
#include "setae/imaging/micrograph.hpp"

namespace setae::imaging {

/// Whether bytes begin as an MRC of 2000 or later; 216 are needed.
[[nodiscard]] bool is_mrc(std::string_view head);

/// Reads a section of an MRC; rows are in the order of the file. Untested on real files.
/// @throws as read_micrograph does.
/// Source: Cheng et al., J. Struct. Biol. 192, 2015, 146 (MRC2014), modes 0 to 4, 6 and 12; FEI extended headers from
/// the EPU manual.
[[nodiscard]] Micrograph read_mrc(const bytes::Source& file, const MicrographOptions& options);

}  // namespace setae::imaging
