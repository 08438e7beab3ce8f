// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact/crack_speed.hpp"

#include <cmath>

#include "domain.hpp"
#include "mapped.hpp"
#include "setae/core/constants.hpp"

namespace setae::contact::crack_speed {
namespace {

void require(const Law& law) {
    require_positive(law.threshold, "energy release rate at rest");
    require_positive(law.reference_speed, "reference speed");
    require_positive(law.exponent, "exponent of the crack speed");
}

}  // namespace

double energy_release_rate(double speed, const Law& law) {
    require(law);
    require_not_negative(speed, "crack speed");
    return law.threshold * (1.0 + std::pow(speed / law.reference_speed, law.exponent));
}

double speed(double energy_release_rate, const Law& law) {
    require(law);
    if (!(energy_release_rate >= law.threshold)) return undefined;
    const double excess = (energy_release_rate - law.threshold) / law.threshold;
    return law.reference_speed * std::pow(excess, 1.0 / law.exponent);
}

double energy_release_rate_derivative(double speed, const Law& law) {
    require(law);
    require_not_negative(speed, "crack speed");
    return law.exponent * law.threshold / law.reference_speed *
           std::pow(speed / law.reference_speed, law.exponent - 1.0);
}

Array1D energy_release_rate(const ArrayView1D& speed, const Law& law) {
    return mapped(speed, [&](double v) { return energy_release_rate(v, law); });
}

Array1D speed(const ArrayView1D& energy_release_rate, const Law& law) {
    return mapped(energy_release_rate, [&](double g) { return speed(g, law); });
}

}  // namespace setae::contact::crack_speed
