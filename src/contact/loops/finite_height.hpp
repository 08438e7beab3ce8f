// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/contact/layer.hpp"
#include "setae/loops/analysis.hpp"

namespace setae::loops {

/// The equivalent branch on a half-space of a body of finite height.
///
/// Each sample is shifted by the difference of JKR's curve to that of the layer (contact/layer.hpp) at the contact
/// radius of the layer under its force, F' = F + F_∞(a) − F_h(a) and δ' = δ + δ_∞(a) − δ_h(a), with E* and W of the
/// primary fit to the shifted samples: iterated to 1e-10 of E*. Every route for half-spaces then applies to F', δ', a.
/// Without a height the branch is unchanged.
/// @throws UndefinedDataError without convergence; as the fits; InvalidArgument for a contact beyond 5 h.
[[nodiscard]] BranchData as_half_space(const BranchData& data, const LensAndCounterBody& bodies,
                                       const AnalysisOptions& options);

/// The same with E* and W known.
[[nodiscard]] BranchData as_half_space(const BranchData& data, const contact::layer::Layer& layer,
                                       const contact::AdhesiveContact& contact);

/// Relative error of E* from force and displacement if a layer is treated as a half-space: f/d^(3/2) − 1 of the layer's
/// factors, without adhesion.
[[nodiscard]] double modulus_excess(double contact_radius, double thickness, double poisson_ratio);

}  // namespace setae::loops
