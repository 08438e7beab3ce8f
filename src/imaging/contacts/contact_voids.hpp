// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/imaging/contact_outline.hpp"

namespace setae::imaging {

/// Holes inside an edge: see trace_contact_outline. radius: of the edge about the centre [px of the frame]; levels of
/// either side.
[[nodiscard]] std::vector<ContactVoid> contact_voids(const FramePixels& pixels, const Array1D& radius, double centre_x,
                                                     double centre_y, double inner, double outer, double smallest);

}  // namespace setae::imaging
