// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "setae/contact/elasticity.hpp"
#include "setae/core/arrays.hpp"

/// The JKR curve with its derivatives, for fits: along the contact radius, against force, against depth.
///
/// Two terms of force and two of depth, with x the contact radius, are sufficient:
///
///   f = e x³ − g x^(3/2),  d = x² − (2/3)(g/e) √x
///
/// In SI units x = a, f = F, δ = d/R, e = 4E*/(3R), g = √(8πE*W). The curve is smooth in x through the folds at
/// separation, and with a signed g it continues to W < 0, contacts smaller than Hertz's, so that a fit near W = 0 needs
/// no bound.
namespace setae::contact::jkr {

/// e of E* and R [N/m³], and g of √(E*W) with the sign of W [N/m^1.5].
[[nodiscard]] double press_coefficient(double contact_modulus, double radius);
[[nodiscard]] double pull_coefficient(double modulus_work_root);

/// The curve at one contact radius x > 0, or at several where Real is an array.
template <class Real>
struct CurveAt {
    Real x, root, square, cube, three_halves;  ///< x, √x, x², x³, x^(3/2)

    explicit CurveAt(const Real& radius)
        : x(radius), root(square_root(radius)), square(x * x), cube(square * x), three_halves(x * root) {}

    [[nodiscard]] Real force(double e, double g) const { return e * cube - g * three_halves; }
    [[nodiscard]] Real force_slope(double e, double g) const { return 3.0 * e * square - 1.5 * g * root; }
    [[nodiscard]] Real force_bend(double e, double g) const { return 6.0 * e * x - 0.75 * g * inverse_root(); }

    /// For depths, p is (2/3) g/e.
    [[nodiscard]] Real depth(double p) const { return square - p * root; }
    [[nodiscard]] Real depth_slope(double p) const { return 2.0 * x - 0.5 * p * inverse_root(); }
    [[nodiscard]] Real depth_bend(double p) const { return 2.0 + 0.25 * p * inverse_root() / x; }

    [[nodiscard]] Real inverse_root() const { return root / x; }

private:
    [[nodiscard]] static Real square_root(const Real& value) {
        using std::sqrt;
        return sqrt(value);
    }
};

/// A value with its derivatives by the curve's shape and by its argument.
struct CurveValue {
    double value = 0.0;
    double by_shape = 0.0;
    double by_abscissa = 0.0;
};

/// Against force, in units of e = 1 and g = 2p, where p² is the pull-off under a dead load:
///
///   x = (p + √(f + p²))^(2/3),  d = x² − 4/3 p √x
///
/// p is the shape. Below the pull-off, f < −p², both keep their values there. With a scale of force F_s, p² =
/// 3πRW/(2F_s), and lengths come in units of L, L³ = 3RF_s/(4E*), depths in units of L²/R.
[[nodiscard]] CurveValue radius_at(double force, double shape);
[[nodiscard]] CurveValue depth_at(double force, double shape);

/// Values along a branch, without the derivative by force.
struct CurveValues {
    Array1D value;
    Array1D by_shape;
};
[[nodiscard]] CurveValues radii_at(const Array1D& forces, double shape);
[[nodiscard]] CurveValues depths_at(const Array1D& forces, double shape);

/// E* [Pa] from L [m], and W [J/m²] from p with the sign of p.
[[nodiscard]] double modulus_of_length(double length, double force_scale, double sphere_radius);
[[nodiscard]] double work_of_shape(double shape, double force_scale, double sphere_radius);

/// F/E* [m²] against the penetration δ [m] from first contact, on the stable branch; beyond separation the force is
/// constant. With s = √a, s⁴/R − λs = δ and F/E* = 4s⁶/(3R) − 2λs³: the shape is λ = √(2πW/E*), signed.
class DepthCurve {
public:
    DepthCurve(double shape, double sphere_radius);
    [[nodiscard]] CurveValue at(double depth) const;

private:
    [[nodiscard]] double root_at(double depth) const;

    double shape_, radius_;
    double fold_;      ///< √a where the contact parts
    double by_shape_;  ///< not below √a at depth 0
};

/// Energy release rate G = (4E*a³/(3R) − F)²/(8πE*a³) [J/m²] at contact radius a > 0 with its derivatives.
struct EnergyReleaseSlopes {
    double value, by_radius, by_force, by_modulus;
};
[[nodiscard]] EnergyReleaseSlopes energy_release_slopes(double contact_radius, double force,
                                                        const SphereOnFlat& contact);

/// Derivatives of the contact radius that force and displacement imply, contact_radius_at.
struct ImpliedRadiusSlopes {
    double by_force, by_displacement, by_modulus;
};
[[nodiscard]] ImpliedRadiusSlopes implied_radius_slopes(double contact_radius, double force, double displacement,
                                                        const SphereOnFlat& contact);

}  // namespace setae::contact::jkr
