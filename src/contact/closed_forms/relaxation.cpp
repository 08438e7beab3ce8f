// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact/relaxation.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::contact {
namespace {

void require_valid(const ContactHistory& history, double radius, double contact_modulus,
                   const std::vector<RelaxationTerm>& terms) {
    if (!(radius > 0.0) || !(contact_modulus > 0.0))
        throw InvalidArgument(fmt::format("a sphere of radius {} m and contact modulus {} Pa; expected both > 0",
                                          radius, contact_modulus));
    for (const auto& term : terms)
        if (!(term.share >= 0.0 && std::isfinite(term.share)) || !(term.time > 0.0 && std::isfinite(term.time)))
            throw InvalidArgument(fmt::format(
                "a share of {} that relaxes in {} s; expected a share >= 0 and a time > 0", term.share, term.time));
    for (Index i = 1; i < history.time.size(); ++i)
        if (!(history.time[i] > history.time[i - 1]))
            throw InvalidArgument(fmt::format("time must increase: sample {} at {} s follows {} s", i, history.time[i],
                                              history.time[i - 1]));
}

/// (1 − e^−x)/x.
double mean_decay(double x) { return x < 1e-8 ? 1.0 - 0.5 * x : -std::expm1(-x) / x; }

/// Relaxing part of a course that is linear between its samples: z' = (y − z)/τ, from z = 0 before the first.
Array1D lagging(const Array1D& time, const Array1D& course, double relaxation_time) {
    Array1D lag(time.size());
    if (time.size() > 0) lag[0] = 0.0;
    for (Index i = 1; i < time.size(); ++i) {
        const double x = (time[i] - time[i - 1]) / relaxation_time, decay = std::exp(-x);
        lag[i] = decay * lag[i - 1] + (mean_decay(x) - decay) * course[i - 1] + (1.0 - mean_decay(x)) * course[i];
    }
    return lag;
}

/// 2∫₀^a z dx of one term at every time.
///
/// An element in contact since s has z = D(t) − x²/R − e^(−(t − s)/τ) [D(s) − x²/R], D the relaxing δ. While the
/// contact grows the sum over elements follows the same equation with 2∫u dx; after the turn it has a closed form, with
/// C(a) = ∫₀^a e^((s − T)/τ) [D(s) − x²/R] dx summed once over the loading.
class LaggingElements {
public:
    LaggingElements(const ContactHistory& history, double radius, double relaxation_time, const Array1D& sum)
        : history_(history), radius_(radius), relaxation_time_(relaxation_time) {
        lag_ = lagging(history.time, history.displacement, relaxation_time);
        values_ = lagging(history.time, sum, relaxation_time);
        integrate();
        for (Index i = history.turn + 1; i < values_.size(); ++i) values_[i] = behind_the_turn(i);
    }

    [[nodiscard]] const Array1D& values() const { return values_; }

private:
    [[nodiscard]] double weight(Index i) const {
        const double a = history_.contact_radius[i];
        const double before = std::exp((history_.time[i] - history_.time[history_.turn]) / relaxation_time_);
        return before * (lag_[i] - a * a / radius_);
    }

    /// C at the radii of the loading. Inside the first, all have touched since the jump: D is 0 there.
    void integrate() {
        const Index n = history_.turn + 1;
        integral_ = Array1D(n);
        const double a = history_.contact_radius[0];
        const double before = std::exp((history_.time[0] - history_.time[history_.turn]) / relaxation_time_);
        integral_[0] = -before * a * a * a / (3.0 * radius_);
        for (Index i = 1; i < n; ++i)
            integral_[i] = integral_[i - 1] + 0.5 * (weight(i) + weight(i - 1)) *
                                                  (history_.contact_radius[i] - history_.contact_radius[i - 1]);
    }

    [[nodiscard]] double integral_at(double a) const {
        const auto& radii = history_.contact_radius;
        if (a <= radii[0]) return integral_[0] * std::pow(a / radii[0], 3.0);
        const auto* end = radii.data() + history_.turn + 1;
        const auto upper = std::min<Index>(std::upper_bound(radii.data(), end, a) - radii.data(), history_.turn);
        const double width = radii[upper] - radii[upper - 1];
        if (!(width > 0.0)) return integral_[upper];
        const double share = (a - radii[upper - 1]) / width, slope = weight(upper) - weight(upper - 1);
        return integral_[upper - 1] + width * share * (weight(upper - 1) + 0.5 * share * slope);
    }

    [[nodiscard]] double behind_the_turn(Index i) const {
        const double a = history_.contact_radius[i];
        const double decay = std::exp(-(history_.time[i] - history_.time[history_.turn]) / relaxation_time_);
        return 2.0 * (a * lag_[i] - a * a * a / (3.0 * radius_) - decay * integral_at(a));
    }

    const ContactHistory& history_;
    double radius_, relaxation_time_;
    Array1D lag_, values_, integral_;
};

}  // namespace

Array1D relaxation_force(const ContactHistory& history, double radius, double contact_modulus,
                         const std::vector<RelaxationTerm>& terms) {
    require_valid(history, radius, contact_modulus, terms);
    const auto& a = history.contact_radius;
    const Array1D sum = 2.0 * (a * history.displacement - a.cube() / (3.0 * radius));
    if (terms.empty() || sum.size() == 0) return Array1D::Zero(sum.size());
    const double loading = history.time[history.turn] - history.time[0];
    double shown = 1.0;
    for (const auto& term : terms) shown += term.share * mean_decay(loading / term.time);
    const double relaxed = contact_modulus / shown;
    Array1D force = (relaxed - contact_modulus) * sum;
    for (const auto& term : terms)
        force += relaxed * term.share * (sum - LaggingElements(history, radius, term.time, sum).values());
    return force;
}

double relaxation_loss(const ContactHistory& history, double radius, double contact_modulus,
                       const std::vector<RelaxationTerm>& terms) {
    const Array1D force = relaxation_force(history, radius, contact_modulus, terms);
    double loss = 0.0;
    for (Index i = 1; i < force.size(); ++i)
        loss += 0.5 * (force[i] + force[i - 1]) * (history.displacement[i] - history.displacement[i - 1]);
    return loss;
}

}  // namespace setae::contact
