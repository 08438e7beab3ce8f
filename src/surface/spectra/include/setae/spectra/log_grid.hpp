// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::spectra {

/// Logarithmic bins aligned to decades, the same for all data: bin b spans [10^(b/n), 10^((b+1)/n)) 1/m with n bins per
/// decade; b may be negative. A bin reports its geometric centre 10^((b+½)/n).
struct LogGrid {
    int bins_per_decade = 10;

    [[nodiscard]] double edge(Index bin) const;
    [[nodiscard]] double centre(Index bin) const;
    /// The bin of a wavevector. A wavevector equal to an edge up to rounding (1e-12) belongs to the bin above.
    /// @throws InvalidArgument for q that is not positive and finite.
    [[nodiscard]] Index bin_of(double wavevector) const;
};

}  // namespace setae::spectra
