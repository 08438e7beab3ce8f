// SPDX-License-Identifier: GPL-3.0-or-later
#include "pinned_stretch.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "branch.hpp"
#include "records/channel_noise.hpp"
#include "records/local_lines.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"

namespace setae::loops {
namespace {

/// Differences of the samples of a branch from those of a pinned edge, and the limit below which they are no motion.
struct Departure {
    std::vector<Index> samples;
    Array1D values;   ///< increases once the edge retracts
    Array1D allowed;  ///< upper limit of noise and of the uncertainty of the contact

    /// The last sample of a pinned edge, counted among them; −1: none.
    [[nodiscard]] Index last_pinned() const {
        Index last = values.size() - 1;
        while (last >= 0 && !(values[last] <= allowed[last])) --last;
        return last;
    }
};

constexpr double deviations = 4.0;

/// Number of neighbours to average so that a departure exceeds the noise, at most a tenth of them all; 1: none.
Index averaged_neighbours(double noise, double visible, Index samples) {
    const double wanted = std::pow(deviations * noise / visible, 2);
    return wanted > 1.0 ? static_cast<Index>(std::min(wanted, 0.1 * static_cast<double>(samples))) | 1 : 1;
}

/// a_max − a of frames.
Departure by_measured_radius(const Loop& loop, const IndexRange& range, double largest, double by_force,
                             const AnalysisOptions& options) {
    constexpr double visible_share = 0.02, rounding = 1e-6;
    Departure departure;
    for (Index i = range.first; i <= range.last; ++i)
        if (loop.contact_radius[i] > 0.0) departure.samples.push_back(i);
    Array1D radii = loop.contact_radius(departure.samples);
    const double noise = options.contact_radius_noise ? *options.contact_radius_noise : white_noise(radii);
    const Index window = averaged_neighbours(noise, visible_share * largest, radii.size());
    double allowed = std::max(deviations * std::hypot(noise, by_force), rounding * largest);
    if (window > 1) {
        // the averaged radii give the largest radius better than a fit at one noisy force
        radii = local_means(radii, window / 2);
        largest = radii.segment(window / 2, radii.size() - 2 * (window / 2)).maxCoeff();
        allowed = deviations * noise / std::sqrt(static_cast<double>(window));
    }
    departure.values = largest - radii;
    departure.allowed = Array1D::Constant(radii.size(), allowed);
    return departure;
}

/// Effect of the error of W on the largest radius; near W = 0 it is proportional to the root of W.
double error_of_largest_radius(double largest_force, const JkrFit& fit, double sphere_radius) {
    const Estimate& work = fit.work_of_adhesion;
    if (!work.uncertain()) return 0.0;
    const auto radius = [&](double w) {
        return contact::jkr::contact_radius_at_force(largest_force,
                                                     {sphere_radius, fit.contact_modulus.value, std::max(w, 0.0)});
    };
    const double here = radius(work.value);
    return std::max(std::abs(radius(work.value + work.standard_error) - here),
                    std::abs(radius(work.value - work.standard_error) - here));
}

/// F − 2a_max E* (δ − δ0 − a_max²/(3R)), the force of a flat punch of that radius and shape.
Departure by_force(const Loop& loop, const Baseline& noise, const IndexRange& range, double largest, const JkrFit& fit,
                   double sphere_radius) {
    constexpr double visible_share = 0.02, accuracy = 0.01, most = 0.05;  // E* and contact point are of a fit
    Departure departure;
    for (Index i = range.first; i <= range.last; ++i) departure.samples.push_back(i);
    const double stiffness = 2.0 * largest * fit.contact_modulus.value;
    const double depth = fit.contact_point.value + largest * largest / (3.0 * sphere_radius);
    const Array1D force = loop.force(departure.samples);
    const double unloaded = force[0] - force.minCoeff();
    const double sigma =
        std::sqrt(std::max(noise.force_noise * noise.force_noise + std::pow(stiffness * noise.displacement_noise, 2) -
                               2.0 * stiffness * noise.force_displacement_covariance,
                           0.0));
    const Index window = averaged_neighbours(sigma, visible_share * unloaded, force.size());
    const Array1D below = loop.displacement(departure.samples) - depth;
    departure.values = local_means(force - stiffness * below, window / 2);
    const Array1D by_radius = 2.0 * fit.contact_modulus.value * error_of_largest_radius(force[0], fit, sphere_radius) *
                              (2.0 / 3.0 * largest * largest / sphere_radius - below).abs();
    departure.allowed = (accuracy * (force[0] - force))
                            .max(by_radius.min(most * (force[0] - force)))
                            .max(deviations * sigma / std::sqrt(static_cast<double>(window)));
    return departure;
}

}  // namespace

std::optional<IndexRange> pinned_stretch(const Loop& loop, const Segments& segments, const ContactSegments& contact,
                                         const ContactAnalysis& analysis, const LensAndCounterBody& bodies,
                                         const AnalysisOptions& options) {
    if (!contact.unloading) return std::nullopt;
    const IndexRange& unloading = *contact.unloading;
    const bool measured = loop.contact_radius.size() > 0;
    if (!measured && !analysis.loading.force_displacement) return std::nullopt;
    const double largest = analysis.context.largest_contact_radius;
    // the largest radius belongs to a noisy force: a ∝ F^(1/3)
    const double radius_error = largest * segments.before.force_noise / (3.0 * analysis.loading.range.force_last);
    const Departure departure = measured ? by_measured_radius(loop, unloading, largest, radius_error, options)
                                         : by_force(loop, segments.before, unloading, largest,
                                                    *analysis.loading.force_displacement, bodies.radius);
    constexpr Index min_left = 10, min_pinned = 2;
    const Index pinned = departure.last_pinned() + 1;
    if (pinned < min_pinned || departure.values.size() - pinned < min_left) return std::nullopt;
    return IndexRange{.first = unloading.first, .last = departure.samples[static_cast<std::size_t>(pinned) - 1]};
}

}  // namespace setae::loops
