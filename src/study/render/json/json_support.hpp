// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace setae::output {

/// Origin of the parameters of a spectrum, by the conversion.
inline constexpr const char* exact_source = "moments of C1D or C_iso, exact for isotropic surfaces; THEORY 4.1";
inline constexpr const char* eq11_source = "moments of C1D by [D19], Eq. 11";

}  // namespace setae::output
