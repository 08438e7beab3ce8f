// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::loops {

/// Samples first … last, both included.
struct IndexRange {
    Index first = 0;
    Index last = 0;

    [[nodiscard]] Index count() const { return last - first + 1; }
    [[nodiscard]] bool contains(Index sample) const { return first <= sample && sample <= last; }
    friend bool operator==(const IndexRange&, const IndexRange&) = default;
};

}  // namespace setae::loops
