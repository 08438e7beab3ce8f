// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "setae/contact/jkr.hpp"
#include "setae/contact/jkr_curve.hpp"
#include "setae/loops/jkr_fits.hpp"

namespace setae::loops {
namespace {

double known(double noise) { return noise > 0.0 ? noise * noise : undefined; }

}  // namespace

EnergyReleaseRate energy_release_rates(const BranchData& data, double radius, double contact_modulus,
                                       double contact_point) {
    return energy_release_rates(data, radius, Estimate{.value = contact_modulus}, Estimate{.value = contact_point});
}

EnergyReleaseRate energy_release_rates(const BranchData& data, double radius, const Estimate& contact_modulus,
                                       const Estimate& contact_point) {
    const contact::SphereOnFlat sphere{.radius = radius, .contact_modulus = contact_modulus.value};
    const Index n = data.force.size();
    EnergyReleaseRate result{.contact_radius = data.contact_radius,
                             .energy_release_rate = Array1D::Constant(n, undefined),
                             .standard_error = Array1D::Constant(n, undefined),
                             .systematic = Array1D::Constant(n, undefined),
                             .radius_measured = data.contact_radius.size() > 0};
    if (!result.radius_measured) result.contact_radius.resize(n);
    const double force_variance = known(data.force_noise), depth_variance = known(data.displacement_noise),
                 radius_variance = known(data.contact_radius_noise);
    for (Index i = 0; i < n; ++i) {
        double& a = result.contact_radius[i];
        const double force = data.force[i];
        if (!result.radius_measured)
            a = contact::jkr::contact_radius_at(force, data.displacement[i] - contact_point.value, sphere);
        if (!(a > 0.0)) continue;
        contact::jkr::EnergyReleaseSlopes rate = contact::jkr::energy_release_slopes(a, force, sphere);
        double variance = 0.0, by_contact_point = 0.0;
        if (result.radius_measured) {
            variance =
                rate.by_force * rate.by_force * force_variance + rate.by_radius * rate.by_radius * radius_variance;
        } else {
            const auto implied =
                contact::jkr::implied_radius_slopes(a, force, data.displacement[i] - contact_point.value, sphere);
            rate.by_force += rate.by_radius * implied.by_force;
            rate.by_modulus += rate.by_radius * implied.by_modulus;
            const double by_depth = rate.by_radius * implied.by_displacement;
            by_contact_point = -by_depth;
            variance = rate.by_force * rate.by_force * force_variance + by_depth * by_depth * depth_variance +
                       2.0 * rate.by_force * by_depth * data.force_displacement_covariance;
        }
        result.energy_release_rate[i] = rate.value;
        result.standard_error[i] = variance < 0.0 ? 0.0 : std::sqrt(variance);  // a rounded-off covariance leaves none
        result.systematic[i] =
            std::hypot(rate.by_modulus * contact_modulus.standard_error,
                       by_contact_point == 0.0 ? 0.0 : by_contact_point * contact_point.standard_error);
    }
    return result;
}

}  // namespace setae::loops
