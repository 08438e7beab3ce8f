// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/processing/processed.hpp"
#include "setae/processing/untouched.hpp"
#include "setae/roughness/beyond_data.hpp"
#include "setae/roughness/parameter_spread.hpp"
#include "setae/roughness/real_space.hpp"
#include "setae/roughness/slope_distribution.hpp"
#include "setae/roughness/slope_shape.hpp"
#include "setae/roughness/spectral_moments.hpp"
#include "setae/roughness/true_area.hpp"
#include "setae/spectra/combination.hpp"
#include "setae/spectral_fit/likelihood_spectrum.hpp"
#include "setae/study/height_preview.hpp"
#include "setae/study/study.hpp"

namespace setae::study {

/// Inputs that all measurements by one instrument share, in addition to the sizes that it states.
struct InstrumentInputs {
    std::string tip_radius, foil_thickness;  ///< names; empty without names
    Estimate height_calibration{1.0, 0.0};   ///< true divided by stated heights; the data are multiplied by it
    Estimate lateral_calibration{1.0, 0.0};  ///< true divided by stated lengths
};

/// One measurement of a surface: source, processing and results, or the reason of its failure.
struct MeasurementResult {
    std::string file;
    std::string name;
    std::string error;  ///< empty where the measurement was analysed
    /// channel that was taken where the file has several of heights and none is chosen
    std::optional<std::size_t> channel;
    topography::Trend trend = topography::Trend::none;
    std::vector<processing::StepRecord>
        processing;  ///< results of each step of the pipeline before the trend was removed
    spectra::MeasuredSpectrum spectrum;
    roughness::RealSpaceParameters real_space;
    double arithmetic_height = 0.0;  ///< Ra or Sa [m]; NaN for polylines
    /// Reliable bands with the tip radius one standard error larger and smaller, where it has one.
    std::optional<std::array<Band, 2>> bands_of_uncertain_tip;
    InstrumentInputs inputs;
    std::optional<roughness::SlopeDistribution> slopes;       ///< where there are enough slopes
    std::optional<roughness::TriangulatedArea> triangulated;  ///< maps
    std::optional<roughness::WeighedShape> slope_shape;       ///< maps
    std::optional<double> waves_energy_per_modulus;  ///< maps: ¼ Σ |q| |h_q|² over the reliable band of all waves [m]
    HeightPreview preview;
    std::vector<Alert> alerts;

    [[nodiscard]] bool failed() const { return !error.empty(); }
};

/// One spectrum of a surface and the results from it.
struct SpectrumResult {
    spectra::Spectrum curve;                                        ///< cut to the wavelength limits of the study
    roughness::SpectralParameters parameters;                       ///< by the study's conversion
    std::optional<roughness::SpectralParameters> other_conversion;  ///< by the other conversion, where the curve is C1D
    double uncut_energy_per_modulus = 0.0;                          ///< U_el/(A E*) without the limits [m]
    roughness::ParameterSpread spread;

    [[nodiscard]] double area_ratio() const { return parameters.area_ratio(); }
    /// A function of the parameters with its uncertainty; `least` as in ParameterSpread::estimate().
    [[nodiscard]] Estimate estimate(const roughness::ParameterSpread::Function& function, double least = 0.0) const {
        return spread.estimate(function(parameters), function, least);
    }
};

/// Parameters of a whole spectrum within the limits of a study and by its conversion.
/// @throws as roughness::limited and roughness::spectral_parameters (both).
[[nodiscard]] roughness::SpectralParameters parameters_of(spectra::Spectrum whole,
                                                          const SurfaceAnalysisOptions& options);
[[nodiscard]] SpectrumResult spectrum_result(spectra::Spectrum whole, const SurfaceAnalysisOptions& options);

/// The spectrum fitted to all measurements of a surface, as curves, and further results of the fit.
struct FittedSpectrum {
    Band band;                         ///< [1/m] wavevectors of the data
    Array1D wavevector;                ///< forty per decade inside the band [1/m]
    Array1D C_iso;                     ///< [m⁴]
    Array1D log_C_iso_standard_error;  ///< standard error of ln C_iso
    Array1D C1D;                       ///< its Abel integral [m³]
    Array1D log_C1D_standard_error;    ///< standard error of ln C1D, from the fit's covariance through the integral
    std::vector<spectral_fit::Agreement> agreement;
    std::vector<spectral_fit::TipFactor> tips;          ///< one for each group of similar measurements by a tip
    std::vector<spectral_fit::SurfaceStretch> stretch;  ///< empty for an isotropic surface
    /// C1D of lines along and across the long direction; empty for an isotropic surface [m³]
    Array1D C1D_along, C1D_across;
    int rounds = 0;  ///< number of tip simulations
    bool converged = false;
};

/// A surface: its spectra and results, or the reason of its failure.
struct SurfaceResult {
    std::string name;
    std::string error;
    bool reconstructed = false;  ///< whether the spectrum is reconstructed from published moments
    std::vector<MeasurementResult> measurements;
    std::optional<spectra::CombinedSpectrum> combined;
    SpectrumMethod method = SpectrumMethod::average;  ///< method of the spectrum that all other results use
    SpectrumResult average;  ///< the mean over measurements; for other surfaces the given spectrum
    std::optional<SpectrumResult>
        likelihood;                        ///< fitted to all measurements at once, where it is requested and possible
    std::optional<FittedSpectrum> fitted;  ///< in addition to `likelihood`
    std::string likelihood_error;          ///< reason for which a requested likelihood has no results
    std::optional<roughness::SlopeShape> slope_shape;   ///< slope shape of its maps, weighted by area
    std::optional<roughness::BeyondData> beyond_data;   ///< for a surface with waves shorter than the finest data
    std::optional<roughness::BeyondData> longer_waves;  ///< with waves up to ten times as long as the longest
    std::vector<Alert> alerts;

