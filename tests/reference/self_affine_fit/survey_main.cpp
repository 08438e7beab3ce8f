// SPDX-License-Identifier: GPL-3.0-or-later
// How far fits of self-affine surfaces are from what the surfaces are, and how often their intervals hold it: the table
// of docs/concepts/self-affine-fit.md.  self_affine_survey [twins, default 100]
#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>

#include "survey.hpp"

int main(int argc, char** argv) {
    const int count = argc > 1 ? std::atoi(argv[1]) : 100;
    if (count < 1) {
        fmt::print(stderr, "expected a number of twins >= 1\n");
        return 2;
    }
    fmt::print(
        "| fits | mean error of H | rms error | largest | mean standard error | H held | λ_r held | amplitude held |\n|---|---|---|---|---|---|---|---|\n");
    const auto row = [](const char* kind, const setae::reference::FitSurvey& s) {
        fmt::print("| {} {} | {:+.4f} | {:.4f} | {:.3f} | {:.4f} | {} | {} | {} |\n", s.fits, kind, s.mean_error,
                   s.rms_error, s.largest_error, s.mean_standard_error, s.hurst_covered, s.rolloff_covered,
                   s.amplitude_covered);
    };
    row("twins of twelve measurements, combined", setae::reference::survey_twins(count));
    row("maps of 128², modes up to a quarter", setae::reference::survey_maps(count, false));
    row("maps of 128², all modes", setae::reference::survey_maps(count, true));
    return 0;
}
