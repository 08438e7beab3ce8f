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

/// Inputs that all measurements by one instrument share, beyond the sizes that it states itself.
struct InstrumentInputs {
    std::string tip_radius, foil_thickness;  ///< names; empty where nobody named them
    Estimate height_calibration{1.0, 0.0};   ///< true over stated, which the data have been multiplied with
    Estimate lateral_calibration{1.0, 0.0};  ///< likewise
};

/// One measurement of a surface: what was read, done and found, or why it failed.
struct MeasurementResult {
    std::string file;
    std::string name;
    std::string error;                   ///< empty where the measurement was analysed
    std::optional<std::size_t> channel;  ///< that was taken where the file has several of heights and nobody chose
    topography::Trend trend = topography::Trend::none;
    std::vector<processing::StepRecord>
        processing;  ///< what each step of the pipeline did before the trend was removed
    spectra::MeasuredSpectrum spectrum;
    roughness::RealSpaceParameters real_space;
    double arithmetic_height = 0.0;  ///< Ra or Sa [m]; NaN for polylines
    /// Reliable bands with the tip radius one standard error larger and smaller, where it has one.
    std::optional<std::array<Band, 2>> bands_of_uncertain_tip;
    InstrumentInputs inputs;
    std::optional<roughness::SlopeDistribution> slopes;       ///< where there are enough of them
    std::optional<roughness::TriangulatedArea> triangulated;  ///< maps
    std::optional<roughness::WeighedShape> slope_shape;       ///< maps
    std::optional<double> waves_energy_per_modulus;  ///< maps: ¼ Σ |q| |h_q|² over the reliable band of all waves [m]
    HeightPreview preview;
    std::vector<Alert> alerts;

    [[nodiscard]] bool failed() const { return !error.empty(); }
};

/// One spectrum of a surface and what follows from it.
struct SpectrumResult {
    spectra::Spectrum curve;                                        ///< cut to the wavelength limits of the study
    roughness::SpectralParameters parameters;                       ///< by the study's conversion
    std::optional<roughness::SpectralParameters> other_conversion;  ///< by the other one, where the curve is C1D
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

/// The spectrum fitted to all measurements of a surface, as curves, and what the fit knows beside it.
struct FittedSpectrum {
    Band band;                         ///< [1/m] wavevectors that data speak of
    Array1D wavevector;                ///< forty a decade inside the band [1/m]
    Array1D C_iso;                     ///< [m⁴]
    Array1D log_C_iso_standard_error;  ///< of ln C_iso
    Array1D C1D;                       ///< its Abel integral [m³]
    Array1D log_C1D_standard_error;    ///< of ln C1D, the fit's covariance carried through the integral
    std::vector<spectral_fit::Agreement> agreement;
    std::vector<spectral_fit::TipFactor> tips;          ///< one for each group of like measurements by a tip
    std::vector<spectral_fit::SurfaceStretch> stretch;  ///< empty where none is seen
    Array1D C1D_along, C1D_across;  ///< of lines along and across the long direction; empty without [m³]
    int rounds = 0;                 ///< of tip simulations
    bool converged = false;
};

/// A surface: its spectra and what follows from them, or why it failed.
struct SurfaceResult {
    std::string name;
    std::string error;
    bool reconstructed = false;  ///< the spectrum stands for published moments
    std::vector<MeasurementResult> measurements;
    std::optional<spectra::CombinedSpectrum> combined;
    SpectrumMethod method = SpectrumMethod::average;  ///< whose spectrum everything else rests on
    SpectrumResult average;  ///< the mean over measurements; of other surfaces the spectrum given
    std::optional<SpectrumResult>
        likelihood;                        ///< fitted to all measurements at once, where it is wanted and can be had
    std::optional<FittedSpectrum> fitted;  ///< beside `likelihood`
    std::string likelihood_error;          ///< why a likelihood that was wanted gave no numbers
    std::optional<roughness::SlopeShape> slope_shape;   ///< of its maps, by area
    std::optional<roughness::BeyondData> beyond_data;   ///< where the surface's waves go on behind the finest data
    std::optional<roughness::BeyondData> longer_waves;  ///< those up to ten times as long as the longest
    std::vector<Alert> alerts;

