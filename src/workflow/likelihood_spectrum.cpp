// SPDX-License-Identifier: GPL-3.0-or-later
#include "likelihood_spectrum.hpp"

#include <algorithm>

#include "setae/core/constants.hpp"
#include "setae/inference/likelihood_spectrum.hpp"
#include "setae/inference/line_spectrum.hpp"

namespace setae::workflow {
namespace {

/// Groups of modes end a little above the wavevector they are named by.
constexpr double group_end = 1.04;

roughness::SpectrumCurve curve_of(const inference::LikelihoodSpectrum& spectrum) {
    const double end = spectrum.wavevector[spectrum.wavevector.size() - 1];
    return {spectrum.wavevector, spectrum.C_iso, {spectrum.band.lower, std::min(end, group_end * spectrum.band.upper)}, roughness::Density::C_iso};
}

roughness::DecadeMeans decade_means(const roughness::SpectrumCurve& C_iso, const AnalysisOptions& options) {
    return roughness::decade_means(roughness::limited({C_iso.wavevector, inference::line_spectrum(C_iso.wavevector, C_iso.values), C_iso.band}, options.limits));
}

}  // namespace

void estimate_by_likelihood(SurfaceResult& surface, std::vector<PreparedMeasurement> prepared, const AnalysisOptions& options,
                            parallel::Threads threads) {
    std::vector<inference::ObservedSurface> observed;
    for (std::size_t i = 0; i < prepared.size(); ++i)
        if (!surface.measurements[i].failed()) observed.push_back({std::move(prepared[i].measurement), prepared[i].trend});
    auto likelihood = options.likelihood;
    likelihood.seed = options.seed;
    likelihood.threads = threads;
    const auto spectrum = inference::likelihood_spectrum(observed, likelihood);
    auto curve = curve_of(spectrum);
    auto result = spectrum_result(curve, options);
    result.parameters.decade_C1D = decade_means(curve, options);
    result.spread.seed = options.seed;
    result.spread.replicas_are_draws = true;
    const Array2D drawn = inference::drawn_spectra(spectrum, std::max(options.bootstrap_resamples, 40), options.seed);
    for (Index r = 0; r < drawn.rows(); ++r) {
        curve.values = drawn.row(r).transpose();
        result.spread.replicas.push_back(parameters_of(curve, options));
        result.spread.replicas.back().decade_C1D = decade_means(curve, options);
    }
    surface.likelihood = std::move(result);
    surface.method = SpectrumMethod::likelihood;
    for (auto alert : spectrum.alerts) {
        alert.subject = surface.name + ": " + alert.subject;
        surface.alerts.push_back(std::move(alert));
    }
}

}  // namespace setae::workflow
