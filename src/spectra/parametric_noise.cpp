// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/parametric_noise.hpp"

#include <boost/math/special_functions/gamma.hpp>
#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/synthesis/random_numbers.hpp"

namespace setae::spectra {

Array2D parametric_noise(const PowerSpectrum1D& spectrum, const ArrayView1D& freedom, Index count, std::uint64_t seed) {
    const Index modes = spectrum.C1D.size();
    if (freedom.size() != modes || !(freedom > 0.0).all() || count < 1)
        throw InvalidArgument(fmt::format("{} replicas of {} wavevectors with {} freedoms, the least {}; expected at least one, as many, all > 0", count, modes,
                                          freedom.size(), freedom.size() > 0 ? freedom.minCoeff() : 0.0));
    Array2D replicas(count, modes);
    for (Index r = 0; r < count; ++r)
        for (Index k = 0; k < modes; ++k) {
            const double uniform = synthesis::uniform_number(synthesis::substream({seed, 0}, static_cast<std::uint64_t>(r)), static_cast<std::uint64_t>(k));
            replicas(r, k) = spectrum.C1D[k] * boost::math::gamma_p_inv(freedom[k], uniform) / freedom[k];
        }
    return replicas;
}

}  // namespace setae::spectra
