// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::fourier {

/// Smallest number >= `least`, and >= 1, without prime factors above 5: fast transform lengths.
[[nodiscard]] Index fast_length(Index least);

}  // namespace setae::fourier
