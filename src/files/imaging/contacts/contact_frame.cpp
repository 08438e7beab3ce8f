// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/imaging/contact_frame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "coarse_disc.hpp"
#include "edge_rays.hpp"
#include "setae/core/errors.hpp"

namespace setae::imaging {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
constexpr double min_visible = 0.25;  // of the perimeter
constexpr long smallest_frame = 16;

void require_valid(const FramePixels& pixels, const ContactFrameOptions& options) {
    if (!(options.smallest_radius >= 3))
        throw InvalidArgument(
            fmt::format("smallest_radius {} px, expected at least 3: the edge of a smaller disc cannot be fitted",
                        options.smallest_radius));
    if (!(options.min_confidence >= 0 && options.min_confidence <= 1))
        throw InvalidArgument(fmt::format("the confidence limit is {}, expected 0 to 1", options.min_confidence));
    if (pixels.rows() < smallest_frame || pixels.cols() < smallest_frame)
        throw InvalidArgument(fmt::format("a frame of {} × {} pixels, expected at least {} × {}", pixels.cols(),
                                          pixels.rows(), smallest_frame, smallest_frame));
}

ContactFrame without_radius(FrameState state, std::string reason) {
    ContactFrame frame;
    frame.state = state;
    frame.reason = std::move(reason);
    const double none = undefined;
    frame.radius = state == FrameState::no_contact ? 0.0 : none;
    frame.radius_standard_error = frame.roundness = frame.roundness_standard_error = frame.contrast_to_noise =
        frame.edge_width = none;
    frame.ellipse = {none, none, none, none, none, none, none, none};
    return frame;
}

ContactFrame as_frame(const EdgeFit& fit, double sign) {
    ContactFrame frame;
    const auto& outline = fit.outline;
    const auto& covariance = fit.covariance;
    frame.state = FrameState::measured;
    frame.polarity = sign > 0 ? Polarity::dark : Polarity::bright;
    frame.partial = fit.visible_share < 1;
    frame.visible_share = fit.visible_share;
    frame.agreeing_rays = fit.agreeing_share;
    frame.contrast_to_noise = fit.contrast / fit.noise;
    frame.edge_width = fit.edge_width;
    frame.confidence = fit.agreeing_share * std::min(1.0, 2 * fit.visible_share) * std::min(1.0, fit.significance / 5);

    // derivatives of lengths along (mean_radius, stretch_cosine, stretch_sine)
    const double stretch = outline.stretch(), geometric = std::sqrt(outline.semi_major() * outline.semi_minor());
    const Eigen::Vector2d along = stretch > 1e-9
                                      ? Eigen::Vector2d(outline.stretch_cosine, outline.stretch_sine) / stretch
                                      : Eigen::Vector2d(1, 0);
    const Eigen::Matrix3d shape = covariance.bottomRightCorner<3, 3>();
    const auto deviation = [&](double of_mean, double of_stretch) {
        const Eigen::Vector3d slope(of_mean, of_stretch * along[0], of_stretch * along[1]);
        return std::sqrt(std::max(0.0, slope.dot(shape * slope)));
    };
    // a blurred convex edge is inside the true one by w²/(2r): the mean over the blur of the sagitta y²/(2r)
    const double shrinking = fit.edge_width * fit.edge_width / (2 * geometric);
    frame.radius = geometric + shrinking;
    frame.radius_standard_error = deviation(outline.mean_radius / geometric, -stretch / geometric);
    frame.ellipse = {outline.centre_x,
                     outline.centre_y,
                     outline.semi_major() + shrinking,
                     outline.semi_minor() + shrinking,
                     outline.angle(),
                     std::sqrt(0.5 * (covariance(0, 0) + covariance(1, 1))),
                     deviation(1, 1),
                     deviation(1, -1)};
    const double major = frame.ellipse.semi_major, minor = frame.ellipse.semi_minor;
    frame.roundness = minor / major;
    frame.roundness_standard_error = fit.shape == OutlineShape::circle ? undefined
                                                                       : deviation((major - minor) / (major * major),
                                                                                   -(major + minor) / (major * major));
    if (frame.partial)
        frame.reason = fmt::format("the contact extends beyond the frame: {:.0f} % of its edge is visible",
                                   100 * fit.visible_share);
    return frame;
}

std::string reason_against_radius(const ContactFrame& frame, const ContactFrameOptions& options) {
    if (frame.visible_share < min_visible)
        return fmt::format("{:.0f} % of the edge lies within the frame; {:.0f} % are needed", 100 * frame.visible_share,
                           100 * min_visible);
    if (frame.radius < options.smallest_radius)
        return fmt::format("the radius would be {:.1f} px, below the smallest radius of {:g} px", frame.radius,
                           options.smallest_radius);
    if (frame.confidence < options.min_confidence)
        return fmt::format("the confidence is {:.2f}, below {:.2f}: {:.0f} % of the rays agree", frame.confidence,
                           options.min_confidence, 100 * frame.agreeing_rays);
    return {};
}

}  // namespace

ContactFrame measure_contact_frame(const FramePixels& pixels, const ContactFrameOptions& options) {
    require_valid(pixels, options);
    constexpr double beyond_doubt = 0.85;  // confidence above which no other candidate is tested
    std::string reason = "a structure is visible, but it is not round";
    double highest = -1, best = -1;
    bool structure = false;
    ContactFrame chosen;
    for (int level = 0;; ++level) {
        const auto found = find_discs(pixels, options, level);
        structure = structure || found.structure;
        for (const auto& candidate : found.candidates) {
            const double uncertainty =
                std::min(static_cast<double>(std::max(2L, found.binning)), 0.3 * candidate.outline.mean_radius);
            const auto fit = fit_edge(pixels, candidate.outline, candidate.sign, uncertainty, options.fringes);
            if (!fit.failure.empty()) {
                if (highest < 0) reason = fit.failure;
                continue;
            }
            const auto frame = as_frame(fit, candidate.sign);
            const auto doubt = reason_against_radius(frame, options);
            if (doubt.empty() && frame.confidence > beyond_doubt) return frame;
            const double score = frame.confidence * frame.contrast_to_noise *
                                 frame.radius;  // glare and dust are small, illumination is faint
            if (doubt.empty() && score > best) {
                best = score;
                chosen = frame;
            }
            if (frame.confidence > highest) {
                highest = frame.confidence;
                reason = doubt;
            }
        }
        if (found.last_level) break;
    }
    if (best > 0) return chosen;
    if (!structure) return without_radius(FrameState::no_contact, "no structure exceeds noise and uneven illumination");
    return without_radius(FrameState::not_found, reason);
}

}  // namespace setae::imaging
