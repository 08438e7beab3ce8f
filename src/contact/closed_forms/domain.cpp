// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::contact {

namespace {

/// @throws InvalidArgument for a value that is no number; users did not give it: it follows from quantities out of
/// range.
void require_number(double value, const char* what) {
    if (std::isnan(value))
        throw InvalidArgument(fmt::format(
            "{} cannot be computed; check the radius, forces and displacements and their units: one of them "
            "is out of range",
            what));
}

}  // namespace

void require_positive(double value, const char* what) {
    require_number(value, what);
    if (!(value > 0.0) || std::isinf(value))
        throw InvalidArgument(fmt::format("{} must be > 0 and finite, got {}", what, value));
}

void require_not_negative(double value, const char* what) {
    require_number(value, what);
    if (!(value >= 0.0)) throw InvalidArgument(fmt::format("{} must be >= 0, got {}", what, value));
}

void require_sphere(double radius, double contact_modulus) {
    require_positive(radius, "sphere radius");
    require_positive(contact_modulus, "contact modulus");
}

}  // namespace setae::contact
