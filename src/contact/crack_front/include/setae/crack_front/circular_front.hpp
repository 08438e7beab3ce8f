// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <variant>

#include "setae/contact/elasticity.hpp"
#include "setae/crack_front/work_field.hpp"

namespace setae::crack_front {

/// Dependence of the elastic energy of the contact on its edge a(θ); ã_n are the waves of a, n = …, −1, 0, 1, …
///
///   K a = Σ |n| ã_n exp(inθ),   Q = Σ |n||ã_n|²,   D = δ − a²/R,   G_J = E* D²/(2πa) of a circle, K_J = √(2E*G_J)
///
///   constant_toughness   U = ⟨U_JKR(a)⟩ + π W Q           a G_J(a) + W K a = a w
///   variational          U = ⟨U_JKR(a)⟩ + π G_J(ā) Q      a G_J(a) + G_J(ā) K a + ½ G_J'(ā) Q = a w
///   energy_release_rate  G_J(a) (1 + K a/a) = w
///   stress_intensity     K_J(a) (1 + K a/2a) = √(2E*w)
///   mean_circle          G_J(ā) (1 + K a/ā) = w: displacement of the edge enters by waves only
///
/// All are equal to first order in the waves, except mean_circle, which omits G_J'(ā). In the first, the stiffness of
/// the front is that of the mean work W; it is the model for roughness, and the only one for dead loads, stages and
/// rosso_krauth. Where D > 0 the edge closes: a G_J has the sign of −a G_J there.
/// Sources: Gao, Rice, J. Appl. Mech. 54 (1987) 627 (K of a wavy circle); Sanner, Pastewka, J. Mech. Phys. Solids 160
/// (2022) 104781 (energies).
enum class FrontModel { constant_toughness, variational, energy_release_rate, stress_intensity, mean_circle };

/// Method for equilibria, see docs/concepts/crack-front.md. Both methods follow a slowly moving front and agree.
enum class EquilibriumMethod {
    rosso_krauth,  ///< points move in one direction: cannot pass an equilibrium, for any steps
    trust_region,  ///< Newton steps of limited length: about twenty times faster
};

/// Fixed displacement δ [m].
struct HeldDisplacement {
    double displacement = 0.0;
};
/// A dead load F [N], > 0 presses.
struct DeadLoad {
    double force = 0.0;
};
/// A stage at z [m] presses through a spring of stiffness k_m [N/m] > 0: F = k_m (z − δ).
struct Stage {
    double position = 0.0, stiffness = 0.0;
};
using FrontControl = std::variant<HeldDisplacement, DeadLoad, Stage>;

struct FrontOptions {
    FrontModel model = FrontModel::constant_toughness;
    EquilibriumMethod method = EquilibriumMethod::trust_region;
    /// tolerance of the largest |residual| divided by W and the mean radius; near the separation of a smooth contact,
    /// that contact's residual if it is larger
    double tolerance = 1e-9;
    int max_iterations = 100000;  ///< iterations per equilibrium
    double largest_move = 0.5;    ///< largest move of a point in one step of the trust region, in spacings of the field
};

/// A contact in equilibrium, or separated: then all 0 except the displacement.
struct FrontState {
    double displacement = 0.0;                           ///< δ [m]
    double force = 0.0;                                  ///< F [N]
    double mean_radius = 0.0, area_radius = 0.0;         ///< ⟨a⟩, √⟨a²⟩ [m]
    double smallest_radius = 0.0, largest_radius = 0.0;  ///< [m]
    double perimeter = 0.0;                              ///< ∫ √(a² + a'²) dθ [m]
    double elastic_energy = 0.0;                         ///< U [J]; zero for separated bodies
    double surface_energy = 0.0;                         ///< −∫∫ w a da dθ [J]
    double residual = 0.0;                               ///< largest residual, divided by W and the mean radius
    int iterations = 0;
    bool converged = false;
    bool in_contact = false;

    [[nodiscard]] double energy() const { return elastic_energy + surface_energy; }
};

/// The edge of the contact of a sphere on a flat in a field of work of adhesion on rays, N points for N rays.
///
/// The contact is full inside the edge, the edge is a function of the angle, and its waves are low. A front that
/// reaches the centre has separated. Uses one thread.
class CircularFront {
public:
    /// @throws InvalidArgument for a sphere or field outside its domain, and rosso_krauth with another model than
    /// constant_toughness.
    CircularFront(const contact::SphereOnFlat& sphere, const WorkField& field, const FrontOptions& options = {});
    ~CircularFront();
    CircularFront(CircularFront&&) noexcept;
    CircularFront& operator=(CircularFront&&) noexcept;

    [[nodiscard]] const contact::SphereOnFlat& sphere() const;
    [[nodiscard]] double mean_work() const;
    [[nodiscard]] const LinePoints& radii_of_field() const;

    /// a(θ_j) [m]; empty after separation.
    [[nodiscard]] const Array1D& edge() const;
    /// A circle as the start; 0: the smallest contact at the next control, as for approaching bodies.
    void begin_at(double radius);
    /// Continues from a stored edge. @throws InvalidArgument for another number of points.
    void begin_with(const Array1D& edge);

    /// Equilibrium under a control, from the present edge. Separated bodies come into contact at δ >= 0 (a dead load >=
    /// 0). @throws InvalidArgument where the front moves beyond the field's last radius, for a stage without stiffness,
    /// and other controls than a displacement where the model is not constant_toughness.
    FrontState solve(const FrontControl& control);

private:
    class Work;
    std::unique_ptr<Work> work_;
};

}  // namespace setae::crack_front
