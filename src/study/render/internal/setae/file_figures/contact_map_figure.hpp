// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/file_figures/look.hpp"

namespace setae::file_figures {

/// A contact point by point: maps (nx, ny) of pressure [Pa], below 0 where the body is drawn, and of gaps [m].
struct ContactState {
    std::string shows;  ///< in a few words; empty for a single state
    Array2D pressures, gaps;
};

/// Pressure and gap of each state, as maps or, for one line of points, as curves. Colours end where 0.5 % of the points
/// are beyond.
///
/// size: along x and y [m].  file: of the surface, for the title.  @throws InvalidArgument without a state.
[[nodiscard]] StudyFigure contact_map_figure(const std::vector<ContactState>& states, std::array<double, 2> size,
                                             const std::string& file, const Look& look);

}  // namespace setae::file_figures
