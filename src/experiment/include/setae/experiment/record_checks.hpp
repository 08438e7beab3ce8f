// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "setae/experiment/index_range.hpp"
#include "setae/experiment/loop.hpp"

namespace setae::experiment {

/// What is wrong with a record that can still be analysed.
struct RecordFaults {
    std::vector<IndexRange> saturated_high;  ///< samples at the largest force that do not even carry noise
    std::vector<IndexRange> saturated_low;   ///< at the smallest
    Index frames = 0;                        ///< samples in contact that have or should have a contact radius
    Index frames_missing = 0;                ///< of those, how many have none that their neighbours' rate lets expect
    std::optional<IndexRange> longest_gap;   ///< the most samples in a row without a frame

    [[nodiscard]] bool saturated(Index sample) const;
};

/// Flat tops and bottoms of the force: at least five samples in a row at the very extreme of the record, equal to the last bit,
/// while samples elsewhere scatter; and gaps between frames more than three times as long as usual.
[[nodiscard]] RecordFaults record_faults(const Loop& loop);

}  // namespace setae::experiment
