// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact/jkr_curve.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "setae/core/constants.hpp"

namespace setae::contact::jkr {
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
    // with 17 bits the cube is exact, and so is the correction of the last step
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

/// √(f + p²) and p + √(f + p²), which is x^(3/2); both kept off zero: there the derivatives have no limit.
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

/// The roots along a branch, with √x.
struct Roots1D {
    Array1D root, sum, cube_root;

    Roots1D(const Array1D& forces, double shape) {
        root = (forces + shape * shape).max(0.0).sqrt().max(smallest);
        sum = (root + shape).max(smallest);
        cube_root = cube_roots(sum);
    }
};

}  // namespace

double press_coefficient(double contact_modulus, double radius) { return 4.0 * contact_modulus / (3.0 * radius); }

double pull_coefficient(double modulus_work_root) { return std::sqrt(8.0 * pi) * modulus_work_root; }

CurveValue radius_at(double force, double shape) {
    const auto [root, sum, parted] = roots(force, shape);
    const double value = std::cbrt(sum * sum);
    if (parted) return {.value = value, .by_shape = 2.0 / 3.0 * value / sum};
    return {.value = value, .by_shape = 2.0 / 3.0 * value / root, .by_abscissa = value / (3.0 * root * sum)};
}

CurveValue depth_at(double force, double shape) {
    const auto [root, sum, parted] = roots(force, shape);
    const double square_root = std::cbrt(sum);
    const double value = square_root * (sum - 4.0 / 3.0 * shape);
    if (parted) return {.value = value, .by_shape = -4.0 / 9.0 * square_root};
    return {.value = value,
            .by_shape = 8.0 / 9.0 * shape * square_root / root,
            .by_abscissa = (2.0 * sum - 2.0 / 3.0 * shape) * square_root / (3.0 * root * sum)};
}

CurveValues radii_at(const Array1D& forces, double shape) {
    const Roots1D at(forces, shape);
    CurveValues curve{.value = at.cube_root.square()};
    curve.by_shape = 2.0 / 3.0 * curve.value / (forces < -shape * shape).select(at.sum, at.root);
    return curve;
}

CurveValues depths_at(const Array1D& forces, double shape) {
    const Roots1D at(forces, shape);
    CurveValues curve{.value = at.cube_root * (at.sum - 4.0 / 3.0 * shape)};
    curve.by_shape = at.cube_root * (forces < -shape * shape).select(-4.0 / 9.0, 8.0 / 9.0 * shape / at.root);
    return curve;
}

double modulus_of_length(double length, double force_scale, double sphere_radius) {
    return 0.75 * sphere_radius * force_scale / (length * length * length);
}

double work_of_shape(double shape, double force_scale, double sphere_radius) {
    return shape * std::abs(shape) * force_scale / (1.5 * pi * sphere_radius);
}

DepthCurve::DepthCurve(double shape, double sphere_radius)
    : shape_(shape),
      radius_(sphere_radius),
      fold_(shape > 0.0 ? std::cbrt(0.25 * sphere_radius * shape) : 0.0),
      by_shape_(shape > 0.0 ? std::cbrt(2.0 * sphere_radius * shape) : 0.0) {}

CurveValue DepthCurve::at(double depth) const {
    const double s = root_at(depth), cubed = s * s * s;
    CurveValue point{.value = cubed * (4.0 / 3.0 * cubed / radius_ - 2.0 * shape_), .by_shape = -2.0 * cubed};
    const double slope = 4.0 * cubed / radius_ - shape_;  // 0 at the fold
    constexpr double off_fold = 1e-9;
    if (!(slope > off_fold * std::abs(shape_)) || slope == 0.0) return point;
    const double by_root = s * s * (8.0 * cubed / radius_ - 6.0 * shape_);
    point.by_shape += by_root * s / slope;
    point.by_abscissa = by_root / slope;
    return point;
}

/// The stable root: the polynomial is convex, so that Newton's steps from above it never pass it.
double DepthCurve::root_at(double depth) const {
    if (depth <= fold_ * (fold_ * fold_ * fold_ / radius_ - shape_)) return fold_;
    const double by_depth = depth > 0.0 ? std::sqrt(std::sqrt(2.0 * radius_ * depth)) : 0.0;
    double s = std::max(by_depth, by_shape_);
    constexpr int most = 60;
    constexpr double close = 1e-9;  // the next step, of the order of its square, would be lost in rounding
    for (int i = 0; i < most; ++i) {
        const double cubed = s * s * s / radius_;
        const double step = (s * (cubed - shape_) - depth) / (4.0 * cubed - shape_);
        s -= step;
        if (!(step > close * s)) break;
    }
    return std::max(s, fold_);
}

EnergyReleaseSlopes energy_release_slopes(double contact_radius, double force, const SphereOnFlat& contact) {
    const CurveAt<double> curve(contact_radius);
    const double e = press_coefficient(contact.contact_modulus, contact.radius), per_work = pull_coefficient(1.0);
    const double excess = e * curve.cube - force, area = per_work * per_work * contact.contact_modulus * curve.cube;
    const double value = excess * excess / area, by_excess = 2.0 * excess / area;
    return {.value = value,
            .by_radius = by_excess * 3.0 * e * curve.square - 3.0 * value / contact_radius,
            .by_force = -by_excess,
            .by_modulus = (by_excess * e * curve.cube - value) / contact.contact_modulus};
}

ImpliedRadiusSlopes implied_radius_slopes(double contact_radius, double force, double displacement,
                                          const SphereOnFlat& contact) {
    // a³ − 3Rδa + 3RF/(2E*) = 0
    const double by_radius = 3.0 * (contact_radius * contact_radius - contact.radius * displacement);
    const double compliance = 1.5 * contact.radius / contact.contact_modulus;
    return {.by_force = -compliance / by_radius,
            .by_displacement = 3.0 * contact.radius * contact_radius / by_radius,
            .by_modulus = compliance * force / contact.contact_modulus / by_radius};
}

}  // namespace setae::contact::jkr
