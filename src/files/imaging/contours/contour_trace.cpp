// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/imaging/contour_trace.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "edge_refine.hpp"
#include "live_wire.hpp"
#include "mask_outline.hpp"
#include "prepared_picture.hpp"
#include "setae/core/errors.hpp"
#include "two_phases.hpp"

namespace setae::imaging {
namespace {

constexpr long smallest_picture = 32;    // px a side
constexpr double min_area = 400.0;       // px² of a relevant island
constexpr double default_length = 50.0;  // px
constexpr double min_gain = 0.05;  // of ln likelihood per square of the coarse division, for two phases instead of one
constexpr double faint = 1.0;      // contrast over noise
constexpr double start_smoothing = 2.0;  // px: outlines of pixels are staircases
constexpr double min_detour = 30.0;      // px on either side of a single anchor that are traced again

void validate(const FramePixels& pixels, const TraceOptions& options) {
    if (pixels.rows() < smallest_picture || pixels.cols() < smallest_picture)
        throw InvalidArgument(fmt::format("a picture of {} × {} pixels; an edge needs at least {} × {}", pixels.cols(),
                                          pixels.rows(), smallest_picture, smallest_picture));
    if (options.smoothing_length && !(*options.smoothing_length >= 0 && *options.smoothing_length <= 100))
        throw InvalidArgument(fmt::format("smoothing length {} px, expected 0 … 100", *options.smoothing_length));
    if (!(options.denoise >= 0 && options.denoise <= 20))
        throw InvalidArgument(fmt::format("denoise {} px, expected 0 … 20", options.denoise));
    if (options.min_length && !(*options.min_length >= 0))
        throw InvalidArgument(
            fmt::format("the smallest length of an edge is {} px, expected 0 or more", *options.min_length));
    for (std::size_t s = 0; s < options.anchors.size(); ++s)
        for (std::size_t i = 0; i < options.anchors[s].size(); ++i) {
            const auto& a = options.anchors[s][i];
            if (!(a.x >= -0.5 && a.y >= -0.5 && a.x <= static_cast<double>(pixels.cols()) - 0.5 &&
                  a.y <= static_cast<double>(pixels.rows()) - 0.5))
                throw InvalidArgument(fmt::format(
                    "anchor {} of segment {} at ({}, {}) lies outside the picture of {} × {} pixels; the centre of "
                    "the first pixel is (0, 0)",
                    i + 1, s + 1, a.x, a.y, pixels.cols(), pixels.rows()));
        }
}

ContourSegment exact_segment(const PlaneCurve& outline) {
    ContourSegment segment{outline.x,      outline.y,        Array1D::Constant(outline.size(), std::sqrt(1.0 / 12.0)),
                           outline.closed, outline.length(), {}};
    segment.contrast_to_noise = std::numeric_limits<double>::infinity();
    return segment;
}

double distance_to(const PlaneCurve& curve, const Anchor& anchor, Index& nearest) {
    return std::sqrt(((curve.x - anchor.x).square() + (curve.y - anchor.y).square()).minCoeff(&nearest));
}

/// Unsmoothed outlines of a mask; with anchors the nearest to the first of each list.
std::vector<ContourSegment> binary_segments(const PixelMask& sample, const TraceOptions& options) {
    std::vector<ContourSegment> segments;
    const auto found = outlines(sample);
    for (const auto& list : options.anchors) {
        if (list.empty()) continue;
        const PlaneCurve* best = nullptr;
        double least = std::numeric_limits<double>::infinity();
        for (const auto& outline : found) {
            Index at = 0;
            if (const double d = distance_to(resampled(outline, 1.0, false), list.front(), at); d < least) {
                least = d;
                best = &outline;
            }
        }
        if (best != nullptr) segments.push_back(exact_segment(*best));
    }
    if (!options.anchors.empty()) return segments;
    for (const auto& outline : found)
        if (outline.length() >= options.min_length.value_or(0.0)) segments.push_back(exact_segment(outline));
    return segments;
}

/// Removes points outside the picture: at its sides the ends of the curve are unreliable.
void keep_within(PlaneCurve& curve, Array1D& standard_error, long columns, long rows) {
    if (curve.closed) return;
    const auto inside = [&](Index i) {
        return curve.x[i] >= -0.5 && curve.y[i] >= -0.5 && curve.x[i] <= static_cast<double>(columns) - 0.5 &&
               curve.y[i] <= static_cast<double>(rows) - 0.5;
    };
    Index first = 0, last = curve.size() - 1;
    while (first < last && !inside(first)) ++first;
    while (last > first && !inside(last)) --last;
    const Index n = last - first + 1;
    curve.x = Array1D(curve.x.segment(first, n));
    curve.y = Array1D(curve.y.segment(first, n));
    standard_error = Array1D(standard_error.segment(first, n));
}

ContourSegment refined_segment(EdgeBand& band, const PlaneCurve& start, const std::vector<Anchor>& anchors,
                               const TraceOptions& options, const FramePixels& pixels) {
    auto edge = refined_edge(band, start, anchors, options.smoothing_length);
    keep_within(edge.curve, edge.standard_error, pixels.cols(), pixels.rows());
    ContourSegment segment{edge.curve.x, edge.curve.y, edge.standard_error, edge.curve.closed, edge.curve.length(), {}};
    segment.edge_width = edge.blur;
    segment.smoothing_length = edge.smoothing_length;
    segment.noise_density = edge.noise_density;
    segment.contrast_to_noise = edge.contrast_to_noise;
    segment.fringe = edge.shape.fringe != 0;
    segment.converged = edge.converged;
    for (const auto& anchor : anchors) {
        Index nearest = 0;
        distance_to(edge.curve, anchor, nearest);
        segment.anchors.push_back(static_cast<std::size_t>(nearest));
    }
    return segment;
}

PlaneCurve stretch(const PlaneCurve& curve, Index first, Index last) {
    const Index n = last - first + 1;
    return {curve.x.segment(first, n), curve.y.segment(first, n), false};
}

PlaneCurve joined(const std::vector<PlaneCurve>& parts) {
    PlaneCurve whole;
    Index n = 0;
    for (const auto& part : parts) n += part.size();
    whole.x.resize(n);
    whole.y.resize(n);
    Index at = 0;
    for (const auto& part : parts) {
        whole.x.segment(at, part.size()) = part.x, whole.y.segment(at, part.size()) = part.y;
        at += part.size();
    }
    return whole;
}

/// The nearest curve, moved through one anchor: a part on either side of it is traced again.
PlaneCurve moved_through(const std::vector<PlaneCurve>& curves, const Anchor& anchor, const LiveWire& wire) {
    const PlaneCurve* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    Index nearest = 0;
    for (const auto& curve : curves) {
        Index at = 0;
        if (const double d = distance_to(curve, anchor, at); d < least) {
            least = d;
            best = &curve;
            nearest = at;
        }
    }
    if (best == nullptr)
        throw UndefinedDataError(
            "a segment has one anchor, and no edge is found without anchors; give the segment at least two "
            "anchors, including its ends");
    const auto detour = static_cast<Index>(std::max(min_detour, 2 * least));
    auto curve = *best;
    if (curve.closed) {  // opened opposite to the anchor
        const Index n = curve.size(), shift = (nearest + n / 2) % n;
        Array1D x(n), y(n);
        for (Index i = 0; i < n; ++i) {
            x[i] = best->x[(i + shift) % n];
            y[i] = best->y[(i + shift) % n];
        }
        curve = {x, y, false};
        nearest = (nearest - shift + n) % n;
    }
    const Index before = std::max<Index>(0, nearest - detour), after = std::min(curve.size() - 1, nearest + detour);
    const auto detoured = wire.through({{curve.x[before], curve.y[before]}, anchor, {curve.x[after], curve.y[after]}});
    std::vector<PlaneCurve> parts;
    if (before > 0) parts.push_back(stretch(curve, 0, before - 1));
    parts.push_back(detoured);
    if (after + 1 < curve.size()) parts.push_back(stretch(curve, after + 1, curve.size() - 1));
    return joined(parts);
}

/// Curves from the division into phases, with smoothed staircases.
std::vector<PlaneCurve> found_curves(const TwoPhases& phases, const TraceOptions& options) {
    std::vector<PlaneCurve> curves;
    for (const auto& outline : outlines(phases.sample))
        if (outline.length() >= options.min_length.value_or(default_length))
            curves.push_back(smoothed(resampled(outline, 1.0, false), start_smoothing));
    return curves;
}

void add_alerts(ContourTrace& trace, const TwoPhases& phases, bool helped) {
    if (phases.vacuum_assumed)
        trace.alerts.push_back(
            {"VACUUM_ASSUMED", "picture",
             fmt::format("neither phase has more structure than the other; the {} one was taken as vacuum, as in a "
                         "bright-field image",
                         trace.vacuum == Vacuum::bright ? "brighter" : "darker"),
             "set `vacuum` to bright or dark if this is wrong"});
    if (!helped && trace.segments.size() > 1)
        trace.alerts.push_back(
            {"TWO_EDGES", "picture",
             fmt::format("{} edges; the two longest have {:.0f} and {:.0f} px; segments are sorted by length",
                         trace.segments.size(), trace.segments[0].length, trace.segments[1].length),
             "choose one edge by its number in `segment`, or by anchors"});
    for (std::size_t i = 0; i < trace.segments.size(); ++i) {
        const auto& segment = trace.segments[i];
        const auto subject = fmt::format("segment {}", i + 1);
        if (segment.contrast_to_noise < faint)
            trace.alerts.push_back(
                {"LOW_CONTRAST", subject,
                 fmt::format(
                     "the contrast of the edge is {:.2g} times the noise of a pixel; positions of the edge scatter "
                     "by {:.2g} px",
                     segment.contrast_to_noise, segment.standard_error.mean()),
                 "look at the overlay; add anchors where the trace leaves the visible edge"});
        if (!segment.converged)
            trace.alerts.push_back({"NOT_CONVERGED", subject,
                                    "more than 5 % of the trace still moved by more than 0.02 px in the last round",
                                    "look at the overlay; add anchors or give a smoothing length"});
    }
}

}  // namespace

ContourTrace trace_contour(const FramePixels& pixels, const TraceOptions& options) {
    validate(pixels, options);
    const auto picture = prepared_picture(pixels, options);
    ContourTrace trace;
    trace.alerts = picture.alerts;
    if (picture.grey_levels == 1)
        throw UndefinedDataError(
            fmt::format("all pixels of the picture have the grey level {}, so that there is no edge",
                        static_cast<double>(picture.pixels(0, 0))));
    trace.binary = picture.grey_levels == 2;
    if (trace.binary) {
        const auto mask = divide_binary(picture.pixels, picture.hidden, options.vacuum);
        trace.vacuum_level = mask.vacuum_level;
        trace.sample_level = mask.sample_level;
        trace.vacuum = mask.vacuum;
        trace.segments = binary_segments(mask.sample, options);
        add_alerts(trace, mask, !options.anchors.empty());
        if (trace.segments.empty())
            throw UndefinedDataError("no outline of the mask has the least length that was given");
        return trace;
    }
    auto phases = divide(picture.pixels, picture.hidden, options.vacuum);
    const bool helped =
        std::any_of(options.anchors.begin(), options.anchors.end(), [](const auto& list) { return !list.empty(); });
    const bool divided = phases.sample.size() > 0 && phases.gain > min_gain * phases.cells;
    if (!divided && !helped)
        throw UndefinedDataError(fmt::format(
            "no edge is found: two phases explain the picture no better than one (ln likelihood {:+.3g} per "
            "square, expected at least {:.2g}); give anchors along the visible edge",
            phases.cells > 0 ? phases.gain / phases.cells : 0.0, min_gain));
    trace.vacuum = divided ? phases.vacuum : options.vacuum == Vacuum::dark ? Vacuum::dark : Vacuum::bright;
    trace.vacuum_level = phases.vacuum_level;
    trace.sample_level = phases.sample_level;
    trace.vacuum_noise = phases.vacuum_noise;
    trace.sample_noise = phases.sample_noise;
    std::vector<PlaneCurve> curves;
    if (divided) {
        remove_islands(phases.sample, min_area);
        curves = found_curves(phases, options);
    }
    EdgeBand band(picture.pixels, picture.hidden);
    if (helped) {
        const LiveWire wire(picture.pixels, trace.vacuum);
        for (const auto& list : options.anchors)
            if (!list.empty()) {
                const auto path = list.size() == 1 ? moved_through(curves, list.front(), wire) : wire.through(list);
                trace.segments.push_back(
                    refined_segment(band, smoothed(path, start_smoothing), list, options, picture.pixels));
            }
    } else {
        for (const auto& curve : curves)
            trace.segments.push_back(refined_segment(band, curve, {}, options, picture.pixels));
        std::stable_sort(trace.segments.begin(), trace.segments.end(),
                         [](const auto& a, const auto& b) { return a.length > b.length; });
    }
    std::erase_if(trace.segments, [](const auto& segment) { return !segment.standard_error.isFinite().all(); });
    if (trace.segments.empty() && (helped || !curves.empty()))
        throw UndefinedDataError(
            "the edge was lost: along it, no slope of grey levels exceeds the noise; give anchors closer to "
            "the edge");
    if (trace.segments.empty())
        throw UndefinedDataError(
            fmt::format("no edge has the least length of {} px", options.min_length.value_or(default_length)));
    add_alerts(trace, phases, helped);
    return trace;
}

}  // namespace setae::imaging
