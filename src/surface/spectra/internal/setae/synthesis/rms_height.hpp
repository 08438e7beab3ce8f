// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace setae::synthesis {

/// @throws InvalidArgument for an rms height [m] that is not positive and finite.
void require_rms_height(double rms_height);

/// The factor from the rms height found to the one wanted. @throws InvalidArgument where there is no roughness to
/// scale.
[[nodiscard]] double scale_to(double wanted, double found);

}  // namespace setae::synthesis
