// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/table.hpp"
#include "setae/file_figures/look.hpp"
#include "setae/study/surface_analysis.hpp"

namespace setae::file_figures {

/// The power spectral density of the measurements of one surface, or of a table that stands for it.
///
/// A: C1D over q of every measurement, solid in its reliable band, pale and dotted where it is cut; of several black
/// their average with its 95 % band, of one its standard errors where its lines tell them. A table that is given: its
/// values with their standard errors. From `table`, where it has the columns: C1D_model, dotted outside the range of
/// the fit. B: C_iso and C_iso_abel, where there is one of them.
///
/// table: columns wavevector [1/m], C1D [m3], standard_error [m3] and those above.
[[nodiscard]] StudyFigure spectrum_figure(const study::SurfaceResult& surface, const Table& table, const Look& look);

}  // namespace setae::file_figures
