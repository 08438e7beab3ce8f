// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/fields/thinned.hpp"

namespace setae::fields {

std::optional<Index> step_of(Index samples) {
    if (samples <= max_samples) return {};
    return (samples + max_samples - 1) / max_samples;
}

Array1D thinned(const Array1D& values) {
    const Index step = step_of(values.size()).value_or(1);
    return values(Eigen::seq(0, values.size() - 1, step));
}

}  // namespace setae::fields
