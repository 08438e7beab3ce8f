// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace setae::persson {

/// Nodes beside the place where V begins at 0, each so many times farther from it than the one before, down to a
/// millionth of the way: what a load feels of the longest waves depends on p²/V.
inline constexpr int first_nodes = 80;
inline constexpr double growth = 1.189207115002721;

}  // namespace setae::persson
