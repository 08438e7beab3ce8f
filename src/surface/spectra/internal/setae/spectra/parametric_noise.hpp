// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "setae/spectra/power_spectrum.hpp"

namespace setae::spectra {

/// Neighbouring modes of a Hann window share their data: independent share of a mode, ω = 1/Σ |ρ|² = 1/(1 + 2 (4/9 +
/// 1/36)).
inline constexpr double share_under_hann = 0.5142857142857142;

/// Random numbers of one replica. Every index has a number of each kind, independent of earlier draws.
class NoiseNumbers {
public:
    NoiseNumbers(std::uint64_t seed, std::uint64_t replica);

    /// Gamma distributed with mean 1. shape: > 0.
    /// Source: Marsaglia, Tsang, ACM Trans. Math. Softw. 26 (2000) 363; shapes below 1 by G(ν + 1) U^(1/ν).
    [[nodiscard]] double gamma(std::uint64_t index, double shape) const;
    /// Gaussian with mean 0 and variance 1, independent of the gamma number with this index.
    [[nodiscard]] double normal(std::uint64_t index) const;

private:
    std::uint64_t seed_, normal_, uniform_;  ///< the seed and its two streams
};

/// Scatter of C1D between places of the same surface, for one measurement.
///
///   C_k G_k,  G_k gamma distributed with mean 1 and shape ν_k, all independent
///
/// This is the scatter of a periodogram of Gaussian heights, ν_k the number of independent values: independent lines
/// times the independent share of a mode, for a correct scatter of sums over modes. freedom: ν of each wavevector, > 0.
/// One replica per row [m³]; the same seed gives the same numbers, and the same first replicas for a larger count.
/// @throws InvalidArgument for sizes that differ, freedoms that are not positive, count < 1.
/// Source: Brillinger, Time Series (2001) ch. 5 (distribution of periodograms); Franke, Härdle, Ann. Stat. 20 (1992)
/// 121 (replicas).
[[nodiscard]] Array2D parametric_noise(const MeasuredSpectrum& spectrum, const ArrayView1D& freedom, Index count,
                                       std::uint64_t seed);

}  // namespace setae::spectra
