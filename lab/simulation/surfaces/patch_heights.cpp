// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_heights.hpp"

#include <algorithm>
#include <cmath>

#include "setae/core/constants.hpp"
#include "spectral_moment.hpp"

namespace setae::simulation {

PatchHeights::PatchHeights(const KnownSurface& surface, double patch_size, numerics::RandomKey key) {
    if (surface.gaussian()) return;
    const Band all = surface.band();
    const auto variance_below = [&](double upper) {
        return spectral_moment(surface.C_iso, 0.0, all.lower, {0.0, upper}) / (2.0 * pi);
    };
    rms_height_ = std::sqrt(variance_below(all.upper));
    // a periodic patch has no wave with half of its lowest wavevector
    const double longer = std::min(variance_below(std::min(pi / patch_size, all.upper)), rms_height_ * rms_height_);
    level_ = std::sqrt(longer) * numerics::normal_number(key, 0);
    transform_ = synthesis::lognormal_heights(surface.skewness);
}

void PatchHeights::operator()(double* heights, Index count) const {
    if (!transform_) return;
    const double about = transform_(level_ / rms_height_);
    for (Index i = 0; i < count; ++i)
        heights[i] = rms_height_ * (transform_((heights[i] + level_) / rms_height_) - about);
}

}  // namespace setae::simulation
