// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/half_space/adhesive_loop.hpp"

namespace setae::answers {

/// A state of a sweep, point by point.
struct SweepMaps {
    std::string name;  ///< "approach_zero_load", "turn", "separation_zero_load" or "greatest_tension"
    Index step = 0;    ///< counted from 0
    Array2D pressures, gaps;
};

/// Stores selected states of a sweep while it runs: the first under pressure on approach, the last before it turns, the
/// first under tension on separation, and the one with the greatest tension there.
class NotableStates {
public:
    /// The sweep's next step, and the cell as it is then.
    void look(const half_space::LoopStep& step, const half_space::AdhesiveCell& cell);
    [[nodiscard]] std::vector<SweepMaps> take() { return std::move(kept_); }

private:
    void keep(const char* name, const half_space::AdhesiveCell& cell);
    [[nodiscard]] bool has(const char* name) const;

    std::vector<SweepMaps> kept_;
    Index steps_ = 0;
    double greatest_tension_ = 0.0;
};

}  // namespace setae::answers
