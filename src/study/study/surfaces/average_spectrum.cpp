// SPDX-License-Identifier: GPL-3.0-or-later
#include "average_spectrum.hpp"

#include <algorithm>
#include <set>
#include <string>

#include <fmt/format.h>

#include "instrument_inputs.hpp"
#include "setae/core/errors.hpp"
#include "setae/roughness/mode_noise.hpp"
#include "setae/spectra/bootstrap.hpp"
#include "setae/spectra/jackknife.hpp"
#include "setae/spectra/parametric_noise.hpp"

namespace setae::study {
namespace {

using roughness::SpectralParameters;

std::vector<spectra::MeasuredSpectrum> spectra_of(const std::vector<MeasurementResult>& measurements) {
    std::vector<spectra::MeasuredSpectrum> found;
    for (const auto& m : measurements)
        if (!m.failed()) found.push_back(m.spectrum);
    return found;
}

/// C1D for heights and lengths multiplied by these factors: heights², and C1D of f x is f times that at f q.
void rescale(spectra::MeasuredSpectrum& spectrum, double heights, double lengths) {
    const double power = heights * heights * lengths;
    spectrum.density *= power;
    spectrum.standard_error *= power;
    spectrum.wavevector /= lengths;
    spectrum.band = {spectrum.band.lower / lengths, spectrum.band.upper / lengths};
    spectrum.length *= lengths;
    spectrum.pitch *= lengths;
}

/// Spectra as an input one standard error larger (side 1) or smaller (−1) would leave them: it is shared by the
/// measurements of an instrument, so its error does not average out.
std::vector<spectra::MeasuredSpectrum> with_moved(const SurfaceResult& surface, const std::string& input, double side) {
    std::vector<spectra::MeasuredSpectrum> moved;
    for (const auto& m : surface.measurements) {
        if (m.failed()) continue;
        moved.push_back(m.spectrum);
        const auto names = input_names(m, surface.name);
        if (names.tip_radius == input) moved.back().band = (*m.bands_of_uncertain_tip)[side > 0.0 ? 0 : 1];
        const auto factor = [&](const std::string& name, const Estimate& calibration) {
            return name == input ? 1.0 + side * relative_error(calibration) : 1.0;
        };
        const double heights = factor(names.height_calibration, m.inputs.height_calibration),
                     lengths = factor(names.lateral_calibration, m.inputs.lateral_calibration);
        if (heights != 1.0 || lengths != 1.0) rescale(moved.back(), heights, lengths);
    }
    return moved;
}

/// Names of the uncertain inputs of the average.
std::set<std::string> inputs_of(const SurfaceResult& surface) {
    std::set<std::string> found;
    for (const auto& m : surface.measurements) {
        if (m.failed()) continue;
        const auto names = input_names(m, surface.name);
        found.insert({names.tip_radius, names.height_calibration, names.lateral_calibration});
    }
    found.erase("");
    return found;
}

std::vector<SpectralParameters> resampled_parameters(const spectra::BinnedSpectra& binned, const Band& band,
                                                     const SurfaceAnalysisOptions& options, parallel::Threads threads) {
    spectra::BootstrapOptions bootstrap;
    bootstrap.resamples = options.bootstrap_resamples;
    bootstrap.seed = options.seed;
    bootstrap.weighting = options.weighting;
    bootstrap.threads = threads;
    const auto resampled = spectra::bootstrap(binned, bootstrap);
    std::vector<SpectralParameters> replicas;
    for (Index i = 0; i < resampled.C1D.rows(); ++i)
        replicas.push_back(parameters_of({resampled.wavevector, resampled.C1D.row(i), band}, options));
    return replicas;
}

std::vector<std::vector<SpectralParameters>> parameters_without_each(const spectra::BinnedSpectra& binned,
                                                                     const Band& band,
                                                                     const SurfaceAnalysisOptions& options) {
    const auto without = spectra::jackknife(binned, options.weighting);
    std::vector<std::vector<SpectralParameters>> strata;
    for (const auto& curves : without.C1D) {
        auto& stratum = strata.emplace_back();
        for (Index i = 0; i < curves.rows(); ++i)
            stratum.push_back(parameters_of({without.wavevector, curves.row(i), band}, options));
    }
    return strata;
}

std::vector<roughness::ParameterSpread::Source> parameters_of_moved_bins(const spectra::BinnedSpectra& binned,
                                                                         const Band& band,
                                                                         const SurfaceAnalysisOptions& options) {
    const auto moved = spectra::moved_single_bins(binned, options.weighting);
    std::vector<roughness::ParameterSpread::Source> sources;
    for (Index i = 0; i < moved.plus.rows(); ++i)
        sources.push_back({"", parameters_of({moved.wavevector, moved.plus.row(i), band}, options),
                           parameters_of({moved.wavevector, moved.minus.row(i), band}, options)});
    return sources;
}

/// ν of each wavevector of a measurement by itself: independent lines, and each mode's own share.
Array1D own_freedom(const spectra::MeasuredSpectrum& spectrum) {
    return spectrum.independent_lines * (spectrum.window == "none" ? 1.0 : spectra::share_under_hann);
}

/// Variation between places of the surface, as estimated from one measurement.
void add_parametric_noise(roughness::ParameterSpread& spread, const spectra::MeasuredSpectrum& spectrum,
                          const SurfaceAnalysisOptions& options, parallel::Threads threads) {
    spread.replicas = roughness::parameters_of_noise(spectrum, own_freedom(spectrum),
                                                     {.limits = options.limits(),
                                                      .conversion = options.conversion,
                                                      .count = options.bootstrap_resamples,
                                                      .seed = options.seed,
                                                      .threads = threads});
    spread.replica_method = "parametric noise";
}

}  // namespace

void estimate_by_average(SurfaceResult& surface, const SurfaceAnalysisOptions& options, parallel::Threads threads) {
    const auto found = spectra_of(surface.measurements);
    if (found.empty())
        throw UndefinedDataError(
            fmt::format("none of the {} measurements could be analysed", surface.measurements.size()));
    spectra::CombinationOptions combination;
    combination.weighting = options.weighting;
    surface.combined = spectra::combine(found, combination);
    surface.alerts.insert(surface.alerts.end(), surface.combined->alerts.begin(), surface.combined->alerts.end());
    // a single measurement is used with its own modes: without bins, so sums over them obey Parseval
    const auto spectrum_from = [](const std::vector<spectra::MeasuredSpectrum>& spectra,
                                  const spectra::CombinedSpectrum& combined) -> spectra::Spectrum {
        if (spectra.size() == 1) return spectra::within_band(spectra.front());
        return combined;
    };
    surface.average = spectrum_result(spectrum_from(found, *surface.combined), options);
    auto& spread = surface.average.spread;
    spread.seed = options.seed;
    if (options.bootstrap_resamples > 0) {
        const auto members = spectra::binned(found, combination);
        const auto band = surface.combined->band;
        if (found.size() == 1) add_parametric_noise(spread, found.front(), options, threads);
        else spread.replicas = resampled_parameters(members, band, options, threads);
        spread.left_out = parameters_without_each(members, band, options);
        if (found.size() > 1) spread.single_bins = parameters_of_moved_bins(members, band, options);
    }
    const auto moved = [&](const std::string& input, double side) {
        const auto spectra = with_moved(surface, input, side);
        return parameters_of(spectrum_from(spectra, spectra::combine(spectra, combination)), options);
    };
    for (const auto& input : inputs_of(surface))
        spread.sources.push_back({input, moved(input, 1.0), moved(input, -1.0)});
}

}  // namespace setae::study
