// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/table.hpp"
#include "setae/file_figures/look.hpp"
#include "setae/study/surface_analysis.hpp"

namespace setae::file_figures {

/// The power spectral density of the measurements of one surface, or of a table.
///
/// A: C1D against q of every measurement, solid in its reliable band, pale and dotted outside; for several measurements
/// in black their average with its 95 % band, for one its standard errors where its lines give them. For a given table:
/// its values with their standard errors. From `table`, where it has the columns: C1D_model, dotted outside the range
/// of the fit. B: C_iso and C_iso_abel, where there is one of them.
///
/// table: columns wavevector [1/m], C1D [m3], standard_error [m3] and those above.
[[nodiscard]] StudyFigure spectrum_figure(const study::SurfaceResult& surface, const Table& table, const Look& look);

}  // namespace setae::file_figures
