// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/core/estimate.hpp"
#include "setae/fields/describe.hpp"
#include "setae/loops/segments.hpp"

namespace setae::loops {

/// One standard deviation of each cause of error of a loop energy [J].
struct LoopErrorBudget {
    double noise = 0.0;  ///< noise of force and displacement, sample by sample
    double drift = 0.0;  ///< error by the zero of force and its drift; NaN without a search for drift
    /// error by the stiffness of the testing machine: 0 over a closed loop, because the spring is elastic
    double compliance = 0.0;
    double sampling = 0.0;        ///< position of the jumps within one sampling step
    double discretisation = 0.0;  ///< error of the trapezoid rule, from a comparison with every second sample
    double total = 0.0;           ///< square root of the sum of squares of the known errors
};

/// Energy lost in a closed loop.
struct LoopEnergy {
    double energy = 0.0;         ///< ∮F dδ [J], force relative to its drifting zero; > 0 is lost
    double without_drift = 0.0;  ///< the energy with the constant zero of the first free flight
    LoopErrorBudget standard_error;
    double opening = 0.0;  ///< displacement at the end minus at the start [m]; free flight, so no energy

    double half_width = 0.0;  ///< half width of the 95 % interval: noise and drift normal, jumps uniformly distributed
                              ///< within their steps

    [[nodiscard]] Estimate estimate() const {
        Estimate found{energy, standard_error.total, "error budget"};
        if (half_width > 0.0) found.interval = Interval{energy - half_width, energy + half_width};
        return found;
    }
};

/// Loss of one contact, ∮F dδ by the trapezoid rule from the last sample of free flight before it to the first after
/// it; in free flight the force is zero.
///
/// The rule is exact along a jump on the testing machine's straight unloading line, and for a vertical jump sampled at
/// both ends; between, it is of second order in the step for a curve sampled evenly in contact radius, and of order 3/2
/// for one sampled evenly in displacement, whose slope diverges at the pull-off under fixed grips.
/// @throws UndefinedDataError without displacement or without return to free flight.
[[nodiscard]] LoopEnergy loop_energy(const Loop& loop, const Segments& segments, Index contact = 0,
                                     DriftModel drift = DriftModel::automatic);

/// ∮F dδ [J] of a partial unloading and reloading, with the error of noise, drift and discretisation: from the reversal
/// to the return to its displacement. Empty without a return.
[[nodiscard]] std::optional<Estimate> partial_loop_energy(const Loop& loop, const Segments& segments, Index cycle,
                                                          DriftModel drift = DriftModel::automatic);

}  // namespace setae::loops

namespace setae::fields {

template <>
struct Described<loops::LoopErrorBudget> {
    using T = loops::LoopErrorBudget;
    static constexpr std::array rows{
        field<&T::noise>("noise", "contribution of the noise of the signals"),
        field<&T::drift>("drift", "contribution of the drift of force"),
        field<&T::compliance>("compliance", "contribution of the stiffness of the testing machine"),
        field<&T::sampling>("sampling", "contribution of the sampling"),
        field<&T::discretisation>("discretisation", "contribution of the discretisation of the integral"),
        made<T>("unit", "unit of the numbers of this object", [](const T&) { return "J"; }),
        inner<&T::total>(),
    };
    static constexpr Description description{"energy_error_budget", "contributions to the standard error of an energy",
                                             rows};
};
static_assert(complete<loops::LoopErrorBudget>);

}  // namespace setae::fields
