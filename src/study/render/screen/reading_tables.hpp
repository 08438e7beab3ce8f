// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/study/study_result.hpp"
#include "setae/tables/tidy_table.hpp"

/// Tables for readers, in the units of the field; numbers by uncertain_number(). Without rows where there is nothing.
namespace setae::output::reading {

/// Spectra of surfaces in a table: that used for all other results, or all of them.
enum class Spectra { used, all };

[[nodiscard]] tables::TidyTable surfaces(const study::StudyResult& result, Spectra spectra);
/// One row per surface and instrument, with the decade of worst agreement.
[[nodiscard]] tables::TidyTable agreement(const study::StudyResult& result);
[[nodiscard]] tables::TidyTable elastomers(const study::StudyResult& result);
[[nodiscard]] tables::TidyTable loops(const study::StudyResult& result);
/// Empty without loops whose contact radius was measured.
[[nodiscard]] tables::TidyTable work_along(const study::StudyResult& result);
[[nodiscard]] tables::TidyTable references(const study::StudyResult& result);
/// Measured and predicted works of adhesion, one row per pair.
[[nodiscard]] tables::TidyTable pairs(const study::StudyResult& result);
/// The works for every spectrum, with raw values, the Persson–Tosatti balance (Eq. S13) and the formation of full
/// contact.
[[nodiscard]] tables::TidyTable all_pairs(const study::StudyResult& result);
/// One row a balance.
[[nodiscard]] tables::TidyTable fits(const study::StudyResult& result);
/// One row a balance, variant and spectrum.
[[nodiscard]] tables::TidyTable all_fits(const study::StudyResult& result);
[[nodiscard]] tables::TidyTable cutoffs(const study::StudyResult& result);

}  // namespace setae::output::reading
