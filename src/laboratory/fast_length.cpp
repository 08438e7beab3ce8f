// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast_length.hpp"

#include <algorithm>
#include <cmath>

namespace setae::laboratory {

Index fast_length(double n) {
    for (auto candidate = static_cast<Index>(std::ceil(std::max(n, 2.0)));; ++candidate) {
        Index rest = candidate;
        for (const Index factor : {2, 3, 5})
            while (rest % factor == 0) rest /= factor;
        if (rest == 1) return candidate;
    }
}

}  // namespace setae::laboratory
