// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_steps.hpp"

#include <algorithm>
#include <cmath>

#include "force_jumps.hpp"
#include "local_lines.hpp"

namespace setae::loops {
namespace {

/// Loading and unloading of a contact without the neighbourhood of their ends.
std::vector<IndexRange> inner_branches(const ContactSegments& contact, Index margin) {
    std::vector<IndexRange> branches;
    const auto add = [&](Index first, Index last) {
        if (last - margin > first + margin) branches.push_back({first + margin, last - margin});
    };
    add(contact.loading.first, contact.hold ? contact.hold->first : contact.loading.last);
    if (contact.unloading) add(contact.hold ? contact.hold->last : contact.unloading->first, contact.unloading->last);
    return branches;
}

void add_steps(const Array1D& clock, const Loop& level, const IndexRange& branch, double noise, double tension,
               std::vector<ForceStep>& steps) {
    constexpr double visible = 0.02, motion_share = 0.5;
    const Index width = std::clamp<Index>(branch.count() / 40, 4, 12);
    std::vector<ForceJump> jumps =
        force_jumps(clock, level.force, {.samples = branch, .noise = noise, .half_width = width});
    const Array1D slopes = local_slopes(clock, level.force, width).abs();
    std::erase_if(jumps, [&](const ForceJump& jump) {
        const Index beside = std::max<Index>(jump.last - 2 * width, 0), after = std::min(jump.next + 2 * width, level.force.size() - 1);
        const double motion = std::max(slopes[beside], slopes[after]) * (clock[jump.next] - clock[jump.last]) /
                              static_cast<double>(jump.next - jump.last);
        return std::abs(jump.size) < std::max(visible * tension, motion_share * static_cast<double>(width) * motion);
    });
    while (!jumps.empty()) {
        const ForceJump clearest = *std::max_element(jumps.begin(), jumps.end(), [](const ForceJump& one, const ForceJump& other) {
            return clarity(one) < clarity(other);
        });
        steps.push_back({.sample = clearest.last, .size = clearest.size});
        std::erase_if(jumps, [&](const ForceJump& jump) { return std::abs(jump.last - clearest.last) <= 4 * width; });
    }
}

}  // namespace

std::vector<ForceStep> steps_in_contact(const Loop& level, const Segments& segments) {
    const Index n = level.force.size();
    const Array1D clock = Array1D::LinSpaced(n, 0.0, static_cast<double>(n - 1));
    const double tension = std::max(-level.force.minCoeff(), 0.0);
    std::vector<ForceStep> steps;
    for (const ContactSegments& contact : segments.contacts) {
        const Index margin = std::max<Index>(6, contact.loading.count() / 20);
        for (const IndexRange& branch : inner_branches(contact, margin))
            add_steps(clock, level, branch, segments.before.force_noise, tension, steps);
    }
    return steps;
}

}  // namespace setae::loops
