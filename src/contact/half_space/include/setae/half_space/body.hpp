// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace setae::half_space {

/// Boundary condition of a layer at its rigid base.
enum class Base {
    bonded,        ///< no separation and no sliding
    frictionless,  ///< sliding without separation
};

/// An elastic layer on a rigid base.
struct Layer {
    double thickness = 0.0;      ///< t [m], > 0
    double poisson_ratio = 0.5;  ///< ν, −1 < ν <= 1/2
    Base base = Base::bonded;
};

/// The deforming body of a contact: a half-space, or a layer where one is given. The other body is rigid; for two
/// elastic half-spaces use contact::contact_modulus of both and the composite roughness.
struct Body {
    double contact_modulus = 0.0;  ///< E* = E/(1 − ν²) [Pa], > 0
    std::optional<Layer> layer;
};

/// Stiffness k(q) [Pa/m]: the pressure for a wave of displacement of unit amplitude, without shear in the surface.
///
///   half-space              k = E* q/2
///   layer, bonded           k = E* q/2 · contact::layer::stiffness_ratio(qt, ν),  k(0) = E* (1 − ν)²/((1 − 2ν) t)
///   layer, frictionless     k = E* q/2 · (sinh 2x + 2x)/(cosh 2x − 1), x = qt,    k(0) as bonded
///
/// q: length of the wavevector [rad/m], >= 0. At q = 0 the layer keeps its widths, like a periodic cell (k is that of
/// the oedometer): infinite for ν = 1/2. k of a frictionless layer decreases to E*/t for long waves, less than k(0).
/// @throws InvalidArgument for q < 0 or a body outside its domain.
/// Sources: Johnson, Contact Mechanics (1985), ch. 13; Carbone, Mangialardi, J. Mech. Phys. Solids 56 (2008) 684.
[[nodiscard]] double stiffness(double wavevector, const Body& body);

/// Refuses a body outside its domain. @throws InvalidArgument.
void require(const Body& body);

}  // namespace setae::half_space
