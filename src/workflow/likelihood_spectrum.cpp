// SPDX-License-Identifier: GPL-3.0-or-later
#include "likelihood_spectrum.hpp"

#include <algorithm>

#include "setae/core/constants.hpp"
#include "setae/inference/likelihood_spectrum.hpp"

namespace setae::workflow {
namespace {

/// Groups of modes end a little above the wavevector they are named by.
constexpr double group_end = 1.04;

roughness::SpectrumCurve curve_of(const inference::LikelihoodSpectrum& spectrum) {
    const double end = spectrum.wavevector[spectrum.wavevector.size() - 1];
    return {spectrum.wavevector, spectrum.C_iso, {spectrum.band.lower, std::min(end, group_end * spectrum.band.upper)}, roughness::Density::C_iso};
}

}  // namespace

void estimate_by_likelihood(SurfaceResult& surface, std::span<const PreparedMeasurement> prepared, const AnalysisOptions& options,
                            parallel::Threads threads) {
    std::vector<inference::ObservedSurface> observed;
    for (std::size_t i = 0; i < prepared.size(); ++i)
        if (!surface.measurements[i].failed()) observed.push_back({prepared[i].measurement, prepared[i].trend});
    const auto spectrum = inference::likelihood_spectrum(observed, {.seed = options.seed, .threads = threads});
    auto curve = curve_of(spectrum);
    auto result = spectrum_result(curve, options);
    result.spread.seed = options.seed;
    result.spread.replicas_are_draws = true;
    const Array2D drawn = inference::drawn_spectra(spectrum, std::max(options.bootstrap_resamples, 40), options.seed);
    for (Index r = 0; r < drawn.rows(); ++r) {
        curve.values = drawn.row(r).transpose();
        result.spread.replicas.push_back(parameters_of(curve, options));
    }
    surface.likelihood = std::move(result);
    surface.method = SpectrumMethod::likelihood;
    for (auto alert : spectrum.alerts) {
        alert.subject = surface.name + ": " + alert.subject;
        surface.alerts.push_back(std::move(alert));
    }
}

}  // namespace setae::workflow
