// SPDX-License-Identifier: GPL-3.0-or-later
#include "likelihood_spectrum.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "instrument_inputs.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/spectral_fit/likelihood_spectrum.hpp"
#include "setae/spectral_fit/line_spectrum.hpp"

namespace setae::study {
namespace {

/// Groups of modes end a little above the wavevector they are named by.
constexpr double group_end = 1.04;

/// C1D of a fitted C_iso and of draws about it.
class Lines {
public:
    Lines(const spectra::Spectrum& C_iso, const SurfaceAnalysisOptions& options)
        : C_iso_(C_iso),
          C1D_(spectral_fit::line_spectrum(C_iso.wavevector, C_iso.density)),
          limits_(options.limits()) {}

    [[nodiscard]] roughness::DecadeMeans decade_means() const { return means_of(C1D_); }

    /// For a draw, to first order in its ln C_iso: at the end of the data, draws of the prior differ by orders of
    /// magnitude, which would affect C1D below although the data there exclude them.
    ///   ln C1D' = ln C1D + A(C_iso ln(C_iso'/C_iso))/C1D,  A the Abel integral
    [[nodiscard]] roughness::DecadeMeans decade_means(const Array1D& drawn) const {
        const Array1D change =
            spectral_fit::line_spectrum(C_iso_.wavevector, C_iso_.density * (drawn / C_iso_.density).log()) / C1D_;
        return means_of(C1D_ * change.exp());
    }

private:
    [[nodiscard]] roughness::DecadeMeans means_of(const Array1D& C1D) const {
        return roughness::decade_means(roughness::limited({C_iso_.wavevector, C1D, C_iso_.band}, limits_));
    }

