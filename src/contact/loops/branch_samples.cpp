// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_analysis.hpp"
#include "setae/core/errors.hpp"

namespace setae::loops {
namespace {

Selection selection_of(const LoopAnalysis& analysis, LoopBranch branch, const AnalysisOptions& options) {
    const Segments& segments = analysis.segments;
    if (branch == LoopBranch::loading)
        return without_ignored(
            loading_selection(analysis.corrected, segments, segments.contacts.front(), options.samples_dropped),
            segments);
    if (!analysis.unloading) throw UndefinedDataError(analysis.unloading.reason);
    const FitRange& range = analysis.unloading->range;
    return without_ignored(range_selection({.first = range.first, .last = range.last}, range.name), segments);
}

}  // namespace

BranchSamples branch_samples(const LoopAnalysis& analysis, LoopBranch branch, const AnalysisOptions& options) {
    const Loop& loop = analysis.corrected;
    const Selection selection = selection_of(analysis, branch, options);
    BranchSamples result{
        .data = branch_data({loop, analysis.segments.before, analysis.force_zero.modes}, selection, options)};
    if (loop.time.size() == 0) return result;
    result.time.resize(result.data.force.size());
    Index n = 0;
    for (const Index i : selection.samples)
        if (loop.contact_radius.size() == 0 || loop.contact_radius[i] > 0.0) result.time[n++] = loop.time[i];
    return result;
}

RetractingEdge retracting_edge(const LoopAnalysis& analysis, const AnalysisOptions& options) {
    const Loop& loop = analysis.corrected;
    if (!analysis.unloading) throw UndefinedDataError(analysis.unloading.reason);
    // with the pinned section: an edge at rest bounds G0
    const IndexRange range{.first = analysis.segments.contacts.front().unloading->first,
                           .last = analysis.unloading->range.last};
    const Selection selection = without_ignored(range_selection(range, "unloading"), analysis.segments);
    if (loop.time.size() == 0) throw UndefinedDataError("the record has no time");
    if (loop.contact_radius.size() == 0)
        throw UndefinedDataError(
            "the contact radius was not measured; the radius computed from force and displacement gives no "
            "independent speed");
    const BranchSamples frames = branch_samples(analysis, LoopBranch::unloading, options);
    return {.time = loop.time(selection.samples),
            .force = loop.force(selection.samples),
            .contact_radius = loop.contact_radius(selection.samples),
            .contact_radius_noise = frames.data.contact_radius_noise};
}

}  // namespace setae::loops
