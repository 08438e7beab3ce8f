// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "storage/stored_array.hpp"

namespace setae::formats {

/// A variable of a MAT file: its numbers, column after column, the real parts alone where they are complex.
struct MatVariable {
    StoredArray array;
    bool complex = false;
    bool integers = false;  ///< its class is one of whole numbers; MATLAB stores whole doubles as integers, too
};

/// Whether bytes begin as MAT of level 5 (versions 5 to 7.2).
[[nodiscard]] bool is_mat5(std::string_view head);

/// Whether bytes can be MAT of level 4, which has no signature: the first header's numbers fit each other, and a name
/// that MATLAB allows follows.
[[nodiscard]] bool can_be_mat4(std::string_view head);

/// The matrices of numbers in a file of level 5; texts, cells, structs, objects, sparse and logical ones are passed
/// over. What is compressed is expanded when values are read, its header alone before; what is compressed and would
/// expand more than max_expanded has a refusal.
/// @throws FormatError for elements that are damaged or truncated.
/// Source: MathWorks, MAT-File Format (level 5).
[[nodiscard]] std::vector<MatVariable> mat5_variables(const bytes::Source& source);

/// The same of level 4. Source: MathWorks, MAT-File Format (level 4, appendix).
[[nodiscard]] std::vector<MatVariable> mat4_variables(const bytes::Source& source);

}  // namespace setae::formats
