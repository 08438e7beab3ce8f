// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "setae/half_space/adhesive_loop.hpp"

namespace setae::half_space {

/// Identity of a loop: cell and options that determine its steps. Only the same loop continues from a checkpoint.
/// heights [m] and all inputs of the cell.
[[nodiscard]] std::string loop_key(const ArrayView2D& heights, const Grid& grid, const Body& body,
                                   const Interaction& interaction, const LoopOptions& options);

/// Replaces the file as a whole: a line that names it, the key, then numbers as this testing machine keeps them.
/// @throws FileError.
void write_checkpoint(const std::string& path, const std::string& key, const LoopCheckpoint& checkpoint);

/// Nothing where there is no such file. @throws FormatError for another file, another loop's, or a damaged one.
[[nodiscard]] std::optional<LoopCheckpoint> read_checkpoint(const std::string& path, const std::string& key);

}  // namespace setae::half_space
