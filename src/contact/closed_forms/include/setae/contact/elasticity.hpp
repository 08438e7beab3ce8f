// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace setae::contact {

/// A linear elastic, isotropic solid.
struct ElasticSolid {
    double youngs_modulus = 0.0;  ///< E [Pa], > 0; infinity for a rigid body
    double poisson_ratio = 0.0;   ///< ν, −1 < ν <= 1/2
};

/// A sphere pressed against a flat; only its radius and the combined modulus of the two bodies enter.
struct SphereOnFlat {
    double radius = 0.0;           ///< R [m], > 0
    double contact_modulus = 0.0;  ///< E* [Pa], > 0
};

/// A sphere and a flat with mutual attraction: inputs of every model of adhesion.
struct AdhesiveContact {
    double radius = 0.0;            ///< R [m], > 0
    double contact_modulus = 0.0;   ///< E* [Pa], > 0
    double work_of_adhesion = 0.0;  ///< W [J/m²], >= 0
};

/// Selects one of the two equilibrium radii for one force, or for one displacement.
enum class Branch {
    outer,  ///< the larger radius: stable
    inner,  ///< the smaller radius: unstable, reached only through the pull-off point
};

/// A state of equilibrium.
struct ContactState {
    double force = 0.0;           ///< F [N]
    double displacement = 0.0;    ///< δ [m]
    double contact_radius = 0.0;  ///< a [m]
};

/// Contact modulus E* [Pa] of two solids in contact.
///
///   1/E* = (1 − ν1²)/E1 + (1 − ν2²)/E2
///
/// @throws InvalidArgument for E <= 0, ν outside (−1, 1/2], or two rigid bodies.
/// Source: Johnson, Contact Mechanics (1985), eq. 4.20.
[[nodiscard]] double contact_modulus(const ElasticSolid& first, const ElasticSolid& second);

/// Young's modulus E [Pa] of the one body whose Poisson ratio ν is known, from E* [Pa] and the counter-body.
///
///   E = (1 − ν²) / (1/E* − (1 − ν2²)/E2)
///
/// @throws InvalidArgument outside the domain, and where E* is at least the counter-body's own E2/(1 − ν2²), which no
/// softer partner can give.
[[nodiscard]] double youngs_modulus_from(double contact_modulus, double poisson_ratio,
                                         const ElasticSolid& counter_body);

}  // namespace setae::contact
