// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "setae/fields/describe.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/simulation/loop_simulation.hpp"
#include "setae/validation/comparison.hpp"
#include "setae/validation/summary.hpp"

namespace setae::validation {

struct LoopCoverageOptions {
    int runs = 200;
    std::uint64_t first_seed = 1;
    /// Signals divided by the noise of one sample: largest force by σ_F, displacement from first contact to the largest
    /// force by σ_δ, a_max by σ_a.
    std::vector<double> signal_to_noise{5.0, 10.0, 30.0, 100.0};
    Index samples = 400;  ///< samples of each branch, evenly in displacement; >= 20
    hysteresis::HystereticSphere specimen{
        .radius = 1.25e-3, .contact_modulus = 0.92e6, .work_approach = 0.040, .work_retraction = 0.060};
    double maximum_force = 1e-3;  ///< [N]
    parallel::Threads threads;
    std::function<void(int)> progress;  ///< runs done; one call at a time
};

/// E*, W and the contact point of every route on branches of a known loop with noise of the samples only: loading from
/// the jump-in, unloading from the first motion of the edge to the pull-off under fixed grips.
///
/// Item: "loading", "unloading". Quantity: "E* loading at SNR 5". Methods: those of the fits. A refused fit gives no
/// comparison.
[[nodiscard]] std::vector<Comparison> branch_coverage(const LoopCoverageOptions& options);

/// Whole records of the same loop through loops::analyse(), with free flight and jumps: E*, W of both branches, Eq. S2,
/// contact point and energy loss. Method "analysis". A refused record gives no comparison.
[[nodiscard]] std::vector<Comparison> record_coverage(const LoopCoverageOptions& options);

/// Output of `setae lab loops` without a mechanism.
struct LoopsOutput {
    int runs = 0;
    std::uint64_t first_seed = 0;
    Index samples = 0;
    std::vector<SummaryRow> rows;
};

}  // namespace setae::validation

template <>
struct setae::fields::Described<setae::validation::LoopsOutput> {
    using T = validation::LoopsOutput;
    static constexpr std::array rows{
        field<&T::runs>("runs", "number of loops at each signal-to-noise ratio"),
        field<&T::first_seed>("first_seed", "seed of the first run"),
        field<&T::samples>("samples", "number of samples of each branch"),
        field<&T::rows>("rows", "one entry per quantity and method"),
    };
    static constexpr Description description{"", "fits of simulated loops with known parameters", rows};
};
static_assert(setae::fields::complete<setae::validation::LoopsOutput>);