    spectra::Spectrum C_iso_;
    Array1D C1D_;
    roughness::WavelengthLimits limits_;
};

/// Standard error of ln C1D. Theta moves ln C_iso along the columns of the design, and C1D is linear in C_iso:
///   ∂ ln C1D/∂θ_k = A(C_iso design_k)/C1D,  A the Abel integral
Array1D log_error_of_lines(const spectral_fit::LikelihoodSpectrum& spectrum, const Array1D& C1D) {
    Eigen::MatrixXd gradient(spectrum.design.rows(), spectrum.design.cols());
    for (Index k = 0; k < gradient.cols(); ++k)
        gradient.col(k) = (spectral_fit::line_spectrum(spectrum.C_iso.wavevector,
                                                       spectrum.C_iso.density * spectrum.design.col(k).array()) /
                           C1D)
                              .matrix();
    return (gradient * spectrum.total_covariance()).cwiseProduct(gradient).rowwise().sum().array().max(0.0).sqrt();
}

FittedSpectrum fitted_spectrum(const spectral_fit::LikelihoodSpectrum& spectrum, const Band& band) {
    const Array1D C1D = spectral_fit::line_spectrum(spectrum.C_iso.wavevector, spectrum.C_iso.density);
    const Array1D error = log_error_of_lines(spectrum, C1D);
    const auto& q = spectrum.C_iso.wavevector;
    const auto first = std::lower_bound(q.begin(), q.end(), band.lower) - q.begin(),
               end = std::upper_bound(q.begin(), q.end(), band.upper) - q.begin();
    const auto inside = [&](const Array1D& values) -> Array1D { return values.segment(first, end - first); };
    const auto lines = [&](const Array1D& C_iso) {
        return C_iso.size() > 0 ? inside(spectral_fit::line_spectrum(q, C_iso)) : Array1D();
    };
    return {band,
            inside(q),
            inside(spectrum.C_iso.density),
            inside(spectrum.log_standard_error),
            inside(C1D),
            inside(error),
            spectrum.agreement,
            spectrum.tips,
            spectrum.stretch,
            lines(spectrum.C_along),
            lines(spectrum.C_across),
            spectrum.rounds,
            spectrum.converged};
}

/// Names of measurements by a tip of unknown radius: their waves are used down to the sampling limit.
std::string without_tip(const SurfaceResult& surface) {
    std::string names;
    for (const auto& m : surface.measurements)
        for (const auto& alert : m.alerts)
            if (alert.code == "NO_TIP_RADIUS" || alert.code == "NO_INSTRUMENT")
                names += (names.empty() ? "" : ", ") + m.name;
    return names;
}

/// @throws UndefinedDataError where a fit has not converged, or determines the surface only within a factor.
void require_numbers(const spectral_fit::LikelihoodSpectrum& spectrum, const SpectrumResult& result,
                     const SurfaceResult& surface) {
    constexpr double max_ratio = 100.0;  // ratio of the ends of a 95 % interval: a factor of ten in both directions
    const auto known = [&](const char* name, const roughness::ParameterSpread::Function& parameter, const char* unit) {
        const auto estimate = result.estimate(parameter);
        const auto interval = interval_of(estimate);
        if (!interval || interval->upper <= max_ratio * std::max(interval->lower, 0.0)) return std::string();
        return fmt::format("leaves {} between {} and {}", name, format_value(interval->lower, unit, 2),
                           format_value(interval->upper, unit, 2));
    };
    auto reason = spectrum.converged
                      ? known(
                            "h_rms", [](const auto& p) { return p.rms_height; }, "m")
                      : fmt::format("stopped after {} steps before reaching its optimum", spectrum.iterations);
    if (reason.empty())
        reason = known(
            "h'_rms", [](const auto& p) { return p.rms_slope; }, "1");
    if (reason.empty()) return;
    const auto names = without_tip(surface);
    throw UndefinedDataError(fmt::format(
        "the fit of C_iso to all measurements {}{}", reason,
        names.empty() ? "; a measurement in a wrong unit can cause this: see the agreement of each instrument"
                      : fmt::format("; the tip of {} is not known, and its shortest waves are used", names)));
}

/// Parameters with each input one standard error larger and smaller: of the changed spectrum, over the changed band.
void add_sources(SpectrumResult& result, const spectral_fit::LikelihoodSpectrum& spectrum,
                 const spectra::Spectrum& curve, const Lines& lines, const SurfaceAnalysisOptions& options) {
    const double end = curve.wavevector[curve.wavevector.size() - 1];
    for (const auto& input : spectrum.inputs) {
        const Array1D change = (spectrum.design * input.theta).array();
        const auto moved = [&](double side) {
            auto other = curve;
            other.density *= (side * change).exp();
            other.band.lower *= std::exp(side * input.log_band.lower);
            other.band.upper = std::min(end, other.band.upper * std::exp(side * input.log_band.upper));
            auto parameters = parameters_of(other, options);
            parameters.decade_C1D = lines.decade_means(other.density);
            return parameters;
        };
        result.spread.sources.push_back({input.input, moved(1.0), moved(-1.0)});
    }
}

constexpr Index min_points = 8;  ///< points of a line whose periodogram contributes to a spectrum

Index points_in_lines(const topography::Measurement& measurement) {
    if (const auto* map = std::get_if<topography::HeightMap>(&measurement)) return map->heights.rows();
    return std::visit([](const auto& line) { return static_cast<Index>(line.heights.size()); }, measurement);
}

}  // namespace

void estimate_by_likelihood(SurfaceResult& surface, std::vector<PreparedMeasurement> prepared,
                            const SurfaceAnalysisOptions& options, parallel::Threads threads) {
    std::vector<spectral_fit::ObservedSurface> observed;
    for (std::size_t i = 0; i < prepared.size(); ++i) {
        if (surface.measurements[i].failed()) continue;
        auto& p = prepared[i];
        if (const auto points = points_in_lines(p.measurement); points < min_points) {
            surface.alerts.push_back(
                {"FEW_POINTS", surface.measurements[i].file,
                 fmt::format(
                     "{} points per line, fewer than {}: the measurement is used in the average, but not in the "
                     "fitted spectrum",
                     points, min_points),
                 "measure with more points, or remove the measurement from the study"});
            continue;
        }
        const auto names = input_names(p, surface.name);
        const auto factor = [](const std::string& name, const Estimate& calibration) {
            return spectral_fit::SharedFactor{name, name.empty() ? 0.0 : relative_error(calibration)};
        };
        observed.push_back({std::move(p.measurement), p.trend, static_cast<int>(p.untouched.trend_degree),
                            p.untouched.band, p.direction, std::move(p.probe), p.optics, names.probe_size,
                            factor(names.height_calibration, p.inputs.height_calibration),
                            factor(names.lateral_calibration, p.inputs.lateral_calibration)});
    }
    auto likelihood = options.likelihood;
    likelihood.seed = options.seed;
    likelihood.threads = threads;
    const auto spectrum = spectral_fit::likelihood_spectrum(observed, likelihood);
    auto curve = spectrum.C_iso;
    curve.band.upper = std::min(curve.wavevector[curve.wavevector.size() - 1], group_end * curve.band.upper);
    auto result = spectrum_result(curve, options);
    const auto unmoved = curve;
    const Lines lines(unmoved, options);
    result.parameters.decade_C1D = lines.decade_means();
    for (auto& limit : result.spread.sources)
        limit.plus.decade_C1D = limit.minus.decade_C1D = result.parameters.decade_C1D;  // whole decades only
    result.spread.seed = options.seed;
    result.spread.replicas_are_draws = true;
    const Array2D drawn =
        spectral_fit::drawn_spectra(spectrum, std::max(options.bootstrap_resamples, 40), options.seed);
    for (Index r = 0; r < drawn.rows(); ++r) {
        curve.density = drawn.row(r).transpose();
        result.spread.replicas.push_back(parameters_of(curve, options));
        result.spread.replicas.back().decade_C1D = lines.decade_means(curve.density);
    }
    add_sources(result, spectrum, unmoved, lines, options);
    for (auto alert : spectrum.alerts) {
        alert.subject = surface.name + ": " + alert.subject;
        surface.alerts.push_back(std::move(alert));
    }
    require_numbers(spectrum, result, surface);
    surface.fitted = fitted_spectrum(spectrum, curve.band);
    surface.likelihood = std::move(result);
    surface.method = SpectrumMethod::likelihood;
}

}  // namespace setae::study
