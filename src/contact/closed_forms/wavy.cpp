// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact/wavy.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/bracketing.hpp"
#include "setae/numerics/minimum.hpp"

namespace setae::contact::wavy {

double closing_pressure(double energy_ratio) {
    if (!(energy_ratio > 0.0))
        throw InvalidArgument(fmt::format("stored energy over work of adhesion is {}; expected > 0", energy_ratio));
    if (std::isinf(energy_ratio)) return 1.0;
    const double alpha = 1.0 / std::sqrt(2.0 * pi * energy_ratio);
    // beyond a = 1/4 the curve has one maximum, the last before full contact
    const auto less = [alpha](double a) { return alpha * std::sqrt(std::tan(pi * a)) - std::pow(std::sin(pi * a), 2); };
    constexpr int bits = 50;
    return -numerics::minimum_between(less, 0.25, 0.5 - 1e-9, bits).value;
}

double closing_energy() {
    static const double energy = [] {
        constexpr int bits = 50;
        return numerics::bracketed_root([](double e) { return closing_pressure(e); }, 0.3, 0.8, bits);
    }();
    return energy;
}

}  // namespace setae::contact::wavy
