// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::spectral_fit {

/// C1D of a C_iso on nodes (hat_node.hpp), each value the mean over q_b e^{−h/2} … q_b e^{h/2} [m³].
///
/// nodes: q_i [1/m], increasing by the factor e^h, at most 1000; C_iso [m⁴] there. The last node is q_s: C_iso is zero
/// above it. Constant below the first. For C1D ∝ q^−α the mean over a cell exceeds the value at its centre by h²/24 α(α
/// − 2) of it, 4e-4 for α = 3; at q_s itself the cell is half empty.
/// @throws InvalidArgument for sizes that differ, other ratios, or more nodes.
[[nodiscard]] Array1D line_spectrum(const ArrayView1D& nodes, const ArrayView1D& C_iso);

}  // namespace setae::spectral_fit
