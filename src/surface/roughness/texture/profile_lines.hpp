// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/texture/measurement_view.hpp"

namespace setae::texture {

/// The points of a line.
struct Points {
    Array1D positions;
    Array1D heights;
};

/// @throws InvalidArgument for a map or a re-entrant profile, UndefinedDataError for undefined heights.
[[nodiscard]] Points points_of(const MeasurementView& line);

/// @throws InvalidArgument for a map.
void require_line(const MeasurementView& line);

}  // namespace setae::texture
