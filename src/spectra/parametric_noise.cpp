// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/parametric_noise.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/numerics/random_numbers.hpp"

namespace setae::spectra {
namespace {

using numerics::RandomKey;

/// Two sequences of a replica; each number of the result has `attempts` places of its own in both.
struct Sequences {
    RandomKey normal, uniform;
};

constexpr std::uint64_t attempts = 16;  // each fails in less than 1 of 20

/// A gamma variate of mean 1. Source: Marsaglia, Tsang, ACM Trans. Math. Softw. 26 (2000) 363; shapes below 1 by G(ν +
/// 1) U^(1/ν).
double gamma_number(const Sequences& random, std::uint64_t index, double shape) {
    const double raised = shape < 1.0 ? shape + 1.0 : shape, d = raised - 1.0 / 3.0, c = 1.0 / std::sqrt(9.0 * d);
    const std::uint64_t first = index * (attempts + 1);
    const double boost =
        shape < 1.0 ? std::pow(numerics::uniform_number(random.uniform, first + attempts), 1.0 / shape) : 1.0;
    for (std::uint64_t a = 0; a < attempts; ++a) {
        const double x = numerics::normal_number(random.normal, first + a), root = 1.0 + c * x, v = root * root * root;
        if (v > 0.0 &&
            std::log(numerics::uniform_number(random.uniform, first + a)) < 0.5 * x * x + d - d * v + d * std::log(v))
            return boost * d * v / shape;
    }
    return boost * d / shape;
}

}  // namespace

Array2D parametric_noise(const MeasuredSpectrum& spectrum, const ArrayView1D& freedom, Index count,
                         std::uint64_t seed) {
    const Index modes = spectrum.density.size();
    if (freedom.size() != modes || !(freedom > 0.0).all() || count < 1)
        throw InvalidArgument(fmt::format(
            "{} replicas of {} wavevectors with {} freedoms, the least {}; expected at least one, as many, all > 0",
            count, modes, freedom.size(), freedom.size() > 0 ? freedom.minCoeff() : 0.0));
    Array2D replicas(count, modes);
    for (Index r = 0; r < count; ++r) {
        const auto replica = static_cast<std::uint64_t>(r);
        const Sequences random{numerics::substream({seed, 0}, 2 * replica),
                               numerics::substream({seed, 0}, 2 * replica + 1)};
        for (Index k = 0; k < modes; ++k)
            replicas(r, k) = spectrum.density[k] * gamma_number(random, static_cast<std::uint64_t>(k), freedom[k]);
    }
    return replicas;
}

}  // namespace setae::spectra
