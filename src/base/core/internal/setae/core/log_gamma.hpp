// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace setae {

/// ln |Γ(x)|; infinite at 0, −1, −2 ….
///
/// Unlike std::lgamma, it does not write the sign of Γ to a variable shared by all threads.
[[nodiscard]] double log_gamma(double x);

}  // namespace setae
