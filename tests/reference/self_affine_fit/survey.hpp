// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/spectra/self_affine.hpp"
#include "setae/spectra/self_affine_fit.hpp"

namespace setae::reference {

/// A Gaussian self-affine surface with a roll-off at 10 µm and H of 0.5 … 0.9, seen as twins are: four stylus lines of
/// 200 µm, four maps of 20 µm and four of 2 µm, all at places of their own on one surface.
struct Twin {
    spectra::SelfAffine truth;
    spectra::CombinedSpectrum combined;
    spectra::MeasuredSpectrum single;  ///< of the first map of 20 µm, all modes
};
[[nodiscard]] Twin twin(int number);

/// How far fits of such twins are from the truth, and how often their intervals hold it.
struct FitSurvey {
    int fits = 0;
    double mean_error = 0.0, rms_error = 0.0, largest_error = 0.0;      ///< of H
    double mean_standard_error = 0.0;                                   ///< of H as stated
    int hurst_covered = 0, rolloff_covered = 0, amplitude_covered = 0;  ///< 95 % intervals that hold the truth
};
/// Of the combined spectra, with an interval of 95 %.
[[nodiscard]] FitSurvey survey_twins(int twins);
/// Of single maps' own modes: up to a quarter of the highest wavevector, or all of them (these maps are sampled without
/// averaging).
[[nodiscard]] FitSurvey survey_maps(int maps, bool all_modes);

}  // namespace setae::reference
