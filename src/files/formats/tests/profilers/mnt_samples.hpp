// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "setae/core/arrays.hpp"

namespace setae::formats::tests {

/// A surface of a Mountains document: counts h(x, y); with a mask, counts of 0 are not measured. Steps 2 µm, 1.5 µm and
/// 0.1 nm; origin of heights 50 µm.
struct MntSurface {
    Array2D counts;
    std::string name = "A48";
    int element_bytes = 4;
    bool mask = false;
    std::string z_unit = "nm", z_shown = "\xb5m";  ///< Latin-1
};

/// The stream "ScopedContents" of a document with these surfaces, among other objects.
[[nodiscard]] std::string mnt_contents(const std::vector<MntSurface>& surfaces, int other_objects = 2);
/// The compound file around it.
[[nodiscard]] std::string mnt_file(const std::string& contents, unsigned sector_shift = 9);

}  // namespace setae::formats::tests
