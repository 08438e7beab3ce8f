// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/table.hpp"
#include "setae/file_figures/look.hpp"

namespace setae::file_figures {

/// Tension and area in contact against the mean gap, on approach and on separation, of half_space::loop_table().
///
/// file: of the surface, for the title.
[[nodiscard]] StudyFigure sweep_figure(const Table& table, const std::string& file, const Look& look);

}  // namespace setae::file_figures
