// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/imaging/contact_outline.hpp"
#include "traced_edge.hpp"

namespace setae::imaging {

/// Holes inside an edge of the frame: see trace_contact_outline. inner, outer: levels of either side.
[[nodiscard]] std::vector<ContactVoid> contact_voids(const FramePixels& pixels, const TracedEdge& edge, double inner,
                                                     double outer, double smallest);

}  // namespace setae::imaging
