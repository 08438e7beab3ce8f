// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "setae/spectra/combination.hpp"

namespace setae::spectra {

[[nodiscard]] Multiplicity all_members(const BinnedSpectra& spectra);

/// Weight of every measurement in a bin, multiplicity included; 0 if it has no value there.
[[nodiscard]] Array1D bin_weights(const BinnedSpectra& spectra, Index bin, Weighting weighting,
                                  const Multiplicity& drawn);

/// Weighted mean in every bin; NaN in empty ones.
[[nodiscard]] Array1D bin_means(const BinnedSpectra& spectra, Weighting weighting, const Multiplicity& drawn);

/// Bins whose mean is not NaN.
[[nodiscard]] std::vector<Index> filled_bins(const Array1D& means);

/// Replaces NaN by full times the ratio of the neighbours, interpolated linearly over the bins. @returns the filled
/// bins.
Eigen::Array<bool, Eigen::Dynamic, 1> fill_lost_bins(Array1D& means, const Array1D& full);

}  // namespace setae::spectra
