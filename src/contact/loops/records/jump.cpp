// SPDX-License-Identifier: GPL-3.0-or-later
#include "jump.hpp"

#include <cmath>

namespace setae::loops {

Index largest_step(const Array1D& force, const IndexRange& jump) {
    Index at = jump.first;
    for (Index i = jump.first; i < jump.last; ++i)
        if (std::abs(force[i + 1] - force[i]) > std::abs(force[at + 1] - force[at])) at = i;
    return at;
}

}  // namespace setae::loops
