// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_steps.hpp"

#include <algorithm>
#include <cmath>

#include "baseline.hpp"
#include "steps.hpp"

namespace setae::loops {
namespace {

/// Stretches of a contact in which the force is smooth, without the neighbourhood of their ends.
std::vector<IndexRange> inner_branches(const Segments& segments, const ContactSegments& contact,
                                       const std::vector<Index>& bends) {
    std::vector<IndexRange> branches;
    const auto add = [&](Index first, Index last) {
        const Index margin = std::max<Index>(6, (last - first) / 20);
        for (const Index bend : bends) {
            if (bend <= first || bend >= last) continue;
            if (bend - margin > first + margin) branches.push_back({first + margin, bend - margin});
            first = bend;
        }
        if (last - margin > first + margin) branches.push_back({first + margin, last - margin});
    };
    for (const Index k : contact.cycles) {
        const Cycle& cycle = segments.cycles[static_cast<std::size_t>(k)];
        const auto held = [&](Index sample) { return contact.hold && contact.hold->contains(sample); };
        add(cycle.loading.first, held(cycle.loading.last) ? contact.hold->first : cycle.loading.last);
        add(held(cycle.unloading.first) ? contact.hold->last : cycle.unloading.first, cycle.unloading.last);
    }
    if (contact.cycles.empty()) add(contact.loading.first, contact.hold ? contact.hold->first : contact.loading.last);
    return branches;
}

/// Windows of about a third of a branch that overlap by half: a cubic fits the force in each.
std::vector<IndexRange> windows_of(const IndexRange& branch) {
    constexpr Index fewest = 24, most = 120;
    const Index width = std::min(std::clamp(branch.count() / 3, fewest, most), branch.count());
    std::vector<IndexRange> windows;
    for (Index first = branch.first; first + width - 1 <= branch.last; first += std::max<Index>(width / 2, 1))
        windows.push_back({first, first + width - 1});
    if (!windows.empty() && windows.back().last < branch.last)
        windows.push_back({branch.last - width + 1, branch.last});
    return windows;
}

}  // namespace

std::vector<ForceStep> steps_in_contact(const Loop& level, const Segments& segments, const std::vector<Index>& bends) {
    constexpr double visible = 0.02;  // share of the largest tension
    const double least = visible * std::max(-level.force.minCoeff(), 0.0);
    std::vector<ForceStep> steps;
    for (const ContactSegments& contact : segments.contacts)
        for (const IndexRange& branch : inner_branches(segments, contact, bends))
            for (const IndexRange& window : windows_of(branch)) {
                const auto step = step_in(level.force.segment(window.first, window.count()),
                                          {.degree = 3, .rivalling = 6}, sample_noise(segments.before));
                if (!step || std::abs(step->size) < least) continue;
                const Index sample = window.first + step->last;
                // two windows may show one step
                if (!steps.empty() && std::abs(steps.back().sample - sample) < window.count() / 4) continue;
                steps.push_back({.sample = sample, .size = step->size});
            }
    return steps;
}

}  // namespace setae::loops
