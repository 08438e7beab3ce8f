// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "patch_graph.hpp"

namespace setae::processing {

/// Heights − centre of the points of a patch: conjugate gradients with a multigrid cycle as preconditioner, until the
/// cycle's correction is below 1e-13 of the boundary's range.
///
/// Cells of 2 x 2 points (or 2 along the stronger coupling alone, until couplings are alike), couplings of their
/// neighbours summed and halved along what was coarsened, corrections interpolated linearly; one sweep over red and
/// black points before and, backwards, after. Memory: eleven values a point of the patch's box. O(points of the box).
/// @throws InternalError where 400 steps do not suffice.
[[nodiscard]] Array1D solve_by_multigrid(const PatchGraph& graph, const PatchBoundary& boundary,
                                         const Couplings& couplings);

}  // namespace setae::processing
