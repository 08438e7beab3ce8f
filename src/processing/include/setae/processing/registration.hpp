// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::processing {

/// By how much one map lies beside another.
struct Shift {
    double x = 0.0;           ///< [m]
    double y = 0.0;           ///< [m]
    double agreement = 0.0;   ///< correlation coefficient of the heights on the common area at that shift, −1 … 1
};

/// The shift d for which moved(x + d) agrees best with fixed(x).
///
/// Phase correlation, the peak of the inverse transform of H_fixed conj(H_moved)/|…|, of both maps minus their planes, under Hann windows where they are
/// not periodic, then the least squares of fixed(x) − moved(x + d) over the common points by Gauss–Newton, with bicubic interpolation. Undefined points count as the plane in the
/// first part and are left out of the second. Both on pixels of the same size (1e-6); shifts up to half the smaller map.
/// Accuracy on rough maps without noise: 0.01 pixel; with noise of the same rms in both: about noise/(rms slope · sqrt(points)).
/// @throws InvalidArgument for pixels that differ or fewer than eight points a direction; UndefinedDataError for maps without contrast.
[[nodiscard]] Shift shift_between(const topography::HeightMap& fixed, const topography::HeightMap& moved, parallel::Threads threads = {});

}  // namespace setae::processing
