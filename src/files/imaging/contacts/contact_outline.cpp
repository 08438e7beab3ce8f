// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/imaging/contact_outline.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "contact_voids.hpp"
#include "outline_path.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"
#include "setae/core/units.hpp"

namespace setae::imaging {
namespace {

constexpr double sample = 0.5;                              // px along a ray
constexpr Index half_step = 6, level_samples = 8;           // 3 px of a step, 4 px of a level
constexpr Index reach = half_step + level_samples;          // samples needed for a place on either side
constexpr double smallest_place = 8.0, search_range = 0.3;  // px; of the radius
constexpr double cost = 0.05, level_arc = 16.0;             // of a half pixel; px along the edge
constexpr Index max_shift = 3;                              // samples between neighbouring rays

double between(const FramePixels& pixels, double x, double y) {
    const auto column = static_cast<Index>(x), row = static_cast<Index>(y);
    const double u = x - static_cast<double>(column), v = y - static_cast<double>(row);
    const auto grey = [&](Index i, Index j) { return static_cast<double>(pixels(i, j)); };
    return (1 - v) * ((1 - u) * grey(row, column) + u * grey(row, column + 1)) +
           v * ((1 - u) * grey(row + 1, column) + u * grey(row + 1, column + 1));
}

/// Grey levels along rays, from `first` [px] on, every half pixel.
struct Polar {
    double first = 0;
    Array2D grey;  ///< (rays, samples)

