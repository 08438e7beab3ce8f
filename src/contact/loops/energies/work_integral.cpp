// SPDX-License-Identifier: GPL-3.0-or-later
#include "work_integral.hpp"

#include <algorithm>
#include <cmath>

#include "records/jump.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"
#include "setae/numerics/bracketing.hpp"

namespace setae::loops {
namespace {

/// ∫∫ of the normal distribution function of a standard deviation: ½ [(x² + σ²) Φ(x/σ) + xσ φ(x/σ)].
double twice_integrated_normal(double x, double deviation) {
    const double ratio = x / deviation;
    const double density = std::exp(-0.5 * ratio * ratio) / std::sqrt(2.0 * pi);
    return 0.5 * ((x * x + deviation * deviation) * normal_probability(ratio) + x * deviation * density);
}

/// P(|N + U_1 + U_2| <= x): N normal, U evenly distributed between ± its limit, all three > 0.
double probability_within(double x, double deviation, const std::array<double, 2>& limits) {
    const auto term = [&](double sign_1, double sign_2) {
        return sign_1 * sign_2 * twice_integrated_normal(x + sign_1 * limits[0] + sign_2 * limits[1], deviation);
    };
    const double below =
        (term(1.0, 1.0) + term(1.0, -1.0) + term(-1.0, 1.0) + term(-1.0, -1.0)) / (4.0 * limits[0] * limits[1]);
    return 2.0 * below - 1.0;
}

}  // namespace

LevelRecord::LevelRecord(const Loop& loop, const Segments& segments, DriftModel drift)
    : zero(force_zero(loop, segments, drift)),
      force(loop.force - zero.value),
      displacement(loop.displacement),
      noise(segments.before) {}

IndexRange closed_range(const Segments& segments, Index contact) {
    const ContactSegments& touch = segments.contacts[static_cast<std::size_t>(contact)];
    const bool last = contact + 1 == static_cast<Index>(segments.contacts.size());
    if (!touch.unloading || (last && !touch.pull_off && !segments.after))
        throw UndefinedDataError("the record ends in contact, so that the loop is not closed");
    IndexRange range = touch.extent;
    const Index starts = touch.jump_in ? touch.jump_in->first : touch.loading.first;
    const Index ends = touch.pull_off ? touch.pull_off->last : touch.unloading->last;
    if (contact == 0) {
        if (segments.before.range) range.first = std::min(std::max(range.first, segments.before.range->last), starts);
        else if (segments.after && !touch.jump_in)
            throw UndefinedDataError("the record begins in contact, so that the loop is not closed");
    }
    if (last && segments.after && segments.after->range)
        range.last = std::max(std::min(range.last, segments.after->range->first), ends);
    return range;
}

double work(const Array1D& force, const Array1D& displacement, const IndexRange& range, Index stride) {
    double sum = 0.0;
    Index i = range.first;
    while (i < range.last) {
        const Index next = std::min(i + stride, range.last);
        sum += 0.5 * (force[i] + force[next]) * (displacement[next] - displacement[i]);
        i = next;
    }
    return sum;
}

double noise_error(const LevelRecord& record, const IndexRange& range) {
    const Array1D &force = record.force, &displacement = record.displacement;
    // correlated noise of neighbours adds up
    const auto correlated = [](double sigma, double phi) { return sigma * sigma * (1.0 + phi) / (1.0 - phi); };
    const double force_variance = correlated(record.noise.force_noise, record.noise.force_noise_correlation),
                 displacement_variance =
                     correlated(record.noise.displacement_noise, record.noise.displacement_noise_correlation);
    double variance = 0.0;
    for (Index i = range.first; i <= range.last; ++i) {
        const Index before = std::max(i - 1, range.first), next = std::min(i + 1, range.last);
        const double by_force = 0.5 * (displacement[next] - displacement[before]);
        // the ends of a stretch bound its area: their motion counts with the whole force
        const double by_displacement = 0.5 * (force[before] - force[next]) - (i == range.first ? force[i] : 0.0) +
                                       (i == range.last ? force[i] : 0.0);
        variance += by_force * by_force * force_variance + by_displacement * by_displacement * displacement_variance +
                    2.0 * by_force * by_displacement * record.noise.force_displacement_covariance;
    }
    return std::sqrt(std::max(variance, 0.0));
}

double drift_error(const LevelRecord& record, const IndexRange& range) {
    if (record.zero.drift.degree == 0) return undefined;
    double squares = 0.0;
    for (Index mode = 0; mode < record.zero.modes.cols(); ++mode)
        squares += std::pow(work(record.zero.modes.col(mode), record.displacement, range), 2);
    return std::sqrt(squares);
}

double compliance_error(const LevelRecord& record, const IndexRange& range, const Estimate& stiffness) {
    if (!stiffness.uncertain()) return 0.0;
    const double squares = std::pow(record.force[range.last], 2) - std::pow(record.force[range.first], 2);
    return std::abs(squares) * stiffness.standard_error / (2.0 * stiffness.value * stiffness.value);
}

double jump_error_limit(const LevelRecord& record, const IndexRange& jump) {
    const Array1D &force = record.force, &displacement = record.displacement;
    const Index at = largest_step(force, jump);
    if (at + 1 >= force.size()) return 0.0;
    const auto area = [&](Index step) {
        if (step < 0 || step + 1 >= force.size()) return 0.0;
        return (force[at + 1] - force[at]) * (displacement[step + 1] - displacement[step]) -
               (displacement[at + 1] - displacement[at]) * (force[step + 1] - force[step]);
    };
    return 0.25 * std::abs(area(at - 1) + area(at + 1));
}

double discretisation_error(const LevelRecord& record, const IndexRange& piece) {
    return (work(record.force, record.displacement, piece, 2) - work(record.force, record.displacement, piece)) / 3.0;
}

double half_width(double deviation, const std::array<double, 2>& limits) {
    // parts a thousand times smaller than the others change nothing, but 0 would divide by 0
    const double least = 1e-3 * (deviation + limits[0] + limits[1]);
    const double smallest = std::max(deviation, least);
    const std::array<double, 2> ends{std::max(limits[0], least), std::max(limits[1], least)};
    constexpr int halvings = 40;
    const auto too_narrow = [&](double width) { return probability_within(width, smallest, ends) < 0.95; };
    return numerics::bisected(too_narrow, 0.0, 4.0 * smallest + ends[0] + ends[1], halvings).second;
}

}  // namespace setae::loops
