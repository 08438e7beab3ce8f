// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/validation/causes.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "data_sets.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/bracketing.hpp"
#include "setae/roughness/true_area.hpp"
#include "setae/spectra/combination.hpp"
#include "setae/spectra/segment_response.hpp"
#include "setae/spectra/spectral_density.hpp"
#include "setae/spectral_fit/hat_node.hpp"
#include "setae/spectral_fit/scan_kernel.hpp"
#include "setae/spectral_fit/tip_response.hpp"
#include "surface_quantities.hpp"

namespace setae::validation {
namespace {

using spectra::MeasuredSpectrum;
using spectra::SpectralDensity;

/// Densities of the true surface at any wavevector.
struct TrueDensities {
    SpectralDensity C_iso, C1D;
    double shortest = 0.0;           ///< q_s [1/m]
    double median_wavelength = 0.0;  ///< half of ∫ q C_iso dq is below it [m]
};

TrueDensities densities_of(const simulation::KnownSurface& surface) {
    const Band band = surface.band();
    TrueDensities densities{surface.C_iso, spectra::profile_density(surface.C_iso, {0.01 * band.lower, band.upper}),
                            band.upper, 0.0};
    const double total = spectra::moment(surface.C_iso, 0.0, {1e-3 * band.lower, band.upper});
    const auto below_half = [&](double log_q) {
        return spectra::moment(surface.C_iso, 0.0, {1e-3 * band.lower, std::exp(log_q)}) < 0.5 * total;
    };
    densities.median_wavelength =
        2.0 * pi /
        std::exp(numerics::bisected(below_half, std::log(0.01 * band.lower), std::log(band.upper), 40).second);
    return densities;
}

/// Tips simulated on one surface, by radius.
class Tips {
public:
    explicit Tips(const TrueDensities& densities) : densities_(densities) {}

