// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "storage/stored_array.hpp"

namespace setae::formats {

/// A variable of a MAT file: its numbers, column by column; only the real parts of complex numbers.
struct MatVariable {
    StoredArray array;
    bool complex = false;
    bool integers = false;  ///< its class is an integer type; MATLAB also stores integer doubles as integers
};

/// Whether bytes begin as MAT of level 5 (versions 5 to 7.2).
[[nodiscard]] bool is_mat5(std::string_view head);

/// Whether bytes can be MAT of level 4, which has no signature: the numbers of the first header are consistent, and a
/// valid MATLAB name follows.
[[nodiscard]] bool can_be_mat4(std::string_view head);

/// The matrices of numbers in a file of level 5; texts, cells, structs, objects, sparse and logical matrices are
/// skipped. Compressed variables are expanded when values are read, before only their header; variables that expand to
/// more than max_expanded are refused.
/// @throws FormatError for elements that are damaged or truncated.
/// Source: MathWorks, MAT-File Format (level 5).
[[nodiscard]] std::vector<MatVariable> mat5_variables(const bytes::Source& source);

/// The matrices of numbers in a file of level 4. Source: MathWorks, MAT-File Format (level 4, appendix).
[[nodiscard]] std::vector<MatVariable> mat4_variables(const bytes::Source& source);

}  // namespace setae::formats
