// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/bytes/toml_reader.hpp"
#include "setae/loops/analysis.hpp"
#include "setae/study/loop_models.hpp"

namespace setae::study {

/// How loops are analysed, from the keys of [loops] or of one experiment; what is not there stays as in `defaults`.
///
/// samples_dropped, effective_variance, force_drift, extrapolate_force_drift, displacement_drift, leave_pinned_out,
/// retraction_points, retraction_modulus_free, machine_stiffness, contact_point, baseline_share, contact_radius_noise,
/// interaction_range.
/// @throws FormatError at a key with a value of another kind.
[[nodiscard]] loops::AnalysisOptions read_loop_options(bytes::TomlReader& reader, loops::AnalysisOptions defaults);

/// What is fitted beside JKR's own routes: models, profile, crack_speed, exponent, fit_errors, share.
/// @throws FormatError for a name that is none.
[[nodiscard]] LoopModelOptions read_loop_models(bytes::TomlReader& reader, LoopModelOptions defaults);

/// The same with `segments`, texts of segment edits that belong to one record.
[[nodiscard]] loops::AnalysisOptions read_loop_options_of_record(bytes::TomlReader& reader,
                                                                 const loops::AnalysisOptions& defaults);

}  // namespace setae::study
