// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "setae/parallel/for_each.hpp"
#include "setae/roughness/spectral_moments.hpp"

namespace setae::roughness {

struct ModeNoiseOptions {
    WavelengthLimits limits;  ///< of the integrals
    Conversion conversion = Conversion::exact;
    Index count = 200;  ///< of replicas, >= 1
    std::uint64_t seed = 0;
    parallel::Threads threads;
};

/// Scatter of parameters between places of the same surface, from the scatter of a periodogram.
///
///   C_k G_k,  G_k gamma distributed with mean 1 and shape ν_k, all independent
///
/// freedom: ν_k of each wavevector of the spectrum, > 0. The first 2048 modes are drawn separately. Those of shorter
/// waves are drawn in bands 2 % wide: the sum of a band is gamma distributed with the total variance of its modes, the
/// mean of ln G is Gaussian with its variance and its covariance with the sum. Within such a band q is constant, so the
/// cost of a replica does not grow with the number of modes. The same seed gives the same numbers, for any number of
/// threads.
/// @throws InvalidArgument as spectra::parametric_noise(), and for a spectrum that is not of modes.
/// @throws UndefinedDataError for fewer than two usable modes.
[[nodiscard]] std::vector<SpectralParameters> parameters_of_noise(const spectra::MeasuredSpectrum& spectrum,
                                                                  const ArrayView1D& freedom,
                                                                  const ModeNoiseOptions& options);

}  // namespace setae::roughness
