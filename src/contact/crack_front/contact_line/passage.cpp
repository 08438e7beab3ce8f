// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "setae/contact_line/line_motion.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"

namespace setae::contact_line {
namespace {

constexpr double max_rings = 1e5;

/// A ring of fewer noises would take its speed from them.
double suggested_width(const ContactLine& line) {
    std::vector<double> steps;
    for (Index i = 1; i < line.frames(); ++i)
        for (Index j = 0; j < line.angles(); ++j) {
            const double step = std::abs(line.radius(i, j) - line.radius(i - 1, j));
            if (step > 0.0) steps.push_back(step);
        }
    if (steps.empty()) throw UndefinedDataError("the contact line does not move");
    return std::max(median(steps), 3.0 * line.place_error);
}

/// Time at which the edge at one angle first passes each of the bounds, which are in the order of the motion; NaN for
/// never, and where it is beyond a bound from the first frame on.
Array1D first_passages(const ContactLine& line, Index angle, const Array1D& bounds, double sign) {
    Array1D times = Array1D::Constant(bounds.size(), undefined);
    Index next = 0;
    while (next < bounds.size() && sign * bounds[next] < sign * line.radius(0, angle)) ++next;
    for (Index i = 1; i < line.frames() && next < bounds.size(); ++i) {
        const double before = sign * line.radius(i - 1, angle), now = sign * line.radius(i, angle);
        for (; next < bounds.size() && sign * bounds[next] <= now; ++next) {
            const double share = now > before ? (sign * bounds[next] - before) / (now - before) : 0.0;
            times[next] = line.time[i - 1] + share * (line.time[i] - line.time[i - 1]);
        }
    }
    return times;
}

}  // namespace

Passage passage(const ContactLine& line, Direction direction, double ring_width) {
    require_valid(line);
    if (line.frames() < 2)
        throw InvalidArgument("a contact line of one frame; expected at least two, which show a motion");
    if (!(ring_width >= 0.0))
        throw InvalidArgument(
            fmt::format("a ring {} m wide; expected a width above 0, or 0 to let the program choose", ring_width));
    Passage result;
    result.direction = direction;
    result.width = ring_width > 0.0 ? ring_width : suggested_width(line);
    const double smallest = line.radius.minCoeff(), largest = line.radius.maxCoeff(),
                 count = std::ceil((largest - smallest) / result.width);
    if (count > max_rings)
        throw InvalidArgument(fmt::format("{:.0f} rings of {:.3g} m; expected at most {:.0f}: choose wider rings",
                                          count, result.width, max_rings));
    const auto rings = std::max<Index>(1, static_cast<Index>(count));
    const double sign = direction == Direction::receding ? -1.0 : 1.0,
                 start = direction == Direction::receding ? largest : smallest;
    const Array1D bounds = start + sign * result.width * Array1D::LinSpaced(rings + 1, 0.0, static_cast<double>(rings));
    result.ring = 0.5 * (bounds.head(rings) + bounds.tail(rings));
    result.speed = Array2D::Constant(line.angles(), rings, undefined);
    double crossings = 0.0, whole_time = 0.0;
    for (Index j = 0; j < line.angles(); ++j) {
        const auto times = first_passages(line, j, bounds, sign);
        for (Index k = 0; k < rings; ++k) {
            const double taken = times[k + 1] - times[k];
            if (!(taken > 0.0)) continue;
            result.speed(j, k) = result.width / taken;
            crossings += 1.0;
            whole_time += taken;
        }
    }
    if (crossings == 0.0)
        throw UndefinedDataError(fmt::format("the contact line crosses no ring of {:.3g} m while it is {}",
                                             result.width,
                                             direction == Direction::receding ? "receding" : "advancing"));
    result.mean_speed = crossings * result.width / whole_time;
    return result;
}

Array1D relative_speeds(const Passage& passage) {
    std::vector<double> speeds;
    for (const double v : passage.speed.reshaped<Eigen::RowMajor>())
        if (v > 0.0) speeds.push_back(v / passage.mean_speed);
    return Eigen::Map<Array1D>(speeds.data(), static_cast<Index>(speeds.size()));
}

}  // namespace setae::contact_line
