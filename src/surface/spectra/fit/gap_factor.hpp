// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "setae/parallel/for_each.hpp"
#include "setae/spectra/spectral_density.hpp"
#include "setae/spectral_fit/scan_kernel.hpp"

namespace setae::spectral_fit {

/// Gaps in the lines of one measurement.
struct GappedLines {
    Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic> undefined;  ///< (point, line) of at most 64 lines with gaps
    double share = 0.0;                                            ///< lines with gaps among all lines
};

struct BridgedLines {
    Array2D heights;
    GappedLines gaps;
};

/// Interpolates over the gaps of every line along x (topography::bridge_gaps) and removes lines with less than half of
/// the points defined.
/// @throws UndefinedDataError if no line is left.
[[nodiscard]] BridgedLines bridged_lines(const Array2D& heights, const std::string& label);

/// Effect of interpolated gaps on the expected periodogram, for each group of modes of a scan:
///
///   ⟨P of bridged lines⟩/⟨P of whole lines⟩
///
/// over random Gaussian lines with this spectrum (256, fewer if they are long), each with the gaps of a line; lines
/// without gaps count as 1. C1D: of the measured lines, including tip and noise.
[[nodiscard]] Array1D gap_factor(const GappedLines& gaps, const ScanShape& shape, double pixel_size,
                                 const spectra::SpectralDensity& C1D, std::uint64_t seed,
                                 parallel::Threads threads = {});

}  // namespace setae::spectral_fit
