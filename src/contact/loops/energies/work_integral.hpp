// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "records/force_zero.hpp"

/// ∫F dδ over sections of a loop, and contributions to its error.
namespace setae::loops {

/// A record with its force counted from its zero.
struct LevelRecord {
    ForceZero zero;
    Array1D force;  ///< [N]
    const Array1D& displacement;
    const Baseline& noise;

    LevelRecord(const Loop& loop, const Segments& segments, DriftModel drift);
};

/// Samples that a contact's energy is counted over: from the last sample of free flight before it to the first after
/// it, between which the force is known not to be zero. Where free flight was not found, the contact's whole extent.
/// @throws UndefinedDataError where the record begins or ends in contact.
[[nodiscard]] IndexRange closed_range(const Segments& segments, Index contact);

/// ∫F dδ by the trapezoid rule, of every so many samples.
[[nodiscard]] double work(const Array1D& force, const Array1D& displacement, const IndexRange& range, Index stride = 1);

/// Error from independent noise of each sample.
[[nodiscard]] double noise_error(const LevelRecord& record, const IndexRange& range);

/// Error from the zero of force and its drift; NaN where the zero is taken as constant.
[[nodiscard]] double drift_error(const LevelRecord& record, const IndexRange& range);

/// Error from the stiffness k of the testing machine where δ = stage − F/k: (F_last² − F_first²) σ_k/(2k²), because the
/// other terms cancel.
[[nodiscard]] double compliance_error(const LevelRecord& record, const IndexRange& range, const Estimate& stiffness);

/// Largest error of a jump. It occurred within its sampling step, a share f of it with the motion before and 1 − f with
/// that after: the error of the chord between the samples is ½ [(1 − f) A_after − f A_before], A the area spanned by
/// jump and motion of one step; for steady motion A (½ − f), uniformly distributed between ± A/2.
[[nodiscard]] double jump_error_limit(const LevelRecord& record, const IndexRange& jump);

/// The trapezoid rule against itself with every second sample, on a smooth piece; signed, so that pieces add up.
[[nodiscard]] double discretisation_error(const LevelRecord& record, const IndexRange& piece);

/// Half the width of the 95 % interval of a normal error and two evenly distributed between ± their limits.
[[nodiscard]] double half_width(double deviation, const std::array<double, 2>& limits);

}  // namespace setae::loops
