// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/imaging/contour_profile.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::imaging {

topography::TracedCurve traced_curve(const ContourSegment& segment, const PixelSize& pixel_size) {
    if (!(pixel_size.x > 0 && pixel_size.y > 0 && std::isfinite(pixel_size.x) && std::isfinite(pixel_size.y)))
        throw InvalidArgument(fmt::format("pixels of {} m × {} m; sizes must be positive", pixel_size.x, pixel_size.y));
    topography::TracedCurve curve;
    curve.x = pixel_size.x * segment.x;
    curve.y = -pixel_size.y * segment.y;
    curve.closed = segment.closed;
    double metres = 0, pixels = 0;
    for (Index i = 1; i < segment.x.size(); ++i) {
        metres += std::hypot(curve.x[i] - curve.x[i - 1], curve.y[i] - curve.y[i - 1]);
        pixels += std::hypot(segment.x[i] - segment.x[i - 1], segment.y[i] - segment.y[i - 1]);
    }
    const bool square = pixel_size.x == pixel_size.y;
    const double along = square || pixels == 0 ? std::sqrt(pixel_size.x * pixel_size.y) : metres / pixels;
    const double across = square ? along : pixel_size.x * pixel_size.y / along;
    curve.standard_error = across * segment.standard_error;
    if (segment.edge_width > 0)
        curve.response = topography::TraceResponse{
            .blur = segment.edge_width * along,
            .smoothing_length = segment.smoothing_length * along,
            .step =
                pixels > 0 && segment.x.size() > 1 ? pixels / static_cast<double>(segment.x.size() - 1) * along : along,
            .noise_density = segment.noise_density * along * across * across};
    return curve;
}

}  // namespace setae::imaging
