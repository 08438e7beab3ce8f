// SPDX-License-Identifier: GPL-3.0-or-later
#include "finite_height.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "branch.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/errors.hpp"

namespace setae::loops {

BranchData as_half_space(const BranchData& data, const contact::layer::Layer& layer,
                         const contact::AdhesiveContact& contact) {
    const contact::layer::State parting = contact::layer::pull_off_at_fixed_load(contact, layer);
    BranchData moved = data;
    for (Index i = 0; i < data.force.size(); ++i) {
        const double a = data.force[i] > parting.force
                             ? contact::layer::contact_radius_at_force(data.force[i], contact, layer)
                             : parting.contact_radius;
        moved.force[i] += contact::jkr::force(a, contact) - contact::layer::force(a, contact, layer);
        if (data.displacement.size() > 0)
            moved.displacement[i] +=
                contact::jkr::displacement(a, contact) - contact::layer::displacement(a, contact, layer);
    }
    return moved;
}

BranchData as_half_space(const BranchData& data, const LensAndCounterBody& bodies, const AnalysisOptions& options) {
    const std::optional<double> height = bodies.soft_height();
    if (!height) return data;
    constexpr int most_rounds = 100;
    constexpr double settled = 1e-10;
    const contact::layer::Layer layer(*height, bodies.lens_poisson_ratio);
    const auto contact_of = [&](const JkrFit& fit) {
        return contact::AdhesiveContact{.radius = bodies.radius,
                                        .contact_modulus = fit.contact_modulus.value,
                                        .work_of_adhesion = std::max(fit.work_of_adhesion.value, 0.0)};
    };
    contact::AdhesiveContact contact = contact_of(primary_fit(data, bodies, options));
    double share = 1.0, last_change = std::numeric_limits<double>::infinity();
    for (int round = 0; round < most_rounds; ++round) {
        BranchData moved = as_half_space(data, layer, contact);
        const contact::AdhesiveContact next = contact_of(primary_fit(moved, bodies, options));
        const double change = std::abs(next.contact_modulus / contact.contact_modulus - 1.0);
        if (change <= settled) return moved;
        // samples at the fold, where a(F) is vertical, may throw it to and fro
        if (change > 0.5 * last_change) share *= 0.5;
        last_change = change;
        contact.contact_modulus += share * (next.contact_modulus - contact.contact_modulus);
        contact.work_of_adhesion += share * (next.work_of_adhesion - contact.work_of_adhesion);
    }
    throw UndefinedDataError(
        fmt::format("E* of a soft body {:.3g} m high does not settle in {} rounds", *height, most_rounds));
}

double modulus_excess(double contact_radius, double thickness, double poisson_ratio) {
    const auto factor = contact::layer::Layer(thickness, poisson_ratio).factors(contact_radius);
    return factor.dry_force / std::pow(factor.dry_displacement, 1.5) - 1.0;
}

}  // namespace setae::loops
