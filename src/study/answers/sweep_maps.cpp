// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/sweep_maps.hpp"

#include <algorithm>

namespace setae::answers {

bool NotableStates::has(const char* name) const {
    return std::any_of(kept_.begin(), kept_.end(), [&](const SweepMaps& maps) { return maps.name == name; });
}

void NotableStates::keep(const char* name, const half_space::AdhesiveCell& cell) {
    std::erase_if(kept_, [&](const SweepMaps& maps) { return maps.name == name; });
    kept_.push_back({name, steps_, cell.pressures(), cell.gaps()});
}

void NotableStates::look(const half_space::LoopStep& step, const half_space::AdhesiveCell& cell) {
    const double tension = step.state.tension;
    if (step.approaching) {
        if (tension < 0.0 && !has("approach_zero_load")) keep("approach_zero_load", cell);
        keep("turn", cell);
    } else {
        if (tension > 0.0 && !has("separation_zero_load")) keep("separation_zero_load", cell);
        if (tension > greatest_tension_) {
            greatest_tension_ = tension;
            keep("greatest_tension", cell);
        }
    }
    ++steps_;
}

}  // namespace setae::answers
