// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "stored_array.hpp"

namespace setae::formats {

/// What is known of an array of a file that anything may be written to: HDF5, MAT, NPZ.
struct LooseArray {
    const StoredArray& array;
    std::string name;         ///< last part of its path
    bool integers = false;    ///< its values are whole numbers by their type
    bool has_length = false;  ///< its file states a unit of length for it
    bool alone = false;       ///< the file holds no other array of numbers
};

/// Why an array does not look like heights, such as "whole numbers that grow from value to value: an index"; empty
/// where it does.
///
/// A name of heights or a unit of length decides. Else heights are floats on a map that are neither the coordinates of
/// its points nor a table of few columns, or the only line of floats in the file that does not grow throughout.
/// Cost: of maps a few lines are read, of lines up to a million values.
[[nodiscard]] std::string why_no_heights(const LooseArray& loose);

/// The same of the array of a file that holds nothing else and no names: a table of few columns or an index. Whole
/// numbers, planes and lines that grow may be heights there.
[[nodiscard]] std::string why_lone_array_is_no_map(const StoredArray& array);

}  // namespace setae::formats
