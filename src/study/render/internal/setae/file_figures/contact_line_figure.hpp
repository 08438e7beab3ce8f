// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/contact_line/line_motion.hpp"
#include "setae/contact_line/line_roughness.hpp"
#include "setae/file_figures/look.hpp"

namespace setae::file_figures {

/// Data of the figure of an edge; empty where they could not be determined.
struct ContactLineData {
    contact_line::ContactLine line;
    contact_line::LineRoughness roughness;        ///< no modes: not drawn
    Array1D retracting_speeds, advancing_speeds;  ///< v/⟨v⟩ of cells
    Array1D retracting_jumps, advancing_jumps;    ///< areas [m²]
};

/// The edge in at most twelve frames; its spectrum with the fitted power law; the share of the edge's cells faster than
/// v; the share of jumps larger than an area.
///
/// file: of the recording, for the title.
[[nodiscard]] StudyFigure contact_line_figure(const ContactLineData& data, const std::string& file, const Look& look);

}  // namespace setae::file_figures
