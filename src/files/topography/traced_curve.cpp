// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/traced_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "backward_runs.hpp"
#include "envelope_profile.hpp"
#include "mean_line.hpp"
#include "oriented_curve.hpp"
#include "setae/core/errors.hpp"

namespace setae::topography {
namespace {

/// Steps back within this many standard errors of the difference of two points are noise of the trace.
constexpr double noise_multiple = 4.0;

/// Steps back along x that are explained by noise of the trace.
class NoiseDepth {
public:
    explicit NoiseDepth(const OrientedCurve& curve)
        : error_(curve.standard_error), rounding_(1e-9 * (curve.x.maxCoeff() - curve.x.minCoeff())) {}

    /// Between points first … last [m].
    [[nodiscard]] double operator()(Index first, Index last) const {
        const double error = error_.size() > 0 ? error_.segment(first, last - first + 1).maxCoeff() : 0.0;
        return std::max(noise_multiple * std::numbers::sqrt2 * error, rounding_);
    }

private:
    const Array1D& error_;
    double rounding_;
};

struct Cut {
    OrientedCurve curve;
    std::vector<ReentrantStretch> stretches;
};

/// The curve without the points of parts that turn back: those within noise, and with `all` also the deeper ones, which
/// are listed.
Cut without_backward_runs(const OrientedCurve& curve, bool all) {
    Cut cut;
    const NoiseDepth noise_depth(curve);
    std::vector<Index> kept;
    Index next = 0;
    const auto keep_until = [&](Index end) {
        for (; next < end; ++next) kept.push_back(next);
    };
    for (const auto& run : backward_runs(curve.x)) {
        const bool deep = run.depth > noise_depth(run.first - 1, run.last);
        if (deep && !all) continue;
        if (deep) cut.stretches.push_back({curve.along[run.first - 1], curve.along[run.last], run.depth});
        keep_until(run.first);
        next = run.last + 1;
    }
    keep_until(curve.x.size());
    cut.curve = curve.points(kept);
    return cut;
}

/// Distance along x that the curve turns back between two lengths along it [m].
double turning_back(const OrientedCurve& curve, double begin, double end) {
    const auto first = std::upper_bound(curve.along.begin(), curve.along.end(), begin);
    double front = curve.x_at(begin), depth = 0.0;
    const auto pass = [&](double x) {
        front = std::max(front, x);
        depth = std::max(depth, front - x);
    };
    for (auto i = static_cast<Index>(first - curve.along.begin()); i < curve.along.size() && curve.along[i] < end; ++i)
        pass(curve.x[i]);
    pass(curve.x_at(end));
    return depth;
}

/// Parts between the visible ones that turn back by more than noise.
std::vector<ReentrantStretch> hidden_stretches(const OrientedCurve& curve, std::vector<LengthRange> seen) {
    std::sort(seen.begin(), seen.end(), [](const auto& a, const auto& b) { return a.begin < b.begin; });
    std::vector<ReentrantStretch> hidden;
    const NoiseDepth noise_depth(curve);
    double reached = curve.along[0];
    seen.push_back({curve.along[curve.along.size() - 1], curve.along[curve.along.size() - 1]});
    const auto index_after = [&](double length) {
        return static_cast<Index>(std::upper_bound(curve.along.begin(), curve.along.end(), length) -
                                  curve.along.begin());
    };
    for (const auto& range : seen) {
        if (range.begin > reached) {
            const double depth = turning_back(curve, reached, range.begin);
            const Index first = index_after(reached) - 1,
                        last = std::min(index_after(range.begin), curve.along.size() - 1);
            if (depth > noise_depth(first, last)) hidden.push_back({reached, range.begin, depth});
        }
        reached = std::max(reached, range.end);
    }
    return hidden;
}

TraceResponse along_x(TraceResponse response, double stretch) {
    response.blur /= stretch;
    response.smoothing_length /= stretch;
    response.step /= stretch;
    response.noise_density *= stretch;
    return response;
}

Alert reentrant_alert(const LevelledCurve& result, Reentrance reentrance) {
    double deepest = 0.0;
    for (const auto& stretch : result.reentrant) deepest = std::max(deepest, stretch.depth);
    return {
        "REENTRANT", label(result.profile.metadata),
        fmt::format("{} re-entrant stretches, {:.2g} % of the length of the curve, turn back by up to {:.3g} m; {}",
                    result.reentrant.size(), 100.0 * result.reentrant_share, deepest,
                    reentrance == Reentrance::envelope ? "the highest point at each x was used" : "they were removed"),
        "look at the curve; if the share exceeds a few per cent, slope and curvature are lower bounds"};
}

double total(const std::vector<ReentrantStretch>& stretches) {
    double length = 0.0;
    for (const auto& stretch : stretches) length += stretch.end - stretch.begin;
    return length;
}

}  // namespace

LevelledCurve levelled(const TracedCurve& traced, Reentrance reentrance) {
    auto oriented = oriented_curve(traced);
    const auto& curve = oriented.curve;
    const double length = curve.along[curve.along.size() - 1];
    LevelledCurve result;
    result.rotation = oriented.rotation;
    if (traced.closed) result.alerts.push_back(closed_outline_alert(traced, length));

    auto cut = without_backward_runs(curve, reentrance == Reentrance::cut);
    Visible visible;
    if (reentrance == Reentrance::cut) {
        visible.profile = {cut.curve.x, cut.curve.y, {}, cut.curve.height_error()};
        visible.length = lengths_along(cut.curve.x, cut.curve.y).tail(1)[0];
        result.reentrant = std::move(cut.stretches);
    } else {
        visible = visible_profile(cut.curve);
        result.reentrant = hidden_stretches(curve, visible.seen);
    }
    auto& profile = visible.profile;
    if (profile.positions.size() < 2)
        throw UndefinedDataError(
            fmt::format("{}: {} of {} points of the traced curve lie at increasing x, expected at least 2",
                        label(traced.metadata), profile.positions.size(), traced.x.size()));
    result.reentrant_share = std::min(1.0, total(result.reentrant) / length);
    profile.positions -= Array1D::Constant(profile.positions.size(), profile.positions[0]);
    profile.metadata = traced.metadata;
    profile.metadata.attributes["rotation"] = fmt::format("{} rad", result.rotation);
    profile.metadata.attributes["reentrant_share"] = fmt::format("{}", result.reentrant_share);
    if (traced.response) {
        profile.response = along_x(*traced.response, visible.length / profile.size());
        profile.response->jumps = !result.reentrant.empty();
    }
    result.profile = std::move(profile);
    if (!result.reentrant.empty()) result.alerts.push_back(reentrant_alert(result, reentrance));
    return result;
}

}  // namespace setae::topography
