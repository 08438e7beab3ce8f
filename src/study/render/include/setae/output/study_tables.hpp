// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/core/table.hpp"
#include "setae/output/result_folder.hpp"
#include "setae/study/study_result.hpp"
#include "setae/tables/tidy_table.hpp"

namespace setae::output {

/// One row per surface and parameter, SI.
[[nodiscard]] tables::TidyTable surface_table(const study::StudyResult& result);
/// One row per pair: measured and predicted values, SI.
[[nodiscard]] tables::TidyTable pair_table(const study::StudyResult& result);
/// W_int as reported and by least squares, one row per fit, SI, with the published value where there is one.
[[nodiscard]] tables::TidyTable fit_table(const study::StudyResult& result);
/// W_int of the same pairs by every other estimator.
[[nodiscard]] tables::TidyTable work_estimate_table(const study::StudyResult& result);
/// One row per measurement: file, processing, band, parameters or the error.
[[nodiscard]] tables::TidyTable measurement_table(const study::StudyResult& result);
/// One row per loop and quantity of elastomers whose loops name a lens, a spot or an exclusion; excluded ones with
/// their reason.
[[nodiscard]] tables::TidyTable replicate_table(const study::StudyResult& result);
/// One row per pair and quantity: its mean by the mixed model.
[[nodiscard]] tables::TidyTable replicate_mean_table(const study::StudyResult& result);
/// One row per pair: measured, predicted and their difference in standard errors; the last row is χ² of all.
[[nodiscard]] tables::TidyTable prediction_test_table(const study::StudyResult& result);
/// One row per reported number and input: contributions to W_int and every prediction, SI.
[[nodiscard]] tables::TidyTable budget_table(const study::StudyResult& result);
/// One row per pair and left-out group: its prediction by the other surfaces, or elastomers, and the measured value.
[[nodiscard]] tables::TidyTable left_out_table(const study::StudyResult& result);
/// One row per stated input and shift: W_int and the likelihood of the pairs with the input taken as exact there.
[[nodiscard]] tables::TidyTable profile_table(const study::StudyResult& result);
/// One row per warning of the study.
[[nodiscard]] tables::TidyTable alert_table(const study::StudyResult& result);
/// One row per surface and wavevector: cumulative rms parameters and stored energy.
[[nodiscard]] tables::TidyTable cumulative_table(const study::StudyResult& result);
/// One row per loop, cycle, branch and method: every fit.
[[nodiscard]] tables::TidyTable loop_fit_table(const study::StudyResult& result);
/// One row per loop and contact: its energy budget; and one row per cycle.
[[nodiscard]] tables::TidyTable loop_energy_table(const study::StudyResult& result);
/// One row per pair and wavevector: energy that the roughness above it gains and stores, formation of full contact and
/// the required pressure.
[[nodiscard]] tables::TidyTable full_contact_table(const study::StudyResult& result);
/// One row per balance and choice: agreement with the measured values of all pairs, for cuts of the spectra and for γ1.
[[nodiscard]] tables::TidyTable balance_table(const study::StudyResult& result);
/// W_int against the short cutoff.
[[nodiscard]] tables::TidyTable cutoff_table(const study::StudyResult& result);

/// One row per measured surface, spectrum and decade: mean of C1D over ln q in the decade.
[[nodiscard]] tables::TidyTable decade_table(const study::StudyResult& result);
/// One row per surface with a fitted spectrum, instrument and decade: measured divided by expected periodograms.
[[nodiscard]] tables::TidyTable agreement_table(const study::StudyResult& result);
/// One row per surface with a fitted spectrum, group of similar measurements by a tip, and wavevector: effect of the
/// tip on C1D.
[[nodiscard]] tables::TidyTable tip_factor_table(const study::StudyResult& result);
/// One row per wavevector for each surface whose fitted spectrum is anisotropic.
[[nodiscard]] tables::TidyTable stretch_table(const study::StudyResult& result);
/// A fitted spectrum with standard error and 95 % band.
[[nodiscard]] Table fitted_spectrum_table(const study::FittedSpectrum& fitted);

/// Stems of the file names for each surface, in order: psd_STEM.csv; see file_names().
[[nodiscard]] std::vector<std::string> spectrum_stems(const study::StudyResult& result);

/// Writes study.json, the tables as CSV and each surface's spectrum as NetCDF and CSV into study.output, which is made
/// where missing. Returns the names of the files, each written as a whole.
/// @throws FileError.
std::vector<std::string> write_results(const study::StudyResult& result);
/// The same files as part of the files that a run writes into the folder.
std::vector<std::string> write_results(const study::StudyResult& result, ResultFolder& folder);

}  // namespace setae::output
