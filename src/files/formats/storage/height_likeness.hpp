// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "stored_array.hpp"

namespace setae::formats {

/// Properties of an array in a general-purpose file: HDF5, MAT, NPZ.
struct LooseArray {
    const StoredArray& array;
    std::string name;         ///< last part of its path
    bool integers = false;    ///< its values are of an integer type
    bool has_length = false;  ///< the file contains a unit of length for it
    bool only_array = false;  ///< the file contains no other array of numbers
};

/// Why an array is unlikely to contain heights, such as "whole numbers that grow from value to value: an index"; empty
/// if it is likely.
///
/// A name of heights or a unit of length is decisive. Otherwise heights are floats on a map that are neither the
/// coordinates of its points nor a table of few columns, or the only line of floats in the file that does not increase
/// throughout. Cost: a few lines of maps, up to a million values of lines are read.
[[nodiscard]] std::string reason_against_heights(const LooseArray& loose);

/// Why the only array of a file without names contains no heights: a table of few columns or an index. Integers, planes
/// and increasing lines may be heights in this case.
[[nodiscard]] std::string reason_against_single_array(const StoredArray& array);

}  // namespace setae::formats
