// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "patch_graph.hpp"

namespace setae::processing {

/// Heights − centre of the points of a patch, by conjugate gradients with a multigrid cycle as preconditioner, until
/// the correction of the cycle is below 1e-13 of the range of the boundary.
///
/// Cells of 2 x 2 points (or only 2 along the stronger coupling, until couplings are similar), couplings of their
/// neighbours summed and halved along the coarsened direction, corrections interpolated linearly; one sweep over red
/// and black points before and, backwards, after. Memory: eleven values per point of the box of the patch. O(points of
/// the box). @throws InternalError if 400 steps are not sufficient.
[[nodiscard]] Array1D solve_by_multigrid(const PatchGraph& graph, const PatchBoundary& boundary,
                                         const Couplings& couplings);

}  // namespace setae::processing
