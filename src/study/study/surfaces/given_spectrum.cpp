// SPDX-License-Identifier: GPL-3.0-or-later
#include "given_spectrum.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/spectra/admissible_spectra.hpp"
#include "setae/spectra/parametric_noise.hpp"
#include "setae/spectra/self_affine.hpp"
#include "setae/tables/power_spectrum_table.hpp"

namespace setae::study {
namespace {

/// C_iso of a self-affine model as a curve from wavelengths of 1 cm on (longer waves add at most 1e-7 of h_rms²). It is
/// one power law on either side of the roll-off, so nodes there and at the ends are sufficient; more nodes resolve
/// scales.
spectra::Spectrum spectrum_of(const spectra::SelfAffine& model) {
    constexpr Index nodes = 100;  // on each side of the roll-off
    const double lower = 2.0 * pi / 1e-2;
    const auto spaced = [](double from, double to) -> Array1D {
        return (Array1D::LinSpaced(nodes, std::log(from), std::log(to))).exp();
    };
    Array1D q(2 * nodes - 1);
    q << spaced(lower, model.rolloff_wavevector),
        spaced(model.rolloff_wavevector, model.short_wavevector).tail(nodes - 1);
    q[nodes - 1] = model.rolloff_wavevector;
    q[2 * nodes - 2] = model.short_wavevector;
    return {q, spectra::isotropic_power_spectrum(model, q), {lower, model.short_wavevector}, spectra::Density::C_iso};
}

constexpr int min_replicas = 40;

/// Uncertainty by the errors of moments: a moment whose error has a name of its own varies separately, since other
/// surfaces may share it; the others are drawn together, within one spectrum.
void add_stated_errors(SurfaceResult& surface, const PublishedMoments& moments, const SurfaceAnalysisOptions& options) {
    auto& spread = surface.average.spread;
    auto own = moments;
    const auto incomplete = [&](const std::string& what, const InvalidArgument& error) {
        surface.alerts.push_back(
            {"SPREAD_INCOMPLETE", surface.name,
             fmt::format("the ± of {} includes values that no self-affine spectrum has: {}", what, error.what()),
             "give the spectrum itself instead of its moments: the standard errors leave this contribution "
             "out"});
    };
    const auto reconstruct = [](const PublishedMoments& of) {
        return spectrum_of(spectra::self_affine_with_moments(of.rms_height.value, of.rms_slope.value,
                                                             of.rms_curvature.value, of.short_wavevector.value));
    };
    for (auto member : {&PublishedMoments::rms_height, &PublishedMoments::rms_slope, &PublishedMoments::rms_curvature,
                        &PublishedMoments::short_wavevector}) {
        const auto& moment = moments.*member;
        if (moment.input.empty() || !moment.uncertain()) continue;
        (own.*member).standard_error = 0.0;
        const auto moved = [&](double side) {
            auto other = moments;
            (other.*member).value += side * moment.standard_error;
            return parameters_of(reconstruct(other), options);
        };
        try {
            spread.sources.push_back({moment.input, moved(1.0), moved(-1.0)});
        } catch (const InvalidArgument& error) {
            incomplete(moment.input, error);
        }
    }
    if (!own.rms_height.uncertain() && !own.rms_slope.uncertain() && !own.rms_curvature.uncertain() &&
        !own.short_wavevector.uncertain())
        return;
    try {
        const auto drawn =
            spectra::admissible_spectra({own.rms_height, own.rms_slope, own.rms_curvature, own.short_wavevector},
                                        std::max(options.bootstrap_resamples, min_replicas), options.seed);
        for (const auto& model : drawn.draws) spread.replicas.push_back(parameters_of(spectrum_of(model), options));
        spread.replica_method = "admissible spectra";
        spread.seed = options.seed;
        constexpr double nearly_all = 0.9;
        if (drawn.share < nearly_all)
            surface.alerts.push_back(
                {"SPREAD_INCOMPLETE", surface.name,
                 fmt::format(
                     "{:.0f} % of the moments drawn within their ± belong to a self-affine spectrum with 0 < H < 1; "
                     "the standard errors are the scatter of these",
                     100.0 * drawn.share),
                 "give the spectrum itself, with its errors (power_spectrum), instead of its moments"});
    } catch (const InvalidArgument& error) {
        incomplete("its moments", error);
    }
}

}  // namespace

void take_moments(SurfaceResult& surface, const PublishedMoments& moments, const SurfaceAnalysisOptions& options) {
    surface.reconstructed = true;
    surface.average = spectrum_result(
        spectrum_of(spectra::self_affine_with_moments(moments.rms_height.value, moments.rms_slope.value,
                                                      moments.rms_curvature.value, moments.short_wavevector.value)),
        options);
    surface.alerts.push_back(
        {"RECONSTRUCTION", surface.name,
         fmt::format("the spectrum is a self-affine reconstruction from three published moments with the short "
                     "cutoff {:.4g} 1/m",
                     moments.short_wavevector.value),
         "use the stored energy as a model value: only rms height, slope and curvature are fixed by the "
         "data"});
    add_stated_errors(surface, moments, options);
}

namespace {

/// Spectra as likely as the one given, by the standard error of each of its values.
void add_given_errors(roughness::ParameterSpread& spread, const spectra::Spectrum& curve, const Array1D& errors,
                      const SurfaceAnalysisOptions& options) {
    constexpr double max_freedom = 1e12;  // freedom of a value without error
    const Array1D stated = errors.isNaN().select(0.0, errors);
    const Array1D freedom = (curve.density / stated).square().min(max_freedom);
    spectra::MeasuredSpectrum given;
    given.wavevector = curve.wavevector;
    given.density = curve.density;
    const Array2D drawn =
        spectra::parametric_noise(given, freedom, std::max(options.bootstrap_resamples, min_replicas), options.seed);
    auto replica = curve;
    for (Index r = 0; r < drawn.rows(); ++r) {
        replica.density = drawn.row(r).transpose();
        spread.replicas.push_back(parameters_of(replica, options));
    }
    spread.replica_method = "given errors";
    spread.seed = options.seed;
}

}  // namespace

void take_power_spectrum(SurfaceResult& surface, const SurfaceInput& input, const SurfaceAnalysisOptions& options) {
    const auto& file = *input.power_spectrum;
    const auto table = tables::read_power_spectrum_table(file, input.spectrum_units);
    const bool areal = table.find("C_iso") != nullptr;
    const auto& q = table.at("wavevector");
    const spectra::Spectrum curve{q,
                                  table.at(areal ? "C_iso" : "C1D"),
                                  {q[0], q[q.size() - 1]},
                                  areal ? spectra::Density::C_iso : spectra::Density::C1D};
    surface.average = spectrum_result(curve, options);
    const auto* errors = table.find("standard_error");
    const Index without = errors != nullptr ? errors->values.isNaN().count() : q.size();
    if (without < q.size()) add_given_errors(surface.average.spread, curve, errors->values, options);
    if (without > 0)
        surface.alerts.push_back(
            {"SPECTRUM_WITHOUT_ERROR", surface.name,
             fmt::format(
                 "{} has no standard error for {} of its {} values: the ± of all results leave these errors out", file,
                 without, q.size()),
             "fill a third column, standard_error [m3]"});
    const auto alerts = tables::alerts_of(table, surface.name);
    surface.alerts.insert(surface.alerts.end(), alerts.begin(), alerts.end());
}

}  // namespace setae::study
