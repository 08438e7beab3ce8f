// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduced_jkr.hpp"

#include <algorithm>
#include <cmath>

#include "setae/core/constants.hpp"

namespace setae::experiment::reduced {
namespace {

/// √(f + p²) and p + √(f + p²), both kept off zero: there the derivatives have no limit.
struct Roots {
    double root;
    double sum;
    bool parted;
};

Roots roots(double force, double shape) {
    constexpr double smallest = 1e-9;
    const double square = force + shape * shape;
    const double root = std::sqrt(std::max(square, 0.0));
    return {.root = std::max(root, smallest), .sum = std::max(root + shape, smallest), .parted = square < 0.0};
}

}  // namespace

Point radius(double force, double shape) {
    const auto [root, sum, parted] = roots(force, shape);
    const double value = std::cbrt(sum * sum);
    if (parted) return {.value = value, .by_shape = 2.0 / 3.0 * value / sum};
    return {.value = value, .by_shape = 2.0 / 3.0 * value / root, .by_force = value / (3.0 * root * sum)};
}

Point depth(double force, double shape) {
    const auto [root, sum, parted] = roots(force, shape);
    const double square_root = std::cbrt(sum);  // √A
    const double value = square_root * (sum - 4.0 / 3.0 * shape);  // A^(3/2) = sum
    if (parted) return {.value = value, .by_shape = -4.0 / 9.0 * square_root};
    return {.value = value,
            .by_shape = 8.0 / 9.0 * shape * square_root / root,
            .by_force = (2.0 * sum - 2.0 / 3.0 * shape) * square_root / (3.0 * root * sum)};
}

Array1D shape_candidates() {
    constexpr Index steps = 60;
    Array1D candidates(steps + 1);
    candidates[0] = 0.0;
    candidates.tail(steps) = pow(10.0, Array1D::LinSpaced(steps, -1.5, 1.0));
    return candidates;
}

double contact_modulus(double length, double force_scale, double sphere_radius) {
    return 0.75 * sphere_radius * force_scale / (length * length * length);
}

double work_of_adhesion(double shape, double force_scale, double sphere_radius) {
    return shape * std::abs(shape) * force_scale / (1.5 * pi * sphere_radius);
}

}  // namespace setae::experiment::reduced