    [[nodiscard]] bool failed() const { return !error.empty(); }
    [[nodiscard]] const SpectrumResult& used() const {
        return method == SpectrumMethod::likelihood ? *likelihood : average;
    }
    [[nodiscard]] double area_ratio() const { return used().area_ratio(); }
};

/// Name of a surface's spectrum in tables: "average" or "likelihood"; "given" and "moments" without measurements.
[[nodiscard]] std::string method_name(const SurfaceResult& surface, SpectrumMethod method);

/// A spectrum of a surface and its method.
struct NamedSpectrum {
    std::string method;
    const SpectrumResult* result;  ///< never null; lives as long as the surface
};
/// All spectra of a surface without failure, the one used first at the beginning.
[[nodiscard]] std::vector<NamedSpectrum> spectra_of(const SurfaceResult& surface);

/// Reads one input and prepares it: instrument and tip from the study, artefact subtracted, steps of its pipeline,
/// heights and lengths calibrated, contour cleaned, trend removed.
/// @throws what reading and preparing throw.
struct PreparedMeasurement {
    topography::Measurement measurement;  ///< heights of maps and scans may be undefined
    topography::Trend trend = topography::Trend::none;
    double direction = 0.0;                         ///< direction of its lines on the surface [rad]
    std::optional<spectral_fit::Probe> probe = {};  ///< probe of the measurement, where it is no sphere
    std::optional<spectral_fit::OpticalTransfer> optics = {};
    processing::Untouched untouched = {};  ///< waves that the pipeline left unchanged
    std::vector<processing::StepRecord> processing = {};
    InstrumentInputs inputs = {};
    std::optional<std::size_t> channel = {};  ///< as in MeasurementResult
    std::vector<Alert> alerts = {};
};

/// A map that is read from its file by bands of scan lines.
struct TiledMeasurement {
    topography::TiledMap map;
    topography::Trend trend = topography::Trend::none;  ///< trend to be removed
    std::vector<Alert> alerts;
    InstrumentInputs inputs;
    std::optional<std::size_t> channel = {};  ///< as in MeasurementResult
};

/// A measurement not yet read.
struct MeasurementSource {
    std::function<PreparedMeasurement()> prepare;
    std::optional<TiledMeasurement> tiled;  ///< for maps whose format can be read by bands
};

/// Whether a map is to be read by bands: its heights need more than options.largest_map bytes.
[[nodiscard]] bool too_large(const MeasurementSource& source, const SurfaceAnalysisOptions& options);
[[nodiscard]] std::vector<MeasurementSource> measurement_sources(const MeasurementInput& input);

/// Requested results of a surface in addition to its spectrum.
struct Wanted {
    bool previews = true;    ///< previews of heights
    bool parameters = true;  ///< parameters from heights
    bool spectrum = true;    ///< spectrum; without it the only parameters are those of one pass over the heights
    bool map = false;  ///< the heights themselves, where the surface is one map in memory: then by the average only
    /// whether the first failure of a measurement is thrown, instead of a result without that measurement
    bool every_measurement = false;
};

/// Spectrum and real-space parameters of a prepared measurement.
[[nodiscard]] MeasurementResult analyse_measurement(const PreparedMeasurement& prepared,
                                                    const SurfaceAnalysisOptions& options, parallel::Threads threads,
                                                    const Wanted& wanted = {});

/// The results of a map that needs too much memory as a whole, read by bands of at most options.largest_map bytes.
/// Results that need all heights at once are left out, with the warning LARGE_MAP: slope distribution, triangulated
/// area, arithmetic height.
[[nodiscard]] MeasurementResult analyse_tiled_map(const TiledMeasurement& large, const SurfaceAnalysisOptions& options,
                                                  parallel::Threads threads, const Wanted& wanted = {});

/// All results of one surface. Never throws for bad data: the failure is stated in the result of the measurement or of
/// the surface, and the rest is done.
[[nodiscard]] SurfaceResult analyse_surface(const SurfaceInput& input, const SurfaceAnalysisOptions& options,
                                            parallel::Threads threads);

/// A surface and its heights, where it is one map in memory.
struct SurfaceWithMap {
    SurfaceResult surface;
    std::optional<topography::HeightMap> map;
};
/// The requested results only. @throws the failure, where every measurement is requested.
[[nodiscard]] SurfaceWithMap analyse_surface(const SurfaceInput& input, const SurfaceAnalysisOptions& options,
                                             const Wanted& wanted, parallel::Threads threads);

/// C_iso of a map by transform.
/// @throws as spectra::isotropic_power_spectrum.
[[nodiscard]] spectra::Spectrum isotropic_spectrum(const topography::HeightMap& map,
                                                   const SurfaceAnalysisOptions& options, parallel::Threads threads);

/// Parameters of a spectrum cut at other wavelengths.
[[nodiscard]] roughness::SpectralParameters parameters_within(const SpectrumResult& spectrum,
                                                              const roughness::WavelengthLimits& limits,
                                                              roughness::Conversion conversion);

}  // namespace setae::study
