// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/roughness/real_space.hpp"
#include "setae/roughness/slope_distribution.hpp"
#include "setae/roughness/spectral_moments.hpp"
#include "setae/roughness/true_area.hpp"
#include "setae/spectra/combination.hpp"
#include "setae/workflow/study.hpp"

namespace setae::workflow {

/// One measurement of a surface: what was read, done and found, or why it failed.
struct MeasurementResult {
    std::string file;
    std::string name;
    std::string error;  ///< empty where the measurement was analysed
    topography::Trend trend = topography::Trend::none;
    spectra::PowerSpectrum1D spectrum;
    roughness::RealSpaceParameters real_space;
    double arithmetic_height = 0.0;  ///< Ra or Sa [m]; NaN for polylines
    /// Reliable bands with the tip radius one standard error larger and smaller, where it has one.
    std::optional<std::array<Band, 2>> bands_of_uncertain_tip;
    std::optional<roughness::SlopeDistribution> slopes;          ///< where there are enough of them
    std::optional<roughness::TriangulatedArea> triangulated;     ///< maps
    std::vector<Alert> alerts;

    [[nodiscard]] bool failed() const { return !error.empty(); }
};

/// How uncertain spectral parameters are, and why: bootstrap replicas, and pairs of values a given ± leads to.
struct ParameterSpread {
    struct Source {
        std::string name;  ///< such as "tip radius"
        roughness::SpectralParameters plus, minus;
    };
    using Function = std::function<double(const roughness::SpectralParameters&)>;

    std::vector<roughness::SpectralParameters> replicas;
    std::vector<Source> sources;

    /// Covariance of two functions of the parameters: between replicas, plus ¼ (f₊ − f₋)(g₊ − g₋) of each source.
    [[nodiscard]] double covariance(const Function& f, const Function& g) const;
    [[nodiscard]] double standard_error(const Function& f) const;
    /// 2.5 and 97.5 % of the replicas, where there are at least 40 and no other source.
    [[nodiscard]] std::optional<Interval> interval(const Function& f) const;
};

/// A surface: its spectrum and what follows from it, or why it failed.
struct SurfaceResult {
    std::string name;
    std::string error;
    bool reconstructed = false;  ///< the spectrum stands for published moments
    std::vector<MeasurementResult> measurements;
    std::optional<spectra::CombinedSpectrum> combined;
    roughness::SpectrumCurve curve;                  ///< cut to the wavelength limits of the study
    roughness::SpectralParameters parameters;        ///< by the study's conversion
    std::optional<roughness::SpectralParameters> other_conversion;  ///< by the other one, where the curve is C1D
    double uncut_energy_per_modulus = 0.0;           ///< U_el/(A E*) without the limits [m]
    ParameterSpread spread;
    std::vector<Alert> alerts;

    [[nodiscard]] bool failed() const { return !error.empty(); }
    [[nodiscard]] double area_ratio() const { return roughness::gaussian_area_ratio(parameters.rms_slope); }
};

/// Reads one input and prepares it: instrument and tip from the study, artefact subtracted, contour cleaned, trend removed.
/// @throws what reading and preparing throw.
struct PreparedMeasurement {
    topography::Measurement measurement;
    topography::Trend trend = topography::Trend::none;
    std::vector<Alert> alerts;
};
[[nodiscard]] std::vector<std::function<PreparedMeasurement()>> prepared_measurements(const MeasurementInput& input);

/// Spectrum and real-space parameters of a prepared measurement.
[[nodiscard]] MeasurementResult analyse_measurement(const PreparedMeasurement& prepared, const AnalysisOptions& options,
                                                    parallel::Threads threads);

/// Everything about one surface. Never throws for bad data: the failure stands in the result, of the measurement or of
/// the surface, and the rest is done.
[[nodiscard]] SurfaceResult analyse_surface(const SurfaceInput& input, const AnalysisOptions& options, parallel::Threads threads);

/// Parameters of a surface with its spectrum cut at other wavelengths.
[[nodiscard]] roughness::SpectralParameters parameters_within(const SurfaceResult& surface, const roughness::WavelengthLimits& limits,
                                                              roughness::Conversion conversion);

}  // namespace setae::workflow
