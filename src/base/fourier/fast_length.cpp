// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/fourier/fast_length.hpp"

#include <algorithm>

namespace setae::fourier {

Index fast_length(Index least) {
    for (Index n = std::max<Index>(least, 1);; ++n) {
        Index rest = n;
        for (const Index factor : {2, 3, 5})
            while (rest % factor == 0) rest /= factor;
        if (rest == 1) return n;
    }
}

}  // namespace setae::fourier
