// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/core/arrays.hpp"

namespace setae::spectral_fit {

/// Groups of modes k = 1 … n: single modes up to 16, then about 32 groups per decade. A likelihood of the mean over a
/// group loses no information if the expectation is the mean over the same group.
class ModeBins {
public:
    explicit ModeBins(Index modes);

    [[nodiscard]] Index size() const { return static_cast<Index>(first_.size()) - 1; }
    [[nodiscard]] Index first(Index bin) const { return first_[static_cast<std::size_t>(bin)]; }         ///< lowest k
    [[nodiscard]] Index last(Index bin) const { return first_[static_cast<std::size_t>(bin) + 1] - 1; }  ///< highest k
    [[nodiscard]] Index count(Index bin) const { return last(bin) - first(bin) + 1; }
    [[nodiscard]] double centre(Index bin) const { return 0.5 * static_cast<double>(first(bin) + last(bin)); }
    /// Mean over each group of values given for k = 1 … n.
    [[nodiscard]] Array1D means(const ArrayView1D& values) const;

private:
    std::vector<Index> first_;
};

}  // namespace setae::spectral_fit
