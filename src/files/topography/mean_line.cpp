// SPDX-License-Identifier: GPL-3.0-or-later
#include "mean_line.hpp"

#include <algorithm>
#include <cmath>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::topography {

Array1D lengths_along(const Array1D& x, const Array1D& y) {
    Array1D length = Array1D::Zero(x.size());
    for (Index i = 1; i < x.size(); ++i) length[i] = length[i - 1] + std::hypot(x[i] - x[i - 1], y[i] - y[i - 1]);
    return length;
}

MeanLine mean_line(const Array1D& x, const Array1D& y) {
    const auto segments = x.size() - 1;
    const Array1D step_x = x.tail(segments) - x.head(segments), step_y = y.tail(segments) - y.head(segments);
    const Array1D length = (step_x.square() + step_y.square()).sqrt();
    MeanLine line;
    line.length = length.sum();
    if (!(line.length > 0.0))
        throw UndefinedDataError("a curve of length 0 has no mean line; expected points at different places");
    const Array1D middle_x = 0.5 * (x.tail(segments) + x.head(segments)),
                  middle_y = 0.5 * (y.tail(segments) + y.head(segments));
    line.centre = {(length * middle_x).sum() / line.length, (length * middle_y).sum() / line.length};
    const Array1D u = middle_x - line.centre[0], v = middle_y - line.centre[1];
    // about its middle a segment has the moment length · step²/12
    const double xx = (length * (u.square() + step_x.square() / 12.0)).sum() / line.length;
    const double yy = (length * (v.square() + step_y.square() / 12.0)).sum() / line.length;
    const double xy = (length * (u * v + step_x * step_y / 12.0)).sum() / line.length;
    line.angle = 0.5 * std::atan2(2.0 * xy, xx - yy);
    const double end_x = x[segments] - x[0], end_y = y[segments] - y[0];
    const double along = end_x * std::cos(line.angle) + end_y * std::sin(line.angle);
    const double across = end_y * std::cos(line.angle) - end_x * std::sin(line.angle);
    if (std::abs(across) > std::abs(along)) line.angle = std::atan2(end_y, end_x);
    else if (along < 0.0) line.angle += line.angle > 0.0 ? -pi : pi;
    const double c = std::cos(line.angle), s = std::sin(line.angle);
    line.mean_square_distance = std::max(0.0, xx * s * s - 2.0 * xy * s * c + yy * c * c);
    return line;
}

}  // namespace setae::topography
