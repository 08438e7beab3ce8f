// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/synthesis/rms_height.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::synthesis {

void require_rms_height(double rms_height) {
    if (!(rms_height > 0.0) || !std::isfinite(rms_height))
        throw InvalidArgument(fmt::format("rms height {} m; expected a positive length", rms_height));
}

double scale_to(double wanted, double found) {
    if (!(found > 0.0))
        throw InvalidArgument(
            "an rms height is given, but the power spectrum is zero at all modes of the grid; expected "
            "power between 2π/size and π/pixel size");
    return wanted / found;
}

}  // namespace setae::synthesis
