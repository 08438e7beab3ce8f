// SPDX-License-Identifier: GPL-3.0-or-later
#include "foil_alert.hpp"

#include <fmt/format.h>

namespace setae::study {

Alert foil_projection_alert(const std::string& subject, double thickness) {
    constexpr double felt_below = 10.0;  // length of a wave in thicknesses
    return {
        "FOIL_PROJECTION", subject,
        fmt::format("the contour is the silhouette of a foil {:.3g} nm thick, not a line scan: at wavelengths below "
                    "{:.3g} nm C1D is up to a third too low, and the rms slope 1 to 7 %; the likelihood corrects "
                    "this, the average does not",
                    thickness * 1e9, felt_below * thickness * 1e9),
        "use the results of the likelihood (several measurements), or measure thinner foils; see "
        "docs/concepts/tem-projection.md"};
}

}  // namespace setae::study
