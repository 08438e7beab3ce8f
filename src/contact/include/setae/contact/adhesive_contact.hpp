// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace setae::contact {

/// A sphere on a flat that attract each other: what every model of adhesion starts from.
struct AdhesiveContact {
    double radius = 0.0;            ///< R [m], > 0
    double contact_modulus = 0.0;   ///< E* [Pa], > 0
    double work_of_adhesion = 0.0;  ///< W [J/m²], >= 0
};

/// Which of the two equilibrium radii that belong to one force, or to one displacement.
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

}  // namespace setae::contact
