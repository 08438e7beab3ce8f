// SPDX-License-Identifier: GPL-3.0-or-later
#include "loop_residuals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "setae/hysteresis/loop_course.hpp"

namespace setae::study {
namespace {

/// Force of one branch against displacement: 0 below it, where there is no contact, that of the turning point above.
class BranchCurve {
public:
    /// The states of a branch of decreasing displacement; states beyond the smallest displacement are left out.
    explicit BranchCurve(std::vector<std::pair<double, double>> falling) {
        for (const auto& [displacement, force] : falling) {
            if (!points_.empty() && !(displacement < points_.back().first)) continue;
            points_.emplace_back(displacement, force);
        }
        std::ranges::reverse(points_);
    }

    [[nodiscard]] double at(double displacement) const {
        const auto upper = std::ranges::upper_bound(points_, displacement, {}, &std::pair<double, double>::first);
        if (upper == points_.begin()) return 0.0;
        if (upper == points_.end()) return points_.back().second;
        const auto lower = std::prev(upper);
        const double share = (displacement - lower->first) / (upper->first - lower->first);
        return lower->second + share * (upper->second - lower->second);
    }

private:
    std::vector<std::pair<double, double>> points_;
};

/// Both branches of a predicted loop.
struct PredictedBranches {
    BranchCurve approach, retraction;
};

PredictedBranches branches_of(const hysteresis::PredictedRetraction& loop) {
    constexpr int points = 400;
    const auto course = hysteresis::loop_course(loop.sphere, loop.pressing, loop.edge, points);
    const auto &displacement = course.at("displacement"), &force = course.at("force"), &branch = course.at("branch"),
               &radius = course.at("contact_radius");
    std::vector<std::pair<double, double>> approach, retraction;
    for (Index i = 0; i < displacement.size(); ++i)
        if (radius[i] > 0.0) (branch[i] == 0.0 ? approach : retraction).emplace_back(displacement[i], force[i]);
    if (!approach.empty()) retraction.insert(retraction.begin(), approach.back());  // the edge stays from the turn on
    std::ranges::reverse(approach);
    return {BranchCurve(std::move(approach)), BranchCurve(std::move(retraction))};
}

/// The most precise estimate from loading: that by `pull_off` depends on the separation, which is predicted here.
double contact_point_of_loading(const loops::ContactPoints& points) {
    using Method = loops::ContactPointMethod;
    Estimate surest{.value = points.contact_point.value, .standard_error = std::numeric_limits<double>::infinity()};
    for (const auto method : {Method::jump_in, Method::force_displacement, Method::pointwise}) {
        const auto& estimate = points.of(method).contact_point;
        if (estimate && estimate->standard_error < surest.standard_error) surest = *estimate;
    }
    return surest.value;
}

struct SquaredResiduals {
    double sum = 0.0;
    int count = 0;

    void add(const loops::LoopAnalysis& analysis, const loops::IndexRange& samples, const BranchCurve& predicted,
             double contact_point) {
        for (Index i = samples.first; i <= samples.last; ++i) {
            const double off =
                analysis.corrected.force[i] - predicted.at(analysis.corrected.displacement[i] - contact_point);
            sum += off * off;
            ++count;
        }
    }
    [[nodiscard]] double rms() const { return std::sqrt(sum / count); }
};

}  // namespace

std::optional<LoopResiduals> loop_residuals(const StudyResult& result, const PairHysteresis& pair) {
    if (!pair.loop) return std::nullopt;
    std::optional<PredictedBranches> predicted;
    SquaredResiduals approach, retraction;
    LoopResiduals residuals;
    for (const auto& e : result.experiments) {
        if (!e.analysis || e.input.reference || e.input.excluded() || e.input.surface != pair.surface ||
            e.input.elastomer != pair.elastomer)
            continue;
        const auto& analysis = *e.analysis;
        const auto& contact = analysis.segments.contacts.front();
        if (analysis.corrected.displacement.size() == 0 || !contact.unloading || !analysis.contact_points) continue;
        if (!predicted) predicted = branches_of(*pair.loop);
        const double contact_point = contact_point_of_loading(*analysis.contact_points);
        approach.add(analysis, contact.loading, predicted->approach, contact_point);
        retraction.add(analysis, *contact.unloading, predicted->retraction, contact_point);
        residuals.largest_force = std::max(residuals.largest_force, analysis.corrected.force.maxCoeff());
        ++residuals.loops;
    }
    if (residuals.loops == 0 || approach.count == 0 || retraction.count == 0) return std::nullopt;
    residuals.approach = approach.rms();
    residuals.retraction = retraction.rms();
    return residuals;
}

}  // namespace setae::study
