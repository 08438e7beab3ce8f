// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace setae::synthesis {

/// @throws InvalidArgument for an rms height [m] that is not positive and finite.
void require_rms_height(double rms_height);

/// The factor from the actual to the wanted rms height. @throws InvalidArgument without roughness to scale.
[[nodiscard]] double scale_to(double wanted, double found);

}  // namespace setae::synthesis
