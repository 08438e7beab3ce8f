// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "force_jumps.hpp"

namespace setae::loops {

/// First and last contact of a record.
struct ContactEdges {
    bool found = false;              ///< whether there is a section in which the force increases with the displacement
    double contact_slope = 0.0;      ///< dF/dδ near the turn minus that of free flight [N/m]
    Index turn = 0;                  ///< sample of the deepest position
    std::optional<ForceJump> entry;  ///< the jump into contact
    std::optional<ForceJump> exit;   ///< the jump out of contact
    std::optional<IndexRange> before;  ///< free flight up to contact
    std::optional<IndexRange> after;   ///< free flight after it
};

/// Finds contact by slopes and jumps of the force, which do not depend on an offset or a steady drift of its zero.
///
/// Lines are fitted to windows of samples wide enough that slopes exceed the noise. In contact the slope in time
/// exceeds that at the record's end by more than 15 % of the slope near the turn. Jumps into contact lead to less
/// force, jumps out of it to more; the side of free flight is flat. Free flight needs five samples. Without a jump into
/// contact, free flight ends one window before the slope does; after contact there is free flight only after a jump.
///
/// Needs displacement. Cost: n log n.
[[nodiscard]] ContactEdges find_contact_edges(const Loop& loop);

/// The same from contact radii: before the first, after the last one > 0. Nothing before and after where frames that
/// show no contact are missing.
[[nodiscard]] ContactEdges contact_edges_of_frames(const Loop& loop);

}  // namespace setae::loops
