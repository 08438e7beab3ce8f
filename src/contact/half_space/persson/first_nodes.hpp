// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace setae::persson {

/// Nodes next to the wavevector where V begins at 0, in a geometric sequence down to a millionth of the distance: the
/// effect of the longest waves on a load depends on p²/V.
inline constexpr int first_nodes = 80;
inline constexpr double growth = 1.189207115002721;

}  // namespace setae::persson
