// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "sample_files.hpp"
#include "setae/core/arrays.hpp"

namespace setae::formats::tests {

using namespace setae::tests;

/// A ZON file; 2 µm per pixel, 10 nm per unit.
struct ZonFile {
    Array2D raw;
    Array2D validity = {};  ///< one byte per point; empty: no such member
    bool packed = false;    ///< KPK1: members by Zstandard
    bool colour = false;
};

[[nodiscard]] Members zon_members(const ZonFile& file);
/// Members after a picture: KPK0, or KPK1 where packed, each member then by Zstandard.
[[nodiscard]] std::string keyence_package(Members members, bool packed);
[[nodiscard]] std::string zon_file(const ZonFile& file);
/// A ZAG file of ZON files with their names; those that begin with "hidden" must not be listed.
[[nodiscard]] std::string zag_file(const Members& files);

}  // namespace setae::formats::tests
