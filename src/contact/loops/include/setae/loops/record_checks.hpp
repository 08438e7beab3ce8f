// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "setae/loops/loop.hpp"

namespace setae::loops {

/// Faults of a record that can still be analysed.
struct RecordFaults {
    std::vector<IndexRange> saturated_high;  ///< samples at the largest force without any noise
    std::vector<IndexRange> saturated_low;   ///< at the smallest
    Index frames = 0;          ///< number of contact radii > 0, and number expected between them from the usual rate
    Index frames_missing = 0;  ///< number of missing frames
    std::optional<IndexRange> longest_gap;  ///< the longest run of samples without the expected frames
    std::optional<Index> time_backwards;    ///< first sample earlier than the one before it
};

/// Flat tops and bottoms of the force: at least five samples in a row at the very extreme of the record, equal to the
/// last bit, and more than twice as many as are equal anywhere else; gaps between frames that are at least half as long
/// again as usual; a time that runs backwards.
[[nodiscard]] RecordFaults record_faults(const Loop& loop);

}  // namespace setae::loops
