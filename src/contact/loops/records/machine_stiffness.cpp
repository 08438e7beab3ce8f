// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/machine_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "baseline.hpp"
#include "fits/correlated_residuals.hpp"
#include "setae/core/errors.hpp"

namespace setae::loops {
namespace {

/// Force against stage on one branch.
struct Branch {
    Array1D stage;  ///< [m]
    Array1D force;  ///< [N]
};

/// F = slope · (stage − stage at F = 0).
struct Line {
    double slope = 0.0;           ///< [N/m]
    double standard_error = 0.0;  ///< [N/m]
    double zero = 0.0;            ///< [m]

    [[nodiscard]] double stage_at(double force) const { return zero + force / slope; }
};

Branch branch_above(const Loop& loop, const Segments& segments, const IndexRange& range, double least) {
    std::vector<Index> samples;
    for (Index i = range.first; i <= range.last; ++i) {
        const bool ignored = std::any_of(segments.ignored.begin(), segments.ignored.end(),
                                         [&](const IndexRange& r) { return r.contains(i); });
        if (!ignored && loop.force[i] - segments.before.force >= least) samples.push_back(i);
    }
    Branch branch{Array1D(static_cast<Index>(samples.size())), Array1D(static_cast<Index>(samples.size()))};
    for (Index k = 0; k < branch.force.size(); ++k) {
        branch.stage[k] = loop.displacement[samples[static_cast<std::size_t>(k)]];
        branch.force[k] = loop.force[samples[static_cast<std::size_t>(k)]] - segments.before.force;
    }
    constexpr Index fewest = 10;
    if (branch.force.size() < fewest)
        throw UndefinedDataError(
            fmt::format("{} samples of the rigid contact lie above {:.3g} N; a machine stiffness needs at least {}",
                        branch.force.size(), least, fewest));
    return branch;
}

/// Huber's M-estimate of a straight line: residuals beyond 1.345 standard deviations, that of the middle half, enter by
/// their sign only.
Line robust_line(const Branch& branch) {
    constexpr double bend = 1.345, scatter_over_median_deviation = 1.4826;
    constexpr int rounds = 30;
    const double origin = branch.stage.mean();
    const Array1D stage = branch.stage - origin;
    Array1D weight = Array1D::Ones(stage.size());
    double slope = 0.0, level = 0.0;
    for (int round = 0; round < rounds; ++round) {
        const double sum = weight.sum();
        const double mean_stage = (weight * stage).sum() / sum, mean_force = (weight * branch.force).sum() / sum;
        const double spread = (weight * (stage - mean_stage).square()).sum();
        if (!(spread > 0.0))
            throw UndefinedDataError(
                "the stage does not move along the branch, so that there is no stiffness to measure");
        slope = (weight * (stage - mean_stage) * (branch.force - mean_force)).sum() / spread;
        level = mean_force - slope * mean_stage;
        const Array1D distance = (branch.force - level - slope * stage).abs();
        const double limit = bend * scatter_over_median_deviation * median_of(distance);
        if (!(limit > 0.0)) break;
        weight = (distance <= limit).select(1.0, limit / distance.max(limit));
    }
    if (!(slope > 0.0))
        throw UndefinedDataError(
            "the force does not rise with the stage, as it does in a rigid contact; check the signs of the "
            "columns");
    Eigen::MatrixXd design(stage.size(), 2);
    design << weight.sqrt() * stage, weight.sqrt();
    const Eigen::VectorXd residuals = weight.sqrt() * (branch.force - level - slope * stage);
    return {.slope = slope,
            .standard_error = std::sqrt(correlated_covariance(design, residuals).covariance(0, 0)),
            .zero = origin - level / slope};
}

/// Change of slope from the lower to the upper half of the forces, divided by the slope; with its standard error.
Estimate slope_growth(const Branch& branch, double slope) {
    const double middle = 0.5 * (branch.force.minCoeff() + branch.force.maxCoeff());
    const auto half = [&](bool upper) {
        std::vector<double> stage, force;
        for (Index i = 0; i < branch.force.size(); ++i)
            if ((branch.force[i] >= middle) == upper) {
                stage.push_back(branch.stage[i]);
                force.push_back(branch.force[i]);
            }
        const auto array = [](const std::vector<double>& v) {
            return Array1D(Eigen::Map<const Array1D>(v.data(), static_cast<Index>(v.size())));
        };
        return Branch{array(stage), array(force)};
    };
    const Branch lower = half(false), upper = half(true);
    constexpr Index fewest = 4;
    if (std::min(lower.force.size(), upper.force.size()) < fewest) return {.value = 0.0, .standard_error = 0.0};
    const Line below = robust_line(lower), above = robust_line(upper);
    return {.value = (above.slope - below.slope) / slope,
            .standard_error = std::hypot(above.standard_error, below.standard_error) / slope};
}

/// For hard bodies without adhesion: up to the largest force, and from there on.
Segments pressed_and_released(const Loop& loop) {
    Index peak = 0;
    (void)loop.force.maxCoeff(&peak);
    const Index last = loop.force.size() - 1, before = std::max<Index>(1, loop.force.size() / 20);
    Segments segments;
    segments.before.force = median_of(loop.force.head(before));
    segments.contacts.push_back({.loading = {0, peak}});
    constexpr Index fewest = 10;
    if (last - peak >= fewest) segments.contacts.back().unloading = IndexRange{peak, last};
    return segments;
}

}  // namespace

MachineStiffness machine_stiffness_from_rigid_contact(const Loop& loop, const Segments& segments, Index contact,
                                                      const RigidContactOptions& options) {
    if (contact < 0 || contact >= static_cast<Index>(segments.contacts.size()))
        throw InvalidArgument(fmt::format("contact {} is out of range: the record has {} in all, counted from 0",
                                          contact, segments.contacts.size()));
    if (!(options.lowest_share >= 0.0 && options.lowest_share < 1.0))
        throw InvalidArgument(
            fmt::format("lowest_share of the force must lie in [0, 1), got {}", options.lowest_share));
    if (loop.displacement.size() == 0)
        throw UndefinedDataError("a machine stiffness needs the position of the stage, which was not measured");
    const ContactSegments& touch = segments.contacts[static_cast<std::size_t>(contact)];
    const double largest = loop.force[touch.loading.last] - segments.before.force,
                 least = options.lowest_share * largest;
    const Branch pressed = branch_above(loop, segments, touch.loading, least);
    const Line in = robust_line(pressed);
    const Estimate growth = slope_growth(pressed, in.slope);
    constexpr double sure = 3.0;
    if (growth.value > options.largest_nonlinearity && growth.value > sure * growth.standard_error)
        throw UndefinedDataError(
            fmt::format("the slope of force against stage grows by {:.0f} % from the lower to the upper half of the "
                        "forces, more than {:.0f} %: the contact is soft; measure the stiffness on a rigid body",
                        100.0 * growth.value, 100.0 * options.largest_nonlinearity));
    const auto estimate = [](double value, double error) {
        return Estimate{.value = value, .standard_error = error, .method = "robust line, correlated residuals"};
    };
    MachineStiffness result{.stiffness = estimate(in.slope, in.standard_error),
                            .loading = estimate(in.slope, in.standard_error),
                            .unloading = {undefined},
                            .hysteresis = undefined,
                            .nonlinearity = growth.value,
                            .n = pressed.force.size()};
    if (!touch.unloading) return result;
    const Branch released = branch_above(loop, segments, *touch.unloading, least);
    const Line out = robust_line(released);
    result.unloading = estimate(out.slope, out.standard_error);
    result.n += released.force.size();
    // branches have equal weights: their difference is not noise
    result.stiffness =
        estimate(0.5 * (in.slope + out.slope),
                 std::hypot(0.5 * std::hypot(in.standard_error, out.standard_error), 0.5 * (in.slope - out.slope)));
    const double deflection = in.stage_at(largest) - in.stage_at(least);
    const double at_least = std::abs(in.stage_at(least) - out.stage_at(least)),
                 at_largest = std::abs(in.stage_at(largest) - out.stage_at(largest));
    result.hysteresis = std::max(at_least, at_largest) / deflection;
    return result;
}

MachineStiffness machine_stiffness_from_rigid_contact(const Loop& loop) {
    try {
        return machine_stiffness_from_rigid_contact(loop, find_segments(loop));
    } catch (const UndefinedDataError&) {
        if (loop.force.size() < 20 || loop.displacement.size() == 0) throw;
    }
    return machine_stiffness_from_rigid_contact(loop, pressed_and_released(loop));
}

}  // namespace setae::loops
