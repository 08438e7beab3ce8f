// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact/elasticity.hpp"

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::contact {
namespace {

/// (1 − ν²)/E [1/Pa].
double compliance(const ElasticSolid& solid) {
    if (!(solid.youngs_modulus > 0.0))
        throw InvalidArgument(fmt::format("young's modulus must be > 0 Pa, got {}", solid.youngs_modulus));
    if (!(solid.poisson_ratio > -1.0 && solid.poisson_ratio <= 0.5))
        throw InvalidArgument(fmt::format("poisson ratio must lie in (-1, 0.5], got {}", solid.poisson_ratio));
    return (1.0 - solid.poisson_ratio * solid.poisson_ratio) / solid.youngs_modulus;
}

}  // namespace

double contact_modulus(const ElasticSolid& first, const ElasticSolid& second) {
    const double sum = compliance(first) + compliance(second);
    if (sum == 0.0)
        throw InvalidArgument("two rigid bodies have no contact modulus; give one of them a finite Young's modulus");
    return 1.0 / sum;
}

double youngs_modulus_from(double contact_modulus, double poisson_ratio, const ElasticSolid& counter_body) {
    if (!(contact_modulus > 0.0))
        throw InvalidArgument(fmt::format("contact modulus must be > 0 Pa, got {}", contact_modulus));
    const double unit = compliance({.youngs_modulus = 1.0, .poisson_ratio = poisson_ratio});
    const double remaining = 1.0 / contact_modulus - compliance(counter_body);
    if (!(remaining > 0.0))
        throw InvalidArgument(
            fmt::format("contact modulus {} Pa is not below the modulus {} Pa that the counter-body has by itself; "
                        "check Young's modulus and Poisson ratio of the counter-body",
                        contact_modulus, 1.0 / compliance(counter_body)));
    return unit / remaining;
}

}  // namespace setae::contact
