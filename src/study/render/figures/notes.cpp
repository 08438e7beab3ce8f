// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/figures/notes.hpp"

#include <algorithm>

#include "layout.hpp"
#include "ticks.hpp"

namespace setae::figures {

void extend_for_notes(Figure& figure, std::size_t panel) {
    constexpr double gap_mm = 1.0, max_share = 0.8;
    const auto axes = layout_of(figure, panel).axes;
    const double length_mm = axes.right - axes.left;
    auto& axis = figure.panels[panel].x;
    const double from = axis.from.value(), given = axis.to.value();
    double to = given;
    for (const auto& note : figure.panels[panel].notes) {
        if (note.side != Note::Side::right) continue;
        const double width_mm = letters_mm * static_cast<double>(letters_in(note.text)) + gap_mm;
        to = std::max(to, from + (note.x - from) / (1.0 - std::min(width_mm / length_mm, max_share)));
    }
    axis.to = to;
}

}  // namespace setae::figures
