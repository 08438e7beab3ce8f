// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/parametric_noise.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/numerics/random_numbers.hpp"

namespace setae::spectra {
namespace {

constexpr std::uint64_t attempts = 16;  // each fails in less than 1 of 20

}  // namespace

NoiseNumbers::NoiseNumbers(std::uint64_t seed, std::uint64_t replica)
    : seed_(seed),
      normal_(numerics::substream({seed, 0}, 2 * replica).stream),
      uniform_(numerics::substream({seed, 0}, 2 * replica + 1).stream) {}

double NoiseNumbers::gamma(std::uint64_t index, double shape) const {
    const double raised = shape < 1.0 ? shape + 1.0 : shape, d = raised - 1.0 / 3.0, c = 1.0 / std::sqrt(9.0 * d);
    const std::uint64_t first = index * (attempts + 1);
    const double boost =
        shape < 1.0 ? std::pow(numerics::uniform_number({seed_, uniform_}, first + attempts), 1.0 / shape) : 1.0;
    for (std::uint64_t a = 0; a < attempts; ++a) {
        const double x = numerics::normal_number({seed_, normal_}, first + a), root = 1.0 + c * x,
                     v = root * root * root;
        if (!(v > 0.0)) continue;
        const double u = numerics::uniform_number({seed_, uniform_}, first + a), x2 = x * x;
        const bool surely = u < 1.0 - 0.0331 * x2 * x2;  // implied by the test with logarithms
        if (surely || std::log(u) < 0.5 * x2 + d - d * v + d * std::log(v)) return boost * d * v / shape;
    }
    return boost * d / shape;
}

double NoiseNumbers::normal(std::uint64_t index) const {
    return numerics::normal_number({seed_, normal_}, index * (attempts + 1) + attempts);
}

Array2D parametric_noise(const MeasuredSpectrum& spectrum, const ArrayView1D& freedom, Index count,
                         std::uint64_t seed) {
    const Index modes = spectrum.density.size();
    if (freedom.size() != modes || !(freedom > 0.0).all() || count < 1)
        throw InvalidArgument(
            fmt::format("{} replicas of {} wavevectors with {} degrees of freedom, the smallest {}; expected at least "
                        "one replica and one number > 0 per wavevector",
                        count, modes, freedom.size(), freedom.size() > 0 ? freedom.minCoeff() : 0.0));
    Array2D replicas(count, modes);
    for (Index r = 0; r < count; ++r) {
        const NoiseNumbers random(seed, static_cast<std::uint64_t>(r));
        for (Index k = 0; k < modes; ++k)
            replicas(r, k) = spectrum.density[k] * random.gamma(static_cast<std::uint64_t>(k), freedom[k]);
    }
    return replicas;
}

}  // namespace setae::spectra