    [[nodiscard]] bool failed() const { return !error.empty(); }
    [[nodiscard]] const SpectrumResult& used() const {
        return method == SpectrumMethod::likelihood ? *likelihood : average;
    }
    [[nodiscard]] double area_ratio() const { return used().area_ratio(); }
};

/// What a table says of a surface's spectrum: "average" or "likelihood"; "given" and "moments" where nothing was
/// measured.
[[nodiscard]] std::string method_name(const SurfaceResult& surface, SpectrumMethod method);

/// A spectrum of a surface and how it was found.
struct NamedSpectrum {
    std::string method;
    const SpectrumResult* result;  ///< never null; lives as long as the surface
};
/// All spectra of a surface that did not fail, the one used first.
[[nodiscard]] std::vector<NamedSpectrum> spectra_of(const SurfaceResult& surface);

/// Reads one input and prepares it: instrument and tip from the study, artefact subtracted, steps of its pipeline,
/// heights and lengths calibrated, contour cleaned, trend removed.
/// @throws what reading and preparing throw.
struct PreparedMeasurement {
    topography::Measurement measurement;  ///< heights of maps and scans may be undefined
    topography::Trend trend = topography::Trend::none;
    double direction = 0.0;                         ///< of its lines on the surface [rad]
    std::optional<spectral_fit::Probe> probe = {};  ///< that it was read with, where it is no sphere
    std::optional<spectral_fit::OpticalTransfer> optics = {};
    processing::Untouched untouched = {};  ///< of its waves by the pipeline before
    std::vector<processing::StepRecord> processing = {};
    InstrumentInputs inputs = {};
    std::optional<std::size_t> channel = {};  ///< as MeasurementResult has it
    std::vector<Alert> alerts = {};
};

/// A map by bands of scan lines, as it lies in its file.
struct TiledMeasurement {
    topography::TiledMap map;
    topography::Trend trend = topography::Trend::none;  ///< to be removed
    std::vector<Alert> alerts;
    InstrumentInputs inputs;
    std::optional<std::size_t> channel = {};  ///< as MeasurementResult has it
};

/// A measurement not yet read.
struct MeasurementSource {
    std::function<PreparedMeasurement()> prepare;
    std::optional<TiledMeasurement> tiled;  ///< of maps whose format can be read so
};

/// Whether a map is to be read by bands: its heights take more than options.largest_map bytes.
[[nodiscard]] bool too_large(const MeasurementSource& source, const SurfaceAnalysisOptions& options);
[[nodiscard]] std::vector<MeasurementSource> measurement_sources(const MeasurementInput& input);

/// What is wanted of a surface beside its spectrum.
struct Wanted {
    bool previews = true;    ///< of heights
    bool parameters = true;  ///< from heights
    bool map =
        false;  ///< the heights themselves, where the surface is one map held in memory: then by the average alone
    bool every_measurement = false;  ///< the first failure of one is thrown, in place of a result without it
};

/// Spectrum and real-space parameters of a prepared measurement.
[[nodiscard]] MeasurementResult analyse_measurement(const PreparedMeasurement& prepared,
                                                    const SurfaceAnalysisOptions& options, parallel::Threads threads,
                                                    const Wanted& wanted = {});

/// The same of a map that takes too much memory as a whole, read by bands of at most options.largest_map bytes. What
/// needs all heights at once is left out, which the alert LARGE_MAP tells: slope distribution, triangulated area,
/// arithmetic height.
[[nodiscard]] MeasurementResult analyse_tiled_map(const TiledMeasurement& large, const SurfaceAnalysisOptions& options,
                                                  parallel::Threads threads, const Wanted& wanted = {});

/// Everything about one surface. Never throws for bad data: the failure stands in the result, of the measurement or of
/// the surface, and the rest is done.
[[nodiscard]] SurfaceResult analyse_surface(const SurfaceInput& input, const SurfaceAnalysisOptions& options,
                                            parallel::Threads threads);

/// A surface and its heights, where it is one map held in memory.
struct SurfaceWithMap {
    SurfaceResult surface;
    std::optional<topography::HeightMap> map;
};
/// The same with no more than what is wanted. @throws what failed, where every measurement is wanted.
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
