// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/loops/force_curve_fit.hpp"

namespace setae::loops {
namespace {

constexpr Index min_samples = 20;

/// The words of "extend, pause, retract".
std::vector<std::string> words(const std::string& list) {
    std::vector<std::string> result;
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        result.emplace_back(trimmed(std::string_view(list).substr(begin, end - begin)));
        begin = end + 1;
    }
    return result;
}

std::vector<IndexRange> ranges_of(const Table& curve) {
    const Array1D& force = curve.at("force");
    const Index n = force.size();
    std::vector<IndexRange> ranges;
    if (const Column* segment = curve.find("segment")) {
        for (Index first = 0, i = 1; i <= n; ++i)
            if (i == n || segment->values[i] != segment->values[first]) {
                ranges.push_back({first, i - 1});
                first = i;
            }
        return ranges;
    }
    Index peak = 0;
    force.maxCoeff(&peak);
    ranges.push_back({0, peak});
    if (peak + 1 < n) ranges.push_back({peak + 1, n - 1});
    return ranges;
}

/// Line through the free end of a segment, and its noise.
CurveBaseline baseline_of(const CurveSegment& segment, bool approach, const ForceCurveFitOptions& options) {
    const Index n = segment.force.size();
    const Index count = std::clamp<Index>(std::lround(options.baseline_share * static_cast<double>(n)), 5, n);
    const Index first = approach ? 0 : n - count;
    const Array1D force = segment.force.segment(first, count),
                  displacement = segment.displacement.segment(first, count);
    CurveBaseline line{.range = {segment.range.first + first, segment.range.first + first + count - 1},
                       .force = force.mean()};
    const Array1D along = displacement - displacement.mean();
    if (options.subtract_baseline_slope && along.square().sum() > 0.0)
        line.slope = (along * force).sum() / along.square().sum();
    const Array1D rest = force - line.force - line.slope * along;
    line.force_noise =
        std::sqrt(rest.square().sum() / static_cast<double>(count - (options.subtract_baseline_slope ? 2 : 1)));
    return line;
}

}  // namespace

std::vector<CurveSegment> segments_of_curve(const Table& curve, const ForceCurveFitOptions& options) {
    if (!(options.baseline_share > 0.0 && options.baseline_share < 1.0))
        throw InvalidArgument(fmt::format("baseline share must lie in (0, 1), got {}", options.baseline_share));
    const Array1D &force = curve.at("force"), &displacement = curve.at("displacement");
    if (force.size() < min_samples)
        throw UndefinedDataError(
            fmt::format("a force curve of {} samples; at least {} are needed", force.size(), min_samples));
    if (!force.allFinite() || !displacement.allFinite())
        throw InvalidArgument(
            "force and displacement of a force curve must be defined throughout; leave out samples without "
            "them");
    const auto named = curve.metadata.find("segments");
    const std::vector<std::string> names =
        named == curve.metadata.end() ? std::vector<std::string>{} : words(named->second);
    const double travel = displacement.maxCoeff() - displacement.minCoeff();
    std::vector<CurveSegment> segments;
    for (const IndexRange& range : ranges_of(curve)) {
        CurveSegment segment{.range = range,
                             .displacement = displacement.segment(range.first, range.count()),
                             .force = force.segment(range.first, range.count())};
        const Index n = range.count();
        const double way = segment.displacement[n - 1] - segment.displacement[0];
        const bool pause = n < min_samples || std::abs(way)<0.05 * travel, approach = way> 0.0;
        const std::size_t number = segments.size();
        segment.name = pause                                             ? "pause"
                       : number < names.size() && !names[number].empty() ? names[number]
                       : approach                                        ? "approach"
                                                                         : "retract";
        if (pause) {
            segments.push_back(std::move(segment));
            continue;
        }
        const double rounding = 1e-12 * segment.force.abs().maxCoeff();
        segment.baseline = baseline_of(segment, approach, options);
        const Index middle = segment.baseline.range.first - range.first;
        const double zero = segment.displacement.segment(middle, segment.baseline.range.count()).mean();
        segment.force -= segment.baseline.force + segment.baseline.slope * (segment.displacement - zero);
        // from the turning point outwards, the first sample that does not exceed the noise
        const double level =
            std::max({3.0 * segment.baseline.force_noise, 1e-6 * segment.force.abs().maxCoeff(), rounding});
        Index at = approach ? n - 1 : 0;
        while (at >= 0 && at < n && segment.force[at] > level) at += approach ? -1 : 1;
        const bool touches = segment.force.maxCoeff() > 2.0 * level;
        segment.contact_point = touches ? segment.displacement[std::clamp<Index>(at, 0, n - 1)] : undefined;
        const double least = segment.force.minCoeff();
        if (least < -2.0 * level) segment.smallest_force = least;
        segments.push_back(std::move(segment));
    }
    return segments;
}

}  // namespace setae::loops
