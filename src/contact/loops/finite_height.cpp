// SPDX-License-Identifier: GPL-3.0-or-later
#include "finite_height.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>
#include <boost/math/interpolators/cardinal_cubic_b_spline.hpp>

#include "branch.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/errors.hpp"

namespace setae::loops {

namespace {

using Spline = boost::math::interpolators::cardinal_cubic_b_spline<double>;

/// JKR's curve on a half-space minus that of a layer at the layer's contact radius, against √(F − F_fold), in which
/// both are smooth, up to the largest force.
class Shift {
public:
    Shift(const contact::layer::Layer& layer, const contact::AdhesiveContact& contact, double largest_force)
        : fold_(contact::layer::pull_off_at_fixed_load(contact, layer).force),
          step_(std::sqrt(std::max(largest_force - fold_, least * std::abs(fold_))) / (points - 1)) {
        const Array1D root = step_ * Array1D::LinSpaced(points, 0.0, points - 1.0);
        Array1D a = contact::layer::contact_radius_at_force(fold_ + root.square(), contact, layer);
        a[0] = contact::layer::pull_off_at_fixed_load(contact, layer).contact_radius;
        std::vector<double> force(points), displacement(points);
        for (int i = 0; i < points; ++i) {
            const auto k = static_cast<std::size_t>(i);
            force[k] = contact::jkr::force(a[i], contact) - contact::layer::force(a[i], contact, layer);
            displacement[k] =
                contact::jkr::displacement(a[i], contact) - contact::layer::displacement(a[i], contact, layer);
        }
        force_ = Spline(force.begin(), force.end(), 0.0, step_);
        displacement_ = Spline(displacement.begin(), displacement.end(), 0.0, step_);
    }

    [[nodiscard]] double force(double at) const { return force_(root(at)); }
    [[nodiscard]] double displacement(double at) const { return displacement_(root(at)); }

private:
    static constexpr int points = 129;
    static constexpr double least = 1e-6;  ///< distance from the fold, where noise puts every force below it

    [[nodiscard]] double root(double force) const {
        return std::min(std::sqrt(std::max(force - fold_, 0.0)), step_ * (points - 1));
    }

    double fold_, step_;
    Spline force_, displacement_;
};

}  // namespace

BranchData as_half_space(const BranchData& data, const contact::layer::Layer& layer,
                         const contact::AdhesiveContact& contact) {
    const Shift shift(layer, contact, data.force.maxCoeff());
    BranchData moved = data;
    for (Index i = 0; i < data.force.size(); ++i) {
        moved.force[i] += shift.force(data.force[i]);
        if (data.displacement.size() > 0) moved.displacement[i] += shift.displacement(data.force[i]);
    }
    return moved;
}

BranchData as_half_space(const BranchData& data, const LensAndCounterBody& bodies, const AnalysisOptions& options) {
    const std::optional<double> height = bodies.soft_height();
    if (!height) return data;
    constexpr int max_rounds = 100;
    constexpr double settled = 1e-10;
    const contact::layer::Layer layer(*height, bodies.lens_poisson_ratio);
    const auto contact_of = [&](const JkrFit& fit) {
        return contact::AdhesiveContact{.radius = bodies.radius,
                                        .contact_modulus = fit.contact_modulus.value,
                                        .work_of_adhesion = std::max(fit.work_of_adhesion.value, 0.0)};
    };
    contact::AdhesiveContact contact = contact_of(primary_fit(data, bodies, options));
    double share = 1.0, last_change = std::numeric_limits<double>::infinity();
    for (int round = 0; round < max_rounds; ++round) {
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
        fmt::format("E* of a soft body {:.3g} m high did not converge in {} rounds", *height, max_rounds));
}

double modulus_excess(double contact_radius, double thickness, double poisson_ratio) {
    const auto factor = contact::layer::Layer(thickness, poisson_ratio).factors(contact_radius);
    return factor.dry_force / std::pow(factor.dry_displacement, 1.5) - 1.0;
}

}  // namespace setae::loops
