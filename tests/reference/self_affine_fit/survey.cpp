// SPDX-License-Identifier: GPL-3.0-or-later
#include "survey.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "setae/core/constants.hpp"
#include "setae/numerics/random_numbers.hpp"
#include "setae/spectra/spectral_density.hpp"
#include "setae/synthesis/multiscale.hpp"

namespace setae::reference {
namespace {

double C_iso_at(const spectra::SelfAffine& model, double q) {
    return model.plateau * std::pow(q / model.rolloff_wavevector, -2.0 - 2.0 * model.hurst_exponent);
}

void tally(FitSurvey& survey, const spectra::SelfAffineFit& fit, const spectra::SelfAffine& truth) {
    const double error = fit.hurst_exponent.estimate.value - truth.hurst_exponent;
    const auto holds = [](const Quantity& q, double value) {
        return q.estimate.interval && q.estimate.interval->lower <= value && value <= q.estimate.interval->upper;
    };
    ++survey.fits;
    const double n = survey.fits;
    survey.mean_error += (error - survey.mean_error) / n;
    survey.rms_error = std::sqrt(((n - 1.0) * survey.rms_error * survey.rms_error + error * error) / n);
    survey.largest_error = std::max(survey.largest_error, std::abs(error));
    survey.mean_standard_error += (fit.hurst_exponent.estimate.standard_error - survey.mean_standard_error) / n;
    survey.hurst_covered += holds(fit.hurst_exponent, truth.hurst_exponent);
    survey.rolloff_covered += holds(fit.rolloff_wavelength, 2.0 * pi / truth.rolloff_wavevector);
    survey.amplitude_covered += holds(fit.amplitude, C_iso_at(truth, fit.reference_wavevector));
}

}  // namespace

Twin twin(int number) {
    constexpr double um = 1e-6;
    Twin result;
    result.truth = {1e-26, 2.0 * pi / (10.0 * um), 0.5 + 0.1 * (number % 5), 2.0 * pi / 4e-9};
    const synthesis::MultiscaleSurface surface(spectra::density(result.truth),
                                               {.key = numerics::substream({77, 0}, static_cast<std::uint64_t>(number)),
                                                .longest_wavelength = 1000.0 * um,
                                                .shortest_wavelength = 4e-9});
    std::vector<spectra::MeasuredSpectrum> spectra;
    spectra::SpectrumOptions options;
    options.trend = topography::Trend::tilt;
    for (int k = 0; k < 4; ++k) {
        const double place = (1.0 + k) * 300.0 * um;
        auto line = surface.line({.x = place, .y = -place, .direction = 0.0, .points = 2000, .step = 0.1 * um});
        line.metadata.instrument.type = "stylus";
        spectra.push_back(spectra::undistorted(spectra::power_spectrum(line, options)));
        for (const double size : {20.0 * um, 2.0 * um}) {
            auto map =
                surface.window({.x = place, .y = place + 100.0 * um, .nx = 128, .ny = 128, .pixel_size = size / 128.0});
            map.metadata.instrument.type = size > 10.0 * um ? "optical" : "afm";
            auto spectrum = spectra::power_spectrum(map, options);
            spectra.push_back(spectra::undistorted(spectrum));
            if (k == 0 && size > 10.0 * um) {
                spectrum.band.lower *= 2.0;  // the trend takes the first mode
                result.single = std::move(spectrum);
            }
        }
    }
    result.combined = spectra::combine(spectra);
    return result;
}

FitSurvey survey_twins(int twins) {
    FitSurvey survey;
    for (int number = 0; number < twins; ++number) {
        const auto t = twin(number);
        tally(survey, spectra::fit_self_affine(t.combined), t.truth);
    }
    return survey;
}

FitSurvey survey_maps(int maps, bool all_modes) {
    FitSurvey survey;
    for (int number = 0; number < maps; ++number) {
        const auto t = twin(number);
        spectra::SelfAffineFitOptions options;
        if (all_modes) options.range = Band{t.single.band.lower, t.single.band.upper};
        tally(survey, spectra::fit_self_affine(t.single, options), t.truth);
    }
    return survey;
}

}  // namespace setae::reference
