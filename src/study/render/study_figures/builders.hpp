// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/study_figures/study_figures.hpp"

namespace setae::study_figures {

/// A study and the format of its figures.
struct FigureRequest {
    const study::StudyResult& result;
    const GalleryOptions& options;
};

/// Each fills the figure and its caption, or the reason.
void combined_spectra(const FigureRequest& request, StudyFigure& drawn);              // 1
void contact_of_one_elastomer(const FigureRequest& request, StudyFigure& drawn);      // 2
void prediction_and_loss(const FigureRequest& request, StudyFigure& drawn);           // 4
void stylus_scans(const FigureRequest& request, StudyFigure& drawn);                  // S1
void spectra_by_instrument(const FigureRequest& request, StudyFigure& drawn);         // S2
void isotropic_spectra(const FigureRequest& request, StudyFigure& drawn);             // S3
void contact_radius_of_all(const FigureRequest& request, StudyFigure& drawn);         // S5
void contact_radius_of_references(const FigureRequest& request, StudyFigure& drawn);  // S6
void persson_tosatti_prediction(const FigureRequest& request, StudyFigure& drawn);    // S8
void measured_spectra(const FigureRequest& request, const study::SurfaceResult& surface,
                      StudyFigure& drawn);                                          // spectra:NAME
void scales_of_cost(const FigureRequest& request, StudyFigure& drawn);              // scales
void agreement_of_instruments(const FigureRequest& request, StudyFigure& drawn);    // agreement
void budget_of_work(const FigureRequest& request, StudyFigure& drawn);              // budget
void comparison_of_balances(const FigureRequest& request, StudyFigure& drawn);      // balances
void way_back(const FigureRequest& request, StudyFigure& drawn);                    // hysteresis
void shares_of_losses(const FigureRequest& request, StudyFigure& drawn);            // losses
void replicates_of_pairs(const FigureRequest& request, StudyFigure& drawn);         // replicates
void prediction_against_modulus(const FigureRequest& request, StudyFigure& drawn);  // prediction

void loop_of(const study::ExperimentResult& experiment, FigureWidth width, StudyFigure& drawn);  // loop:NAME
void ranges_of_loops(const FigureRequest& request, StudyFigure& drawn);                          // ranges

}  // namespace setae::study_figures
