// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "front_equation.hpp"
#include "setae/crack_front/circular_front.hpp"

namespace setae::crack_front {

/// The machine in the equation of the front: δ = (pull + 2E*⟨a³⟩/(3R))/(stiffness + 2E*⟨a⟩), or fixed δ.
struct Machine {
    bool holds_displacement = true;
    double displacement = 0.0;           ///< fixed displacement [m]
    double pull = 0.0, stiffness = 0.0;  ///< k_m z or F [N], k_m or 0 [N/m]

    [[nodiscard]] double displacement_of(const Array1D& edge, const contact::SphereOnFlat& sphere) const;
};

/// Balance of the edge of a circular contact; residuals are a (G − w) [J/m].
class CircleEquation final : public FrontEquation {
public:
    CircleEquation(const PinningLines& pinning, LineElasticity& elasticity, const contact::SphereOnFlat& sphere,
                   double mean_work, FrontModel model)
        : FrontEquation(pinning, elasticity), sphere_(sphere), mean_work_(mean_work), model_(model) {}

    void drive(const Machine& machine) { machine_ = machine; }

    /// U [J] of an edge at a displacement, and F = ∂U/∂δ [N].
    struct Elastic {
        double energy, force;
    };
    [[nodiscard]] Elastic elastic(const Array1D& edge, double displacement);

private:
    void elastic_part(const Array1D& edge, const Array1D& bent, Balance& balance) override;
    void scale_pinning(const Array1D& edge, Array1D& scale) override;

    const contact::SphereOnFlat sphere_;
    double mean_work_;
    FrontModel model_;
    Machine machine_;
};

}  // namespace setae::crack_front
