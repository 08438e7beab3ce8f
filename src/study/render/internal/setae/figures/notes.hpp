// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/figures/figure.hpp"

namespace setae::figures {

/// Extends a panel's linear x axis, whose ends are given, until the notes to the right of their points end within the
/// axes; the figure has its size. Notes get at most four fifths of the axes.
void extend_for_notes(Figure& figure, std::size_t panel = 0);

}  // namespace setae::figures
