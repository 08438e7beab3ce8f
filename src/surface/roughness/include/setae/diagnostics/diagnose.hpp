// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::diagnostics {

/// A problem of a measurement: kind, cause, action, and size of its effect in numbers.
struct Finding {
    Alert alert;
    std::vector<Quantity> effects;  ///< the numbers of the message, with units and, if known, standard error
};

struct DiagnosisOptions {
    /// Probability that one test reports a problem for a surface without defects; there are about ten tests.
    double false_alarm = 1e-3;
    parallel::Threads threads;
};

/// All problems found in one measurement by the tests of docs/reference/diagnostics.md, in the order of that table.
///
/// Heights are tested unprocessed; tests that need a level surface remove tilt or parabola from a copy. Undefined
/// heights are left out if possible, and filled from the neighbours in the line for transforms. The tests for spikes,
/// noise and directions compare heights with Gaussian random surfaces (error rates: docs/reference/diagnostics.md).
/// @throws as topography::validate; InvalidArgument for a false_alarm outside (0, 0.5).
/// Cost: linear in points, some twenty passes and a transform of the lines; memory: one more map and its masks.
[[nodiscard]] std::vector<Finding> diagnose(const topography::Measurement& measurement,
                                            const DiagnosisOptions& options = {});

/// Compares several measurements of one surface: DISAGREE for pairs whose power spectra differ in their common band by
/// more than their errors. The measurements are not tested separately (see diagnose).
/// @throws as diagnose; InvalidArgument for fewer than two measurements.
[[nodiscard]] std::vector<Finding> diagnose_overlap(std::span<const topography::Measurement> measurements,
                                                    const DiagnosisOptions& options = {});

}  // namespace setae::diagnostics
