// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::diagnostics {

/// Something wrong with a measurement: what, from which cause, what to do, and how large its effect is in numbers.
struct Finding {
    Alert alert;
    std::vector<Quantity> effects;  ///< the numbers of the message, with units and, where one is known, standard error
};

struct DiagnosisOptions {
    /// Chance that one test finds something in a surface without fault; tests are about ten.
    double false_alarm = 1e-3;
    parallel::Threads threads;
};

/// Everything the tests of docs/reference/diagnostics.md find in one measurement, in the order of that table.
///
/// Heights are looked at as they are; tests that need a level surface remove tilt or parabola from a copy of their own.
/// Undefined heights are left out where a test can, and filled with a line's neighbours where it needs a transform. The
/// tests for spikes, noise and directions compare heights with what Gaussian random surfaces show
/// (docs/reference/diagnostics.md says how often they err).
/// @throws as topography::validate; InvalidArgument for a false_alarm outside (0, 0.5).
/// Cost: linear in points, some twenty passes and a transform of the lines; memory: one more map and its masks.
[[nodiscard]] std::vector<Finding> diagnose(const topography::Measurement& measurement,
                                            const DiagnosisOptions& options = {});

/// What several measurements of one surface say of each other: DISAGREE for pairs whose power spectra differ in their
/// common band by more than their errors. The measurements themselves are not tested: diagnose each.
/// @throws as above; InvalidArgument for fewer than two measurements.
[[nodiscard]] std::vector<Finding> diagnose_overlap(std::span<const topography::Measurement> measurements,
                                                    const DiagnosisOptions& options = {});

}  // namespace setae::diagnostics
