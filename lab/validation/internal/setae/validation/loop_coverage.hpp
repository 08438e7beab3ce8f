// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "setae/parallel/for_each.hpp"
#include "setae/simulation/loop_simulation.hpp"
#include "setae/validation/comparison.hpp"

namespace setae::validation {

struct LoopCoverageOptions {
    int runs = 200;
    std::uint64_t first_seed = 1;
    /// Signals over the noise of one sample: largest force over σ_F, displacement from first touch to the largest force
    /// over σ_δ, a_max over σ_a.
    std::vector<double> signal_to_noise{5.0, 10.0, 30.0, 100.0};
    Index samples = 400;  ///< of each branch, evenly in displacement; >= 20
    hysteresis::HystereticSphere specimen{
        .radius = 1.25e-3, .contact_modulus = 0.92e6, .work_approach = 0.040, .work_retraction = 0.060};
    double maximum_force = 1e-3;  ///< [N]
    parallel::Threads threads;
    std::function<void(int)> progress;  ///< runs done; one call at a time
};

/// E*, W and the contact point of every route on branches of a known loop whose samples alone are noisy: loading from
/// the jump-in, unloading from where the edge lets go to the pull-off under fixed grips.
///
/// Item: "loading", "unloading". Quantity: "E* loading at SNR 5". Methods: the fits'. A fit that was refused gives no
/// comparison.
[[nodiscard]] std::vector<Comparison> branch_coverage(const LoopCoverageOptions& options);

/// Whole records of the same loop through loops::analyse(), free flight, jumps and all: E*, W of both branches, (S2),
/// contact point and energy lost. Method "analysis". A record that was refused gives no comparison.
[[nodiscard]] std::vector<Comparison> record_coverage(const LoopCoverageOptions& options);

}  // namespace setae::validation