    const spectral_fit::TipResponse& of(double radius) {
        const auto found = responses_.find(radius);
        if (found != responses_.end()) return found->second;
        constexpr Index points = 1024;
        const auto ball = spectral_fit::sphere({.value = radius});
        const spectral_fit::TipSimulation simulation{
            .probe = ball,
            .step = spectral_fit::simulation_step(ball, densities_.median_wavelength, pi / densities_.shortest, points),
            .points = points,
            .size_response = false,
            .correlation_length = 0.5 * densities_.median_wavelength,
            .threads = {1}};
        return responses_.emplace(radius, spectral_fit::tip_response(densities_.C_iso, simulation)).first->second;
    }

private:
    const TrueDensities& densities_;
    std::map<double, spectral_fit::TipResponse> responses_;
};

/// E[P_k]/C1D(q_k) of only detrending and window, waves up to Nyquist.
Array1D trend_and_window_factor(const ArrayView1D& wavevectors, double pixel_size, int trend_degree,
                                const TrueDensities& densities) {
    const spectral_fit::ScanShape shape{2 * wavevectors.size(), trend_degree};
    const double length = pixel_size * static_cast<double>(shape.points);
    const auto first =
        static_cast<Index>(std::floor(std::log(0.03 * 2.0 * pi / length * pixel_size) / spectral_fit::node_spacing));
    const auto last = static_cast<Index>(
        std::floor(std::log(std::min(pi, densities.shortest * pixel_size)) / spectral_fit::node_spacing));
    const auto kernel = spectral_fit::scan_kernel(shape, first, last, {1});
    const Array1D nodes = (Array1D::LinSpaced(last - first + 1, static_cast<double>(first), static_cast<double>(last)) *
                           spectral_fit::node_spacing)
                              .exp() /
                          pixel_size;
    const Array1D C_iso = nodes.unaryExpr(densities.C_iso);
    Array1D expected = (kernel.response.matrix() * C_iso.matrix()).array() / pixel_size;
    expected += kernel.flat_response * C_iso[0] / pixel_size;
    // the nodes end at Nyquist, where contributions of higher waves are missing; this is not an effect of this cause
    const spectral_fit::ModeBins bins(shape.points / 2);
    const double end = 0.5 * pi / pixel_size;
    Array1D factor = Array1D::Ones(wavevectors.size());
    for (Index b = 0; b < bins.size(); ++b) {
        double plain = 0.0;
        for (Index k = bins.first(b); k <= bins.last(b); ++k)
            plain += densities.C1D(wavevectors[k - 1]) / static_cast<double>(bins.count(b));
        for (Index k = bins.first(b); k <= bins.last(b) && wavevectors[k - 1] < end; ++k)
            factor[k - 1] = expected[b] / plain;
    }
    return factor;
}

Array1D aliasing_factor(const ArrayView1D& wavevectors, double pixel_size, const TrueDensities& densities) {
    constexpr int aliases = 60;
    return wavevectors.unaryExpr([&](double q) {
        double sum = 0.0;
        for (int m = -aliases; m <= aliases; ++m) sum += densities.C1D(std::abs(q + 2.0 * pi * m / pixel_size));
        return sum / densities.C1D(q);
    });
}

/// Expected result of a measurement under some causes: its spectrum with another C1D.
MeasuredSpectrum expected_spectrum(const study::MeasurementResult& measured, const topography::Measurement& data,
                                   const Causes& causes, const TrueDensities& densities, Tips& tips) {
    MeasuredSpectrum spectrum = measured.spectrum;
    const ArrayView1D q = spectrum.wavevector;
    Array1D C1D = q.unaryExpr([&](double x) { return densities.C1D(std::min(x, 0.999 * densities.shortest)); });
    if (const auto* contour = std::get_if<topography::Profile>(&data)) {
        if (causes.segments) {
            const spectra::SegmentResponse segments(contour->positions);
            C1D *= segments.at(q, segments.fitted_exponent(q, spectrum.density));
        }
    } else {
        const double pixel_size = spectrum.length / static_cast<double>(2 * q.size());
        const bool parabola = measured.trend == topography::Trend::parabola;
        Array1D factor = Array1D::Ones(q.size());
        if (causes.trend_and_window) factor *= trend_and_window_factor(q, pixel_size, parabola ? 2 : 1, densities);
        if (causes.aliasing) factor *= aliasing_factor(q, pixel_size, densities);
        const auto& radius = spectrum.metadata.instrument.tip_radius;
        if (causes.tip && radius)
            factor *= spectral_fit::sampled(tips.of(*radius), densities.C1D, pixel_size, q).log_transfer.exp();
        C1D *= factor;
    }
    spectrum.density = C1D;
    return spectrum;
}

/// One measured surface with its data.
struct MeasuredSurface {
    const study::SurfaceResult* result;
    std::vector<topography::Measurement> data;
};

roughness::SpectralParameters mean_reading(const MeasuredSurface& surface, const Causes& causes,
                                           const TrueDensities& densities, Tips& tips) {
    std::vector<MeasuredSpectrum> spectra;
    for (std::size_t i = 0; i < surface.data.size(); ++i)
        spectra.push_back(expected_spectrum(surface.result->measurements[i], surface.data[i], causes, densities, tips));
    return roughness::spectral_parameters(spectra::combine(spectra),
                                          causes.eq11 ? roughness::Conversion::eq11 : roughness::Conversion::exact);
}

/// W_int from these results, from the true W_app of one elastomer and from the true loss.
void add_work(std::vector<Comparison>& rows, const Comparison& like, const roughness::SpectralParameters& found,
              const simulation::TrueSurfaceValues& truth, double work) {
    constexpr double contact_modulus = 1e6, surface_energy = 0.025;
    const double ratio = roughness::gaussian_area_ratio(found.rms_slope), true_ratio = truth.area_ratio;
    const double approach = work * true_ratio - surface_energy * (true_ratio - 1.0) -
                            contact_modulus * truth.parameters.elastic_energy_per_modulus;
    auto row = like;
    row.unit = "J/m2";
    row.measure = Deviation::absolute;
    row.true_value = work;
    row.quantity = "work_of_adhesion";
    row.found.value =
        (approach + surface_energy * (ratio - 1.0) + contact_modulus * found.elastic_energy_per_modulus) / ratio;
    rows.push_back(row);
    row.quantity = "work_of_adhesion_from_loss";
    row.found.value = work * true_ratio / ratio;
    rows.push_back(row);
}

MeasuredSurface measured(const study::Study& study, const study::StudyResult& result, std::size_t index) {
    MeasuredSurface surface{&result.surfaces[index], {}};
    if (surface.result->failed()) throw UndefinedDataError(surface.result->error);
    for (const auto& input : study.surfaces[index].measurements)
        for (const auto& source : study::measurement_sources(input))
            surface.data.push_back(source.prepare().measurement);
    return surface;
}

std::vector<Comparison> readings_of(int run, const simulation::Recipe& recipe, const study::Study& study) {
    std::vector<Comparison> rows;
    const auto result = study::run_study(study, {parallel::Threads{1}});
    for (std::size_t i = 0; i < recipe.surfaces.size(); ++i) {
        const auto& known = recipe.surfaces[i].surface;
        const auto truth = simulation::true_surface_values(known);
        const auto densities = densities_of(known);
        const auto surface = measured(study, result, i);
        Tips tips(densities);
        for (const auto& [name, causes] : all_causes()) {
            const auto found = mean_reading(surface, causes, densities, tips);
            for (const auto& quantity : surface_quantities()) {
                const Comparison row{run,
                                     known.name,
                                     quantity.name,
                                     name,
                                     quantity.unit,
                                     Deviation::relative,
                                     true_value_of(quantity, truth),
                                     {quantity.value(found)}};
                if (std::isfinite(row.true_value) && std::isfinite(row.found.value)) rows.push_back(row);
            }
            add_work(rows, {run, known.name, "", name, "", Deviation::absolute, 0.0, {}}, found, truth,
                     recipe.work_of_adhesion);
        }
    }
    return rows;
}

}  // namespace

std::vector<NamedCauses> all_causes() {
    return {{"none", {}},
            {"segments", {.segments = true}},
            {"trend and window", {.trend_and_window = true}},
            {"aliasing", {.aliasing = true}},
            {"tip", {.tip = true}},
            {"eq. (11)", {.eq11 = true}},
            {"all", {true, true, true, true, true}}};
}

std::vector<Comparison> readings_by_cause(const std::string& recipe, const CausesOptions& options) {
    const DataSets sets{recipe, options.folder,  options.runs,    options.first_seed,
                        false,  options.threads, options.progress};
    std::vector<std::vector<Comparison>> found(static_cast<std::size_t>(std::max(options.runs, 0)));
    for (const auto& failure :
         for_each_data_set(sets, [&](int run, const simulation::Recipe& made, const std::string& folder) {
             auto study = study_of_data_set(folder);
             study.analysis.contours = spectra::ContourTreatment::segments;
             study.analysis.bootstrap_resamples = 0;
             study.experiments.clear();
             found[static_cast<std::size_t>(run)] = readings_of(run, made, study);
         }))
        if (!failure.empty()) throw InvalidArgument(failure);
    std::vector<Comparison> rows;
    for (const auto& run : found) rows.insert(rows.end(), run.begin(), run.end());
    return rows;
}

}  // namespace setae::validation
