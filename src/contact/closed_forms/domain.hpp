// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace setae::contact {

/// @throws InvalidArgument unless R > 0 and E* > 0, both finite.
void require_sphere(double radius, double contact_modulus);

/// @throws InvalidArgument unless value >= 0; `what` names it.
void require_not_negative(double value, const char* what);

/// @throws InvalidArgument unless value > 0; `what` names it.
void require_positive(double value, const char* what);

}  // namespace setae::contact
