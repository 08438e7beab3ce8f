// SPDX-License-Identifier: GPL-3.0-or-later
#include "cycle_analysis.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "attempt.hpp"

namespace setae::loops {
namespace {

void add_energy(CycleAnalysis& result, const PreparedRecord& record, Index index, const ContactAnalysis& contact,
                DriftModel drift) {
    const ContactSegments& segments = record.segments.contacts[static_cast<std::size_t>(result.cycle.contact)];
    result.energy_standard_error = undefined;
    const auto keep = [&](const Estimate& energy) {
        result.energy = energy.value;
        result.energy_standard_error = energy.standard_error;
    };
    if (record.deflected.displacement.size() == 0) {
        result.energy = Outcome<double>::missing("the displacement was not measured");
    } else if (segments.cycles.size() == 1) {
        if (contact.loop) keep(contact.loop->estimate());
        else result.energy = Outcome<double>::missing(contact.loop.reason);
    } else if (const auto energy = partial_loop_energy(record.deflected, record.segments, index, drift)) {
        keep(*energy);
    } else if (result.cycle.ends_in_pull_off && contact.loop) {
        // the last unloading closes the outer loop: the whole minus the partial loops
        Estimate outer = contact.loop->estimate();
        for (const Index other : segments.cycles)
            if (const auto inner = partial_loop_energy(record.deflected, record.segments, other, drift))
                outer.value -= inner->value;
        keep(outer);
    } else {
        result.energy = Outcome<double>::missing("no further loading follows this unloading and closes the loop");
    }
}

/// A branch between reversals, refused where its modulus shows that the contact edge did not move.
Outcome<BranchAnalysis> analyse_partial(const PreparedRecord& record, const ContactAnalysis& contact,
                                        const IndexRange& range, const std::string& name,
                                        const LensAndCounterBody& bodies, const AnalysisOptions& options) {
    Outcome<BranchAnalysis> branch = attempt([&] {
        return analyse_branch(record.levelled(), without_ignored(range_selection(range, name), record.segments), bodies,
                              options);
    });
    if (!branch) return branch;
    const double first = contact.loading.primary().contact_modulus.value;
    const double ratio = branch->primary().contact_modulus.value / first;
    const double limit = options.limits.pinned_modulus_ratio;
    if (ratio < limit && ratio > 1.0 / limit) return branch;
    return Outcome<BranchAnalysis>::missing(
        fmt::format("{}: E* would be {:.2g} times that of first loading: the contact edge is pinned, and JKR does "
                    "not describe this branch",
                    name, ratio));
}

}  // namespace

CycleAnalysis analyse_cycle(const PreparedRecord& record, Index index, const ContactAnalysis& contact,
                            const LensAndCounterBody& bodies, const AnalysisOptions& options) {
    CycleAnalysis result{.cycle = record.segments.cycles[static_cast<std::size_t>(index)]};
    add_energy(result, record, index, contact, options.segments.drift);
    const std::vector<Index>& cycles = record.segments.contacts[static_cast<std::size_t>(result.cycle.contact)].cycles;
    if (cycles.size() == 1) {
        result.loading = contact.loading;
        result.unloading = contact.unloading;
        return result;
    }
    const auto whole = [&](const IndexRange& range, const std::string& name) {
        return attempt([&] {
            return analyse_branch(record.levelled(), without_ignored(range_selection(range, name), record.segments),
                                  bodies, options);
        });
    };
    const auto partial = [&](const IndexRange& range, const std::string& name) {
        return analyse_partial(record, contact, range, name, bodies, options);
    };
    const std::string loading_name = fmt::format("loading of cycle {}", index + 1);
    const std::string unloading_name = fmt::format("unloading of cycle {}", index + 1);
    IndexRange loading = result.cycle.loading;
    if (cycles.front() == index) {
        loading.first = std::min(loading.first + options.samples_dropped, loading.last);
        result.loading = whole(loading, loading_name);
    } else {
        result.loading = partial(loading, loading_name);
    }
    result.unloading = cycles.back() == index ? whole(result.cycle.unloading, unloading_name)
                                              : partial(result.cycle.unloading, unloading_name);
    return result;
}

}  // namespace setae::loops
