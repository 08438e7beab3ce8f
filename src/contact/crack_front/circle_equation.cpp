// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_equation.hpp"

#include <cmath>

#include "setae/core/constants.hpp"

namespace setae::crack_front {
namespace {

/// G_J of a circle with its derivatives by radius.
struct CircleRate {
    double value, slope, bend, by_displacement;
};

CircleRate circle_rate(double radius, double displacement, const contact::SphereOnFlat& sphere) {
    const double E = sphere.contact_modulus, R = sphere.radius;
    const double D = displacement - radius * radius / R;
    const double value = E * D * D / (2.0 * pi * radius);
    // d/da of E D²/(2πa), D' = −2a/R
    const double slope = -value / radius - 2.0 * E * D / (pi * R);
    const double bend = value / (radius * radius) - slope / radius + 4.0 * E * radius / (pi * R * R);
    return {value, slope, bend, E * D / (pi * radius)};
}

}  // namespace

double Machine::displacement_of(const Array1D& edge, const contact::SphereOnFlat& sphere) const {
    if (holds_displacement) return displacement;
    const double E = sphere.contact_modulus;
    return (pull + 2.0 * E * edge.cube().mean() / (3.0 * sphere.radius)) / (stiffness + 2.0 * E * edge.mean());
}

void CircleEquation::elastic_part(const Array1D& edge, const Array1D& bent, Balance& balance) {
    const Index n = edge.size();
    const double E = sphere_.contact_modulus, R = sphere_.radius;
    const double displacement = machine_.displacement_of(edge, sphere_);
    const double mean = edge.mean();
    const auto circle = circle_rate(mean, displacement, sphere_);
    balance.residual.resize(n);
    balance.stiffness.resize(n);
    balance.coupling.resize(n);
    balance.kernel = model_ == FrontModel::constant_toughness ? mean_work_ : circle.value;
    balance.coupling_factor = 0.0;
    const double waves = model_ == FrontModel::variational ? (edge * bent).mean() : 0.0;
    for (Index j = 0; j < n; ++j) {
        const double a = edge[j], D = displacement - a * a / R;
        const double pull = -E * D * std::abs(D) / (2.0 * pi);  // a G_J
        const double slope = 2.0 * E * a * std::abs(D) / (pi * R);
        balance.coupling[j] = std::abs(D);
        switch (model_) {
            case FrontModel::constant_toughness:
            case FrontModel::variational:
                balance.residual[j] = pull + balance.kernel * bent[j] + 0.5 * circle.slope * waves;
                balance.stiffness[j] = slope;
                break;
            case FrontModel::energy_release_rate:
                balance.residual[j] = pull * (1.0 + bent[j] / a);
                balance.stiffness[j] = slope * (1.0 + bent[j] / a) - pull * bent[j] / (a * a);
                break;
            case FrontModel::stress_intensity: {
                const double ratio = 1.0 + 0.5 * bent[j] / a;
                balance.residual[j] = pull * ratio * ratio;
                balance.stiffness[j] = slope * ratio * ratio - pull * ratio * bent[j] / (a * a);
                break;
            }
            case FrontModel::mean_circle:
                balance.residual[j] = circle.value * (mean + bent[j]);
                balance.stiffness[j] = 0.0;
                balance.coupling[j] = 1.0;
                break;
        }
    }
    if (model_ == FrontModel::mean_circle)  // only the mean has a stiffness in addition to that of the waves
        balance.coupling_factor = -(circle.slope * mean + circle.value) / static_cast<double>(n);
    if (machine_.holds_displacement) return;
    balance.coupling_factor = 2.0 * E * E / (pi * static_cast<double>(n) * (machine_.stiffness + 2.0 * E * mean));
}

void CircleEquation::scale_pinning(const Array1D& edge, Array1D& scale) {
    if (model_ == FrontModel::mean_circle) scale = edge.mean() / edge;
}

CircleEquation::Elastic CircleEquation::elastic(const Array1D& edge, double displacement) {
    const double E = sphere_.contact_modulus, R = sphere_.radius, d = displacement;
    Array1D bent;
    elasticity().stiffened(edge, bent);
    const double waves = (edge * bent).mean();
    const double energy = E * (d * d * edge - 2.0 / 3.0 * d * edge.cube() / R + edge.pow(5) / (5.0 * R * R)).mean();
    const double force = 2.0 * E * (d * edge - edge.cube() / (3.0 * R)).mean();
    if (model_ == FrontModel::constant_toughness) return {energy + pi * mean_work_ * waves, force};
    const auto circle = circle_rate(edge.mean(), d, sphere_);
    return {energy + pi * circle.value * waves, force + pi * circle.by_displacement * waves};
}

}  // namespace setae::crack_front
