// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/table.hpp"
#include "setae/file_figures/look.hpp"

namespace setae::file_figures {

/// Area in contact and mean gap by Persson's theory: against pressure for a table of persson::load_table(), against the
/// waves taken into account for one of persson::scale_table(); with adhesion its area in addition to that without.
///
/// file: of the surface, for the title.
[[nodiscard]] StudyFigure persson_figure(const Table& table, const std::string& file, const Look& look);

}  // namespace setae::file_figures
