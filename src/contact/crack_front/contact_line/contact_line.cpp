// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact_line/contact_line.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::contact_line {
namespace {

constexpr Index min_angles = 16;

/// Root mean square of a closed line without the harmonics 0, 1 and 2.
double deviation_of(const ArrayView1D& radius) {
    const auto n = static_cast<double>(radius.size());
    double square = (radius - radius.mean()).square().mean();
    for (int mode = 1; mode <= 2; ++mode) {
        double cosine = 0.0, sine = 0.0;
        for (Index j = 0; j < radius.size(); ++j) {
            const double phase = 2.0 * pi * mode * static_cast<double>(j) / n;
            cosine += radius[j] * std::cos(phase);
            sine += radius[j] * std::sin(phase);
        }
        square -= 2.0 * (cosine * cosine + sine * sine) / (n * n);
    }
    return std::sqrt(std::max(0.0, square));
}

double perimeter_of(const ArrayView1D& radius) {
    const Index n = radius.size();
    const double cosine = std::cos(2.0 * pi / static_cast<double>(n));
    double length = 0.0;
    for (Index j = 0; j < n; ++j) {
        const double r = radius[j], next = radius[(j + 1) % n];
        length += std::sqrt(r * r + next * next - 2.0 * r * next * cosine);
    }
    return length;
}

}  // namespace

void require_valid(const ContactLine& line) {
    if (line.frames() < 1 || line.time.size() != line.frames())
        throw InvalidArgument(fmt::format("a contact line of {} times and {} frames; expected one time for each frame",
                                          line.time.size(), line.frames()));
    if (line.angles() < min_angles)
        throw InvalidArgument(
            fmt::format("a contact line at {} angles; expected at least {}", line.angles(), min_angles));
    if (!(line.place_error >= 0.0) || std::isinf(line.place_error))
        throw InvalidArgument(
            fmt::format("a standard error of {} m for a place of the line; expected 0 or more", line.place_error));
    for (Index i = 0; i < line.frames(); ++i) {
        if (!std::isfinite(line.time[i]) || (i > 0 && !(line.time[i] > line.time[i - 1])))
            throw InvalidArgument(fmt::format("frame {} of a contact line is at {} s; expected times that increase",
                                              i + 1, line.time[i]));
        for (Index j = 0; j < line.angles(); ++j)
            if (!(line.radius(i, j) > 0.0) || std::isinf(line.radius(i, j)))
                throw InvalidArgument(
                    fmt::format("frame {} of a contact line: the radius at angle {} of {} is {} m; expected above 0",
                                i + 1, j + 1, line.angles(), line.radius(i, j)));
    }
}

LineShape line_shape(const ContactLine& line) {
    require_valid(line);
    const Index frames = line.frames();
    LineShape shape{Array1D(frames), Array1D(frames), Array1D(frames), Array1D(frames)};
    for (Index i = 0; i < frames; ++i) {
        const Array1D radius = line.radius.row(i).transpose();
        shape.mean_radius[i] = radius.mean();
        shape.area[i] = pi * radius.square().mean();
        shape.perimeter[i] = perimeter_of(radius);
        shape.deviation[i] = deviation_of(radius);
    }
    return shape;
}

}  // namespace setae::contact_line