    /// Mean of so many samples from `begin` on.
    [[nodiscard]] double mean(Index ray, Index begin, Index count) const {
        return grey.row(ray).segment(begin, count).mean();
    }
};

Polar sampled(const FramePixels& pixels, double centre_x, double centre_y, double first, double last, Index count) {
    Polar polar{first, Array2D(count, static_cast<Index>(std::floor((last - first) / sample)) + 1)};
    for (Index j = 0; j < count; ++j) {
        const double angle = 2.0 * pi * static_cast<double>(j) / static_cast<double>(count), c = std::cos(angle),
                     s = std::sin(angle);
        for (Index k = 0; k < polar.grey.cols(); ++k) {
            const double r = first + sample * static_cast<double>(k);
            polar.grey(j, k) = between(pixels, centre_x + r * c, centre_y + r * s);
        }
    }
    return polar;
}

/// Steps at samples reach … K − 1 − reach over the largest of the median ray.
Array2D steps(const Polar& polar, double sign) {
    Array2D step(polar.grey.rows(), polar.grey.cols() - 2 * reach);
    std::vector<double> largest;
    for (Index j = 0; j < step.rows(); ++j) {
        for (Index k = 0; k < step.cols(); ++k)
            step(j, k) =
                sign * (polar.mean(j, k + reach + 1, half_step) - polar.mean(j, k + reach - half_step, half_step));
        largest.push_back(step.row(j).maxCoeff());
    }
    return step / std::max(median(largest), 1e-12);
}

/// Mean over `half` neighbours on either side of a ring of numbers.
Array1D ring_mean(const Array1D& values, Index half) {
    const Index n = values.size();
    Array1D mean = Array1D::Zero(n);
    for (Index j = 0; j < n; ++j)
        for (Index d = -half; d <= half; ++d) mean[j] += values[(j + d + n) % n] / static_cast<double>(2 * half + 1);
    return mean;
}

struct Places {
    Array1D radius;  ///< [px]
    double inner = 0, outer = 0;
};

Places places_on(const std::vector<Index>& path, const Polar& polar, Index half_arc) {
    const Index count = polar.grey.rows();
    Array1D inner(count), outer(count);
    for (Index j = 0; j < count; ++j) {
        const Index at = path[static_cast<std::size_t>(j)] + reach;
        inner[j] = polar.mean(j, at - reach, level_samples);
        outer[j] = polar.mean(j, at + half_step + 1, level_samples);
    }
    inner = ring_mean(inner, half_arc);
    outer = ring_mean(outer, half_arc);
    Places places{Array1D(count), inner.mean(), outer.mean()};
    for (Index j = 0; j < count; ++j) {
        const Index begin = path[static_cast<std::size_t>(j)] + reach - half_step;
        const Array1D inside =
            (outer[j] - polar.grey.row(j).segment(begin, 2 * half_step + 1).transpose()) / (outer[j] - inner[j]);
        const double covered = sample * (inside.sum() - 0.5 * (inside[0] + inside[2 * half_step]));  // by trapezia
        places.radius[j] = polar.first + sample * static_cast<double>(begin) + covered;
    }
    return places;
}

/// Standard deviation of the noise of a pixel: of second differences along the rows away from the edge, 6 σ² for white
/// noise, by their median. A contact without noise gives 0.
double pixel_noise(const FramePixels& pixels, const TracedEdge& edge) {
    constexpr double off_edge = 5.0, normal = 1.4826;
    const double reach_of_disc = 1.5 * edge.radius.maxCoeff();
    std::vector<double> differences;
    for (Index row = 0; row < pixels.rows(); ++row)
        for (Index column = 1; column + 1 < pixels.cols(); ++column) {
            const auto x = static_cast<double>(column), y = static_cast<double>(row);
            if (std::hypot(x - edge.centre_x, y - edge.centre_y) > reach_of_disc) continue;
            if (std::abs(edge.distance(x, y)) < off_edge) continue;
            differences.push_back(std::abs(
                static_cast<double>(pixels(row, column - 1) - 2.0F * pixels(row, column) + pixels(row, column + 1))));
        }
    return differences.empty() ? 0.0 : normal * median(differences) / std::sqrt(6.0);
}

}  // namespace

ContactOutline trace_contact_outline(const FramePixels& pixels, const ContactFrame& contact, double centre_x,
                                     double centre_y, Index angles, double smallest_void) {
    if (contact.state != FrameState::measured || contact.partial)
        throw InvalidArgument(fmt::format("the contact is {}; expected a whole contact, which its outline needs",
                                          contact.partial ? "partly seen" : to_string(contact.state)));
    if (angles < 16) throw InvalidArgument(fmt::format("an outline at {} angles; expected at least 16", angles));
    const double off = std::hypot(contact.ellipse.centre_x - centre_x, contact.ellipse.centre_y - centre_y);
    const double levels = sample * static_cast<double>(reach);
    const double first =
        std::max(smallest_place - levels, (1.0 - search_range) * contact.ellipse.semi_minor - off - levels);
    const double last = (1.0 + search_range) * contact.ellipse.semi_major + off + levels;
    const double room = std::min({centre_x, centre_y, static_cast<double>(pixels.cols()) - 2.0 - centre_x,
                                  static_cast<double>(pixels.rows()) - 2.0 - centre_y});
    if (room < contact.ellipse.semi_major + off + levels)
        throw InvalidArgument(
            fmt::format("the edge is {:.0f} px from the centre and {:.0f} px from the border of the frame; expected "
                        "{:.0f} px around it",
                        contact.ellipse.semi_major + off, room, levels));
    const double sign = contact.polarity == Polarity::bright ? -1.0 : 1.0;
    const auto polar = sampled(pixels, centre_x, centre_y, first, std::min(last, room), angles);
    const double arc = 2.0 * pi * contact.radius / static_cast<double>(angles);
    const auto half_arc = std::clamp<Index>(static_cast<Index>(std::lround(0.5 * level_arc / arc)), 0, angles / 4);
    const auto places = places_on(closed_path(steps(polar, sign), cost, max_shift), polar, half_arc);
    // white noise between pixels: linear interpolation has the variance (1 − u)² + u², 2/3 on average
    const double window = 2.0 * sample * static_cast<double>(half_step);
    const TracedEdge edge{places.radius, centre_x, centre_y};
    const double place_error =
        std::sqrt(window * 2.0 / 3.0) * pixel_noise(pixels, edge) / std::abs(places.outer - places.inner);
    return {places.radius, place_error, contact_voids(pixels, edge, places.inner, places.outer, smallest_void)};
}

}  // namespace setae::imaging
