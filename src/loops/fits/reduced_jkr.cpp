// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduced_jkr.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "setae/core/constants.hpp"

namespace setae::loops::reduced {
namespace {

constexpr double smallest = 1e-9;

/// One of Halley's steps to a cube root; it leaves two thirds of the cube of the error.
double closer(double root, double value) {
    const double cubed = root * root * root;
    return root + root * ((value - cubed) / (2.0 * cubed + value));
}

/// Cube roots of numbers > 0, right to rounding.
Array1D cube_roots(const Array1D& values) {
    // a third of the bits of exponent and mantissa is right to 3 %
    constexpr std::uint64_t offset = 0x2A9F7893'782DA1CE;
    // with 17 bits the cube is exact, and so is what the last step takes off
    constexpr std::uint64_t half = std::uint64_t{1} << 35, mask = ~((half << 1) - 1);
    Array1D roots(values.size());
    for (Index i = 0; i < values.size(); ++i)
        roots[i] = std::bit_cast<double>(std::bit_cast<std::uint64_t>(values[i]) / 3 + offset);
    for (Index i = 0; i < values.size(); ++i) {
        const double near = closer(closer(roots[i], values[i]), values[i]);
        roots[i] = closer(std::bit_cast<double>((std::bit_cast<std::uint64_t>(near) + half) & mask), values[i]);
    }
    return roots;
}

/// √(f + p²) and p + √(f + p²), both kept off zero: there the derivatives have no limit.
struct Roots {
    double root;
    double sum;
    bool parted;
};

Roots roots(double force, double shape) {
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
    const double square_root = std::cbrt(sum);                     // √A
    const double value = square_root * (sum - 4.0 / 3.0 * shape);  // A^(3/2) = sum
    if (parted) return {.value = value, .by_shape = -4.0 / 9.0 * square_root};
    return {.value = value,
            .by_shape = 8.0 / 9.0 * shape * square_root / root,
            .by_force = (2.0 * sum - 2.0 / 3.0 * shape) * square_root / (3.0 * root * sum)};
}

namespace {

/// √(f + p²), p + √(f + p²) and its cube root along a branch, as `roots`.
struct Roots1D {
    Array1D root, sum, cube_root;

    Roots1D(const Array1D& force, double shape) {
        root = (force + shape * shape).max(0.0).sqrt().max(smallest);
        sum = (root + shape).max(smallest);
        cube_root = cube_roots(sum);
    }
};

}  // namespace

Curve radii(const Array1D& force, double shape) {
    const Roots1D roots(force, shape);
    Curve curve{.value = roots.cube_root.square()};
    curve.by_shape = 2.0 / 3.0 * curve.value / (force < -shape * shape).select(roots.sum, roots.root);
    return curve;
}

Curve depths(const Array1D& force, double shape) {
    const Roots1D roots(force, shape);
    Curve curve{.value = roots.cube_root * (roots.sum - 4.0 / 3.0 * shape)};
    curve.by_shape = roots.cube_root * (force < -shape * shape).select(-4.0 / 9.0, 8.0 / 9.0 * shape / roots.root);
    return curve;
}

Array1D shape_candidates() {
    constexpr Index steps = 20;
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

}  // namespace setae::loops::reduced
