// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/core/arrays.hpp"

namespace setae::formats {

/// Header lines above a map of numbers, in the dialects of Gwyddion's exports (in its languages), SPIP, Wyko Vision,
/// Nova, and "h=305 w=75".
struct MatrixHeader {
    std::string name;
    std::string unit;                             ///< of heights after `factor`; empty: not given
    double factor = 1.0;                          ///< units per number
    std::optional<Index> nx, ny;                  ///< points stated in the header
    std::array<std::optional<double>, 2> length;  ///< [m] along x and y
    std::array<std::optional<double>, 2> pixel;   ///< distance of points along x and y [m]
    bool lines_are_columns = false;               ///< Wyko: a line holds one x, y from the bottom
    bool heights = true;                          ///< false for Wyko's intensities
    bool void_map = false;                        ///< SPIP: another map follows, 1 at void points
    std::map<std::string, std::string> attributes;
    bool is_map = false;  ///< at least one of these lines exists: the numbers are a map, for any number of columns
};

/// Reads header lines; missing entries keep their value in `before`, the header of earlier numbers in the same text.
/// @throws FormatError for a size or count that is no positive number or has a unit that is no length.
[[nodiscard]] MatrixHeader parse_matrix_header(const std::vector<std::string>& lines, const bytes::Source& source,
                                               const MatrixHeader& before = {});

/// Whether a line between numbers begins the header of further ones.
[[nodiscard]] bool begins_numbers(std::string_view line, const MatrixHeader& before);

}  // namespace setae::formats
