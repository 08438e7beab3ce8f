// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace setae {

/// ln |Γ(x)|; infinite at 0, −1, −2 ….
///
/// As std::lgamma, which leaves the sign of Γ in a variable that all threads share.
[[nodiscard]] double log_gamma(double x);

}  // namespace setae
