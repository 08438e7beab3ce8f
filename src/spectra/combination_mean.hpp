// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "setae/spectra/combination.hpp"

namespace setae::spectra {

/// How often each measurement takes part: once, or as often as a resample drew it.
using Multiplicity = std::vector<int>;

[[nodiscard]] Multiplicity all_members(const BinnedSpectra& spectra);

/// Weight of every measurement in a bin, multiplicity included; 0 where it has nothing there.
[[nodiscard]] Array1D bin_weights(const BinnedSpectra& spectra, Index bin, Weighting weighting, const Multiplicity& drawn);

/// Weighted mean in every bin; NaN in empty ones.
[[nodiscard]] Array1D bin_means(const BinnedSpectra& spectra, Weighting weighting, const Multiplicity& drawn);

}  // namespace setae::spectra
