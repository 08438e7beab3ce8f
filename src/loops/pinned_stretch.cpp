// SPDX-License-Identifier: GPL-3.0-or-later
#include "pinned_stretch.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "branch.hpp"
#include "records/channel_noise.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"

namespace setae::loops {
namespace {

/// Contact radii of the samples in which they are known.
struct Radii {
    std::vector<Index> samples;
    Array1D values;  ///< [m]
    double noise = 0.0;
};

Radii measured_radii(const Loop& loop, const IndexRange& range, const AnalysisOptions& options) {
    Radii radii;
    for (Index i = range.first; i <= range.last; ++i)
        if (loop.contact_radius[i] > 0.0) radii.samples.push_back(i);
    radii.values.resize(static_cast<Index>(radii.samples.size()));
    for (Index k = 0; k < radii.values.size(); ++k)
        radii.values[k] = loop.contact_radius[radii.samples[static_cast<std::size_t>(k)]];
    radii.noise = options.contact_radius_noise ? *options.contact_radius_noise : white_noise(radii.values);
    return radii;
}

Radii implied_radii(const Loop& loop, const Segments& segments, const ContactAnalysis& analysis,
                    const IndexRange& range, double sphere_radius) {
    Radii radii;
    const JkrFit& fit = *analysis.loading.force_displacement;
    const contact::SphereOnFlat bodies{sphere_radius, fit.contact_modulus.value};
    radii.values.resize(range.count());
    for (Index k = 0; k < range.count(); ++k) {
        const Index i = range.first + k;
        radii.samples.push_back(i);
        radii.values[k] = contact::jkr::contact_radius_at(loop.force[i] - segments.before.force,
                                                          loop.displacement[i] - fit.contact_point.value, bodies);
    }
    radii.noise = white_noise(radii.values);
    return radii;
}

/// Means over so many neighbours, fewer at the ends.
Array1D running_means(const Array1D& values, Index window) {
    Array1D means(values.size());
    for (Index i = 0; i < values.size(); ++i) {
        const Index half = std::min({window / 2, i, values.size() - 1 - i});
        means[i] = values.segment(i - half, 2 * half + 1).mean();
    }
    return means;
}

/// How many neighbours to average so that the noise does not hide a change of the radius by a fiftieth, at most a tenth
/// of them all; 1 where it does not.
Index averaged_neighbours(const Radii& radii, double largest, double deviations) {
    constexpr double visible_share = 0.02;
    const double wanted = std::pow(deviations * radii.noise / (visible_share * largest), 2);
    return wanted > 1.0 ? static_cast<Index>(std::min(wanted, 0.1 * static_cast<double>(radii.values.size()))) | 1 : 1;
}

/// The radius above which the edge counts as where it was at the largest force.
double least_pinned_radius(Radii& radii, double largest, double by_force) {
    constexpr double deviations = 4.0, rounding = 1e-6;
    const Index window = averaged_neighbours(radii, largest, deviations);
    if (window == 1) return largest - std::max(deviations * std::hypot(radii.noise, by_force), rounding * largest);
    // the averaged radii know the largest better than a fit at one noisy force does
    radii.values = running_means(radii.values, window);
    return radii.values.segment(window / 2, radii.values.size() - 2 * (window / 2)).maxCoeff() -
           deviations * radii.noise / std::sqrt(static_cast<double>(window));
}

}  // namespace

std::optional<IndexRange> pinned_stretch(const Loop& loop, const Segments& segments, const ContactSegments& contact,
                                         const ContactAnalysis& analysis, const LensAndCounterBody& bodies,
                                         const AnalysisOptions& options) {
    if (!contact.unloading) return std::nullopt;
    const IndexRange& unloading = *contact.unloading;
    const bool measured = loop.contact_radius.size() > 0;
    if (!measured && !analysis.loading.force_displacement) return std::nullopt;
    Radii radii = measured ? measured_radii(loop, unloading, options)
                           : implied_radii(loop, segments, analysis, unloading, bodies.radius);
    constexpr Index fewest_left = 10, fewest_pinned = 2;
    const double largest = analysis.context.largest_contact_radius;
    // the largest radius belongs to a noisy force: a ∝ F^(1/3)
    const double by_force = largest * segments.before.force_noise / (3.0 * analysis.loading.range.force_last);
    const double least = least_pinned_radius(radii, largest, by_force);
    Index pinned = radii.values.size();
    while (pinned > 0 && !(radii.values[pinned - 1] >= least)) --pinned;
    if (pinned < fewest_pinned || radii.values.size() - pinned < fewest_left) return std::nullopt;
    return IndexRange{.first = unloading.first, .last = radii.samples[static_cast<std::size_t>(pinned) - 1]};
}

}  // namespace setae::loops
