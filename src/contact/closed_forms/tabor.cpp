// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact/tabor.hpp"

#include <cmath>

#include <fmt/format.h>

#include "domain.hpp"
#include "setae/contact/dmt.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::contact::tabor {
namespace {

/// Largest attraction of a Lennard-Jones law in units of W/z0.
const double lennard_jones_share = 16.0 / (9.0 * std::sqrt(3.0));
const double transition_per_tabor = 2.0 * lennard_jones_share * std::cbrt(9.0 / (16.0 * pi));

constexpr double small_share = 0.05;

Regime regime_of(double force, double tabor_parameter, const AdhesiveContact& contact, double interaction_range) {
    const double pull = -dmt::pull_off(contact).force;
    if (force > 0.0 && pull < small_share * force) return Regime::hertz;
    const double flattened = dmt::displacement_at_force(std::abs(force), contact);
    if (flattened < small_share * interaction_range) return Regime::rigid;
    if (tabor_parameter < 0.1) return Regime::dmt;
    return tabor_parameter > 5.0 ? Regime::jkr : Regime::maugis_dugdale;
}

std::string advice(Regime regime) {
    switch (regime) {
        case Regime::hertz:
            return "adhesion is small against the load: Hertz's model applies and does not give the work of "
                   "adhesion";
        case Regime::rigid:
            return "the bodies deform little over the range of their attraction: they behave as rigid bodies, with "
                   "a pull-off force of 2 pi R W";
        case Regime::dmt:
            return "the range of attraction is much larger than the deformation: the DMT model applies, with a "
                   "pull-off force of 2 pi R W";
        case Regime::maugis_dugdale:
            return "the range of attraction is similar to the deformation: neither JKR nor DMT applies; use "
                   "Maugis-Dugdale, or the transition equation as a fit";
        case Regime::jkr:
            return "the range of attraction is much smaller than the deformation: the JKR model applies, with a "
                   "pull-off force of 3/2 pi R W under a dead load";
    }
    throw InternalError("a regime of adhesion without advice");
}

}  // namespace

double transition_parameter(double tabor_parameter) {
    require_positive(tabor_parameter, "tabor parameter");
    return transition_per_tabor * tabor_parameter;
}

double lennard_jones_stress(double work_of_adhesion, double interaction_range) {
    require_not_negative(work_of_adhesion, "work of adhesion");
    require_positive(interaction_range, "interaction range");
    return lennard_jones_share * work_of_adhesion / interaction_range;
}

Verdict which_model(double force, const AdhesiveContact& contact, double interaction_range) {
    if (!std::isfinite(force)) throw InvalidArgument(fmt::format("force must be finite, got {}", force));
    const double parameter = jkr::tabor_parameter(contact, interaction_range);
    const Regime regime = regime_of(force, parameter, contact, interaction_range);
    return {.regime = regime,
            .tabor_parameter = parameter,
            .transition_parameter = transition_per_tabor * parameter,
            .sentence = fmt::format("Tabor parameter {:.3g} (lambda {:.3g}): {}", parameter,
                                    transition_per_tabor * parameter, advice(regime))};
}

}  // namespace setae::contact::tabor
