// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/imaging/contour_trace.hpp"
#include "two_phases.hpp"

namespace setae::imaging {

/// A picture prepared for tracing.
struct PreparedPicture {
    FramePixels pixels;         ///< defined everywhere, without spikes, smoothed if requested
    PixelMask hidden;           ///< 1 where the picture shows no sample: given regions, undefined pixels
    int grey_levels = 0;        ///< 1, 2 or 3 for more, of pixels that are not hidden
    std::vector<Alert> alerts;  ///< UNDEF, SPIKES
};

/// Pixels above, or below, all eight neighbours by more than 8 standard deviations of the noise are spikes (X-rays,
/// dead pixels) and are replaced by the median of the neighbours. The noise is that of differences between neighbours,
/// by their median.
/// @throws InvalidArgument for regions outside the picture; UndefinedDataError if no pixel remains.
[[nodiscard]] PreparedPicture prepared_picture(const FramePixels& pixels, const TraceOptions& options);

}  // namespace setae::imaging
