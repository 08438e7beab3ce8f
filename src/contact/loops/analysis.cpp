// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/analysis.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "alerts.hpp"
#include "attempt.hpp"
#include "bulk_relaxation.hpp"
#include "contact_analysis.hpp"
#include "cycle_analysis.hpp"
#include "records/baseline.hpp"
#include "records/contact_steps.hpp"
#include "records/force_zero.hpp"

namespace setae::loops {
namespace {

/// The loop with the deflection of the testing machine subtracted from the displacement.
Loop without_compliance(const Loop& loop, const std::optional<double>& machine_stiffness) {
    if (!machine_stiffness) return loop;
    if (!(*machine_stiffness > 0.0))
        throw InvalidArgument(fmt::format("machine stiffness must be > 0 N/m, got {}", *machine_stiffness));
    Loop corrected = loop;
    if (loop.displacement.size() == loop.force.size()) corrected.displacement -= loop.force / *machine_stiffness;
    return corrected;
}

void add_ranges(std::vector<IndexRange>& ranges, const std::vector<IndexRange>& further) {
    ranges.insert(ranges.end(), further.begin(), further.end());
}

Segments found_segments(const Loop& loop, const RecordFaults& faults, const SegmentOptions& options) {
    Segments segments = find_segments(loop, options);
    add_ranges(segments.ignored, faults.saturated_high);
    add_ranges(segments.ignored, faults.saturated_low);
    return segments;
}

Segments measured_anew(Segments segments, const Loop& loop) {
    const auto measure = [&](Baseline& baseline) {
        if (baseline.range) baseline = baseline_over(loop, *baseline.range);
    };
    measure(segments.before);
    if (!segments.after) return segments;
    measure(*segments.after);
    if (!segments.before.range) {
        segments.before = *segments.after;
        segments.before.range.reset();
    }
    return segments;
}

}  // namespace

PreparedRecord prepared(const Loop& recorded, const RecordFaults& faults, const AnalysisOptions& options,
                        const Segments* known) {
    PreparedRecord record;
    Loop loop = recorded;
    if (faults.time_backwards) loop.time = Array1D();  // samples count on in its stead
    record.deflected = without_displacement_drift(without_compliance(loop, options.machine_stiffness),
                                                  options.displacement_drift_rate);
    record.segments =
        known ? measured_anew(*known, record.deflected) : found_segments(record.deflected, faults, options.segments);
    record.zero = force_zero(record.deflected, record.segments, options.segments.drift);
    // the testing machine deflects under the force, not under the drift of its zero
    if (options.machine_stiffness && record.deflected.displacement.size() > 0)
        record.deflected.displacement += record.zero.value / *options.machine_stiffness;
    record.level = record.deflected;
    record.level.force -= record.zero.value;
    return record;
}

namespace {

/// Samples at which the edges start to move, in increasing order.
std::vector<Index> ends_of_pinning(const LoopAnalysis& analysis) {
    std::vector<Index> ends;
    const auto add = [&](const ContactAnalysis& contact) {
        if (contact.pinned) ends.push_back(contact.pinned->last);
    };
    add(analysis);
    for (const auto& further : analysis.further_contacts)
        if (further) add(*further);
    return ends;
}

LoopAnalysis analyse_elastic(const Loop& recorded, const LensAndCounterBody& bodies, const AnalysisOptions& options,
                             const std::string& subject) {
    const RecordFaults faults = record_faults(recorded);
    const PreparedRecord record = prepared(recorded, faults, options);
    const Segments& segments = record.segments;
    const auto n = static_cast<Index>(segments.contacts.size());
    LoopAnalysis analysis{analyse_contact(record, 0, bodies, options)};
    analysis.faults = faults;
    for (Index k = 1; k < n; ++k)
        analysis.further_contacts.push_back(attempt([&] { return analyse_contact(record, k, bodies, options); }));
    for (Index i = 0; i < static_cast<Index>(segments.cycles.size()); ++i) {
        const Index k = segments.cycles[static_cast<std::size_t>(i)].contact;
        const Outcome<ContactAnalysis>* further =
            k > 0 ? &analysis.further_contacts[static_cast<std::size_t>(k) - 1] : nullptr;
        const ContactAnalysis& contact = further != nullptr && *further ? **further : analysis;
        analysis.cycles.push_back(analyse_cycle(record, i, contact, bodies, options));
    }
    analysis.segments = segments;
    analysis.corrected = record.level;
    analysis.force_zero = record.zero;
    analysis.steps_in_contact = steps_in_contact(record.level, segments, ends_of_pinning(analysis));
    analysis.alerts = alerts_of(analysis, record.level, bodies, options.limits, subject);
    return analysis;
}

}  // namespace

LoopAnalysis analyse(const Loop& recorded, const LensAndCounterBody& bodies, const AnalysisOptions& options,
                     const std::string& subject) {
    auto analysis = analyse_elastic(recorded, bodies, options, subject);
    if (options.relaxation.empty()) return analysis;
    constexpr int rounds = 4;  // E* of loading and the contact point, on which F₁ rests, settle to 10⁻³
    std::optional<BulkRelaxation> relaxation;
    for (int round = 0; round < rounds; ++round) {
        const auto bulk = bulk_force(analysis, bodies, options.relaxation);
        Loop elastic = recorded;
        elastic.force.segment(bulk.first, bulk.force.size()) -= bulk.force;
        analysis = analyse_elastic(elastic, bodies, options, subject);
        relaxation = bulk.relaxation;
    }
    analysis.bulk = relaxation;
    if (auto& loop = analysis.loop.value) {
        loop->energy += relaxation->energy_loss;
        loop->without_drift += relaxation->energy_loss;
    }
    return analysis;
}

}  // namespace setae::loops
