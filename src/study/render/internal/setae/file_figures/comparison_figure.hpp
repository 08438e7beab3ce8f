// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/table.hpp"
#include "setae/file_figures/look.hpp"

namespace setae::file_figures {

/// Area in contact, mean gap, stiffness and stored energy of solved contacts, with a standard error, and as Persson's
/// theory has them, against pressure.
///
/// load: pressure and, of each of them, itself, "…_standard_error" and "…_persson".  file: of the surface, for the
/// title.
[[nodiscard]] StudyFigure comparison_figure(const Table& load, const std::string& file, const Look& look);

}  // namespace setae::file_figures
