// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/core/table.hpp"
#include "setae/output/result_folder.hpp"
#include "setae/study/study_result.hpp"
#include "setae/tables/tidy_table.hpp"

namespace setae::output {

/// One row a surface and parameter, SI.
[[nodiscard]] tables::TidyTable surface_table(const study::StudyResult& result);
/// One row a pair: measured and predicted values, SI.
[[nodiscard]] tables::TidyTable pair_table(const study::StudyResult& result);
/// W_int as it is stated and by least squares, one row a fit, SI, with the reported value beside it where there is one.
[[nodiscard]] tables::TidyTable fit_table(const study::StudyResult& result);
/// W_int of the same pairs by every other estimator.
[[nodiscard]] tables::TidyTable work_estimate_table(const study::StudyResult& result);
/// One row a measurement: file, what was done, band, parameters or the error.
[[nodiscard]] tables::TidyTable measurement_table(const study::StudyResult& result);
/// One row a loop and quantity of elastomers whose loops name a lens, a spot or an exclusion; excluded ones with their
/// reason.
[[nodiscard]] tables::TidyTable replicate_table(const study::StudyResult& result);
/// One row a pair and quantity: its mean by the mixed model.
[[nodiscard]] tables::TidyTable replicate_mean_table(const study::StudyResult& result);
/// One row a pair: measured, predicted and their difference in standard errors; the last row is χ² of all.
[[nodiscard]] tables::TidyTable prediction_test_table(const study::StudyResult& result);
/// One row a quoted number and input: what W_int and every prediction rest on, SI.
[[nodiscard]] tables::TidyTable budget_table(const study::StudyResult& result);
/// One row a pair and what was left out: its prediction by the other surfaces, or elastomers, beside what was measured.
[[nodiscard]] tables::TidyTable left_out_table(const study::StudyResult& result);
/// One row a stated input and shift of it: W_int and the likelihood of the pairs with the input taken for exact there.
[[nodiscard]] tables::TidyTable profile_table(const study::StudyResult& result);
/// One row an alert, of everything in the study.
[[nodiscard]] tables::TidyTable alert_table(const study::StudyResult& result);
/// One row a surface and wavevector: cumulative rms parameters and stored energy.
[[nodiscard]] tables::TidyTable cumulative_table(const study::StudyResult& result);
/// One row a loop, cycle, branch and method: every fit.
[[nodiscard]] tables::TidyTable loop_fit_table(const study::StudyResult& result);
/// One row a loop and contact: its energy ledger; and one a cycle.
[[nodiscard]] tables::TidyTable loop_energy_table(const study::StudyResult& result);
/// One row a pair and wavevector: what the roughness above it gains and stores, how it closes and at which pressure.
[[nodiscard]] tables::TidyTable conforming_table(const study::StudyResult& result);
/// One row a balance and choice: how well it says what all pairs measured, over cuts of the spectra and over γ1.
[[nodiscard]] tables::TidyTable balance_table(const study::StudyResult& result);
/// W_int against the short cutoff.
[[nodiscard]] tables::TidyTable cutoff_table(const study::StudyResult& result);

/// One row a measured surface, spectrum and decade: mean of C1D over ln q in the decade.
[[nodiscard]] tables::TidyTable decade_table(const study::StudyResult& result);
/// One row a surface with a fitted spectrum, instrument and decade: measured over expected periodograms.
[[nodiscard]] tables::TidyTable agreement_table(const study::StudyResult& result);
/// One row a surface with a fitted spectrum, group of like measurements by a tip, and wavevector: what the tip does to
/// C1D.
[[nodiscard]] tables::TidyTable tip_factor_table(const study::StudyResult& result);
/// One row a surface whose fitted spectrum found it longer along one direction, and wavevector it holds at.
[[nodiscard]] tables::TidyTable stretch_table(const study::StudyResult& result);
/// A fitted spectrum with standard error and 95 % band.
[[nodiscard]] Table fitted_spectrum_table(const study::FittedSpectrum& fitted);

/// What stands for each surface in the names of its files, in their order: psd_STEM.csv; see file_names().
[[nodiscard]] std::vector<std::string> spectrum_stems(const study::StudyResult& result);

/// Writes study.json, the tables as CSV and each surface's spectrum as NetCDF and CSV into study.output, which is made
/// where missing. Returns the names of the files, each written as a whole.
/// @throws FileError.
std::vector<std::string> write_results(const study::StudyResult& result);
/// The same as part of what a run writes into the folder.
std::vector<std::string> write_results(const study::StudyResult& result, ResultFolder& folder);

}  // namespace setae::output
