// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "setae/parallel/for_each.hpp"
#include "setae/spectra/combination.hpp"

namespace setae::spectra {

/// Sampling with replacement.
enum class Draw {
    measurements,            ///< among all measurements
    within_instruments,      ///< among those of each instrument, so no instrument is lost
    instruments_and_within,  ///< instruments, then as many measurements among those of each drawn one: scatter of both
                             ///< levels
};

struct BootstrapOptions {
    int resamples = 1000;
    std::uint64_t seed = 1;
    Draw draw = Draw::measurements;
    Weighting weighting = Weighting::equal;
    parallel::Threads threads;
};

/// Combined spectra of resampled measurements, on the bins of the full combination.
struct BootstrapSpectra {
    Array1D wavevector;               ///< as in CombinedSpectrum [1/m]
    Array2D C1D;                      ///< (resample, bin) [m³], no gaps
    Array1D filled_share;             ///< share of resamples in which the bin was missing and filled
    std::vector<Multiplicity> drawn;  ///< of each resample, the number of draws of each measurement
    std::uint64_t seed = 0;
};

/// Draws measurements that have data, with replacement, and combines them, `resamples` times.
///
/// A bin without a drawn measurement is filled with the value of the full combination times the ratio resample/full of
/// the neighbouring bins, the ratio interpolated in ln q (constant beyond the ends). The same seed gives the same bytes
/// on any computer and for any number of threads: resample r draws numerics::random_index 0, 1, … of the substream r of
/// the seed.
/// @throws InvalidArgument for resamples < 1.
[[nodiscard]] BootstrapSpectra bootstrap(const BinnedSpectra& spectra, const BootstrapOptions& options = {});

}  // namespace setae::spectra
