// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Surfaces, their spectra and measurements, as the JSON of a study has them.

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "json_support.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/statistics.hpp"
#include "setae/fields/describe.hpp"
#include "setae/output/json.hpp"
#include "setae/output/quantity_rows.hpp"
#include "setae/output/step_fields.hpp"
#include "setae/roughness/beyond_data.hpp"
#include "setae/study/surface_analysis.hpp"

namespace setae::output {

/// A measurement that was analysed.
struct AnalysedMeasurement {
    const study::MeasurementResult* measurement;
};

/// A measurement, or why it failed.
struct MeasurementEntry {
    const study::MeasurementResult* measurement;
};

/// Parameters of a surface by one spectrum.
struct SpectrumOfSurface {
    const study::SurfaceResult* surface;
    const study::SpectrumResult* spectrum;
    const study::SurfaceAnalysisOptions* options;

    [[nodiscard]] bool exact() const { return options->conversion == roughness::Conversion::exact; }
    [[nodiscard]] double energy_cut() const {
        return 1.0 - spectrum->parameters.elastic_energy_per_modulus / spectrum->uncut_energy_per_modulus;
    }
};

/// Parameters of the same spectrum by the conversion that the study does not use.
struct OtherConversion {
    const roughness::SpectralParameters* parameters;
    std::string_view source;

    [[nodiscard]] Quantity of(double value) const {
        return {.estimate = {.value = value}, .source = std::string(source)};
    }
};

/// Agreement of an instrument with the fitted spectrum in a decade.
struct DecadeAgreement {
    const spectral_fit::Agreement* row;

    [[nodiscard]] Band band() const { return {std::pow(10.0, row->decade), std::pow(10.0, row->decade + 1)}; }
};

/// A number with its standard error and unit.
struct ValueAndError {
    double value = 0.0, standard_error = 0.0;
    std::string_view unit;
};

/// Curves of a fitted spectrum.
struct FittedCurves {
    const study::FittedSpectrum* fitted;

    static constexpr double level = 0.95;  ///< of the bands
    [[nodiscard]] static Array1D factor(const Array1D& log_error) {
        return (normal_quantile(0.5 * (1.0 + level)) * log_error).exp();
    }
};

/// A surface that was analysed.
struct AnalysedSurface {
    const study::SurfaceResult* surface;
    const study::SurfaceAnalysisOptions* options;

    [[nodiscard]] std::vector<std::pair<std::string, SpectrumOfSurface>> spectra() const {
        std::vector<std::pair<std::string, SpectrumOfSurface>> all;
        if (!surface->likelihood) return all;
        for (const auto& [method, spectrum] : study::spectra_of(*surface))
            all.emplace_back(method, SpectrumOfSurface{surface, spectrum, options});
        return all;
    }
};

/// A surface, or why it failed; its measurements are added later. spectrum_file: empty where there is none.
struct SurfaceEntry {
    const study::SurfaceResult* surface;
    const study::SurfaceAnalysisOptions* options;
    std::string spectrum_file;
};

/// A text, where it is not empty.
[[nodiscard]] inline std::optional<std::string> where_given(const std::string& text) {
    if (text.empty()) return std::nullopt;
    return text;
}

}  // namespace setae::output

namespace setae::fields {

template <>
struct Described<output::AnalysedMeasurement> {
    using T = output::AnalysedMeasurement;
    static constexpr std::array possible_rows{
        possible("rms_height", "Sq", "m", "rms height: Sq of a map, Rq of a line").as("areal_rms_height"),
        possible("rms_height", "Rq", "m", "rms height: Sq of a map, Rq of a line").as("profile_rms_height"),
        possible("rms_height_of_lines", "Rq", "m", "rms height of the lines of a map, each about its own mean"),
        possible("arithmetic_height", "Sa", "m", "mean absolute height: Sa of a map, Ra of a line")
            .as("areal_arithmetic_height"),
        possible("arithmetic_height", "Ra", "m", "mean absolute height: Sa of a map, Ra of a line")
            .as("profile_arithmetic_height"),
        possible("rms_slope_x", "Rdq", "1", "rms slope of a map along x"),
        possible("rms_slope", "Sdq", "1", "rms slope: Sdq of a map, Rdq of a line").as("areal_rms_slope"),
        possible("rms_slope", "Rdq", "1", "rms slope: Sdq of a map, Rdq of a line").as("profile_rms_slope"),
        possible("rms_curvature", "lap/2", "1/m", "rms curvature: half the rms Laplacian of a map, Rddq of a line")
            .as("areal_rms_curvature"),
        possible("rms_curvature", "Rddq", "1/m", "rms curvature: half the rms Laplacian of a map, Rddq of a line")
            .as("profile_rms_curvature"),
        possible("triangulated_area_ratio", "A_true/A_app", "1", "true area over nominal area from triangles"),
        possible("elastic_energy_per_modulus_of_waves", "U_el/(A_app E*)", "m",
                 "elastic energy from the waves of a map in all directions"),
        possible("slope_excess_kurtosis", "kurt - 3", "1", "excess kurtosis of slopes along x"),
        possible("slope_gaussian_p_value", "p", "1", "p-value of Gaussian slopes"),
        possible("slope_isotropy_ratio", "s_max/s_min", "1", "ratio of the rms slopes of perpendicular directions"),
    };
    static constexpr Description possible_quantities{"", "quantities of a measurement", possible_rows};
    static constexpr std::array rows{
        made<T>("instrument", "kind of instrument, or its name where the kind is not known",
                [](const T& of) -> const std::string& {
                    const auto& instrument = of.measurement->spectrum.metadata.instrument;
                    return instrument.type.empty() ? instrument.name : instrument.type;
                }),
        made<T>("format", "file format",
                [](const T& of) -> const std::string& { return of.measurement->spectrum.metadata.format; }),
        made<T>("channel", "number of the channel that was chosen where the file has several",
                [](const T& of) { return of.measurement->channel; }),
        made<T>("processing", "processing steps that were applied",
                [](const T& of) -> const auto& { return of.measurement->processing; })
            .with(Missing::left_out),
        made<T>("trend_removed", "trend that was removed: `none`, `mean`, `tilt` or `parabola`",
                [](const T& of) { return topography::name(of.measurement->trend); }),
        made<T>("window", "window of the Fourier transform",
                [](const T& of) -> const std::string& { return of.measurement->spectrum.window; }),
        made<T>("band", "reliable band of wavevectors",
                [](const T& of) -> const Band& { return of.measurement->spectrum.band; }),
        quantities_among<T>(possible_quantities,
                            [](const T& of) { return output::measurement_quantities(*of.measurement); }),
        made<T>("alerts", "warnings on the measurement",
                [](const T& of) -> const auto& { return of.measurement->alerts; }),
    };
    static constexpr Description description{"", "an analysed measurement", rows};
};

template <>
struct Described<output::MeasurementEntry> {
    using T = output::MeasurementEntry;
    static constexpr std::array rows{
        made<T>("file", "path of the file as named in the study",
                [](const T& of) -> const std::string& { return of.measurement->file; }),
        made<T>("name", "name of the measurement",
                [](const T& of) -> const std::string& { return of.measurement->name; }),
        made<T>("error", "the reason for the failure; no further field then",
                [](const T& of) { return output::where_given(of.measurement->error); }),
        fields_of<T>([](const T& of) -> std::optional<output::AnalysedMeasurement> {
            if (of.measurement->failed()) return std::nullopt;
            return output::AnalysedMeasurement{of.measurement};
        }),
    };
    static constexpr Description description{"measurement", "a measurement of a surface", rows};
};

template <>
struct Described<output::OtherConversion> {
    using T = output::OtherConversion;
    static constexpr std::array rows{
        made<T>("rms_height", "h_rms", "m", "rms height", [](const T& p) { return p.of(p.parameters->rms_height); }),
        made<T>("rms_slope", "h'_rms", "1", "rms slope", [](const T& p) { return p.of(p.parameters->rms_slope); }),
        made<T>("rms_curvature", "h''_rms", "1/m", "rms curvature",
                [](const T& p) { return p.of(p.parameters->rms_curvature); }),
        made<T>("elastic_energy_per_modulus", "U_el/(A_app E*)", "m", "elastic energy per nominal area over E*",
                [](const T& p) { return p.of(p.parameters->elastic_energy_per_modulus); }),
    };
    static constexpr Description description{"other_conversion", "parameters by the other conversion of C1D", rows};
};

template <>
struct Described<output::SpectrumOfSurface> {
    using T = output::SpectrumOfSurface;
    static constexpr Description possible_quantities{"", "quantities of a spectrum", output::surface_quantity_rows};
    static constexpr std::array rows{
        quantities_among<T>(
            possible_quantities,
            [](const T& of) { return output::surface_quantities(*of.surface, *of.spectrum, of.options->conversion); })
            .with(Missing::never),
        made<T>("decades", "mean of C1D over each decade of wavevectors",
                [](const T& of) { return output::decade_quantities(*of.surface, *of.spectrum); })
            .with(Missing::left_out),
        made<T>("conversion", "conversion of C1D to parameters of the surface: `exact` or `eq11`",
                [](const T& of) { return std::string_view(of.exact() ? "exact" : "eq11"); }),
        made<T>("other_conversion", "parameters by the other conversion",
                [](const T& of) -> std::optional<output::OtherConversion> {
                    if (!of.spectrum->other_conversion) return std::nullopt;
                    return output::OtherConversion{&*of.spectrum->other_conversion,
                                                   of.exact() ? output::eq11_source : output::exact_source};
                }),
        made<T>("energy_cut_by_limits", "1 - U_el/U_el,uncut", "1",
                "share of the stored energy outside the wavelength limits of the study",
                [](const T& of) { return of.energy_cut(); })
            .from("share of the stored energy outside longest_wavelength … shortest_wavelength"),
    };
    static constexpr Description description{"spectrum", "parameters of a surface by one spectrum", rows};
};

template <>
struct Described<output::DecadeAgreement> {
    using T = output::DecadeAgreement;
    static constexpr std::array rows{
        made<T>("instrument", "name of the instrument",
                [](const T& of) -> const std::string& { return of.row->instrument; }),
        made<T>("band", "decade of wavevectors", [](const T& of) { return of.band(); }),
        made<T>("ratio", "measured over fitted spectrum", [](const T& of) { return of.row->ratio; }),
        made<T>("ratio_standard_error", "standard error of the ratio",
                [](const T& of) { return of.row->standard_error; }),
        made<T>("chi_squared", "χ² of the groups of the decade", [](const T& of) { return of.row->chi_squared; }),
        made<T>("groups", "number of groups: degrees of freedom", [](const T& of) { return of.row->groups; }),
        made<T>("probability", "probability of a χ² at least as large",
                [](const T& of) { return of.row->probability; }),
    };
    static constexpr Description description{"", "agreement of an instrument with the fitted spectrum", rows};
};

template <>
struct Described<output::ValueAndError> {
    using T = output::ValueAndError;
    static constexpr std::array rows{
        field<&T::value>("value", "the value"),
        field<&T::standard_error>("standard_error", "one standard deviation"),
        field<&T::unit>("unit", "unit of value and standard error"),
    };
    static constexpr Description description{"value_and_error", "a number with its standard error", rows};
};
static_assert(complete<output::ValueAndError>);

template <>
struct Described<spectral_fit::SurfaceStretch> {
    using T = spectral_fit::SurfaceStretch;
    static constexpr double degree = pi / 180.0;
    static constexpr std::array rows{
        value<&T::wavevector>("wavevector", "1/m", "wavevector at which the values hold"),
        made<T>("stretch", "length of features along over across their long axis",
                [](const T& of) {
                    return output::ValueAndError{of.ratio.value, of.ratio.standard_error, "1"};
                }),
        made<T>(
            "direction", "direction of the long axis against the x axis of the lines",
            [](const T& of) {
                return output::ValueAndError{of.direction.value / degree, of.direction.standard_error / degree, "deg"};
            }),
        inner<&T::ratio>(),
        inner<&T::direction>(),
    };
    static constexpr Description description{"stretch", "anisotropy of a surface at a wavevector", rows};
};
static_assert(complete<spectral_fit::SurfaceStretch>);

template <>
struct Described<spectral_fit::TipFactor> {
    using T = spectral_fit::TipFactor;
    static constexpr std::array rows{
        field<&T::instrument>("instrument", "name of the instrument"),
        field<&T::probe>("probe", "shape and size of the probe, such as `sphere, 10 nm`"),
        value<&T::size>("size", "m", "radius of the apex, or thickness of the foil"),
        value<&T::wavevector>("wavevector", "1/m", "wavevectors of the factors"),
        value<&T::transfer>("transfer", "1", "measured over true power"),
    };
    static constexpr Description description{"", "power that tip or foil transmits", rows};
};
static_assert(complete<spectral_fit::TipFactor>);

template <>
struct Described<output::FittedCurves> {
    using T = output::FittedCurves;
    static constexpr std::array rows{
        made_value<T>("wavevector", "1/m", "wavevectors of the curves",
                      [](const T& of) -> const Array1D& { return of.fitted->wavevector; }),
        made_value<T>("C_iso", "m4", "isotropic spectrum",
                      [](const T& of) -> const Array1D& { return of.fitted->C_iso; }),
        made_value<T>("C_iso_standard_error", "m4", "standard error of C_iso",
                      [](const T& of) -> Array1D { return of.fitted->C_iso * of.fitted->log_C_iso_standard_error; }),
        made_value<T>(
            "C_iso_low", "m4", "lower end of the band of C_iso",
            [](const T& of) -> Array1D { return of.fitted->C_iso / T::factor(of.fitted->log_C_iso_standard_error); }),
        made_value<T>(
            "C_iso_high", "m4", "upper end of the band of C_iso",
            [](const T& of) -> Array1D { return of.fitted->C_iso * T::factor(of.fitted->log_C_iso_standard_error); }),
        made_value<T>("C1D", "m3", "spectrum of lines", [](const T& of) -> const Array1D& { return of.fitted->C1D; }),
        made_value<T>("C1D_standard_error", "m3", "standard error of C1D",
                      [](const T& of) -> Array1D { return of.fitted->C1D * of.fitted->log_C1D_standard_error; }),
        made_value<T>(
            "C1D_low", "m3", "lower end of the band of C1D",
            [](const T& of) -> Array1D { return of.fitted->C1D / T::factor(of.fitted->log_C1D_standard_error); }),
        made_value<T>(
            "C1D_high", "m3", "upper end of the band of C1D",
            [](const T& of) -> Array1D { return of.fitted->C1D * T::factor(of.fitted->log_C1D_standard_error); }),
        made_value<T>("C1D_along", "m3", "spectrum of lines along the long axis of an anisotropic surface",
                      [](const T& of) -> const Array1D& { return of.fitted->C1D_along; })
            .with(Missing::left_out),
        made_value<T>("C1D_across", "m3", "spectrum of lines across the long axis of an anisotropic surface",
                      [](const T& of) -> const Array1D& { return of.fitted->C1D_across; })
            .with(Missing::left_out),
        made<T>("level", "probability that a band covers the spectrum at a wavevector",
                [](const T&) { return T::level; }),
    };
    static constexpr Description description{"", "curves of a fitted spectrum", rows};
};

template <>
struct Described<study::FittedSpectrum> {
    using T = study::FittedSpectrum;
    static constexpr std::array rows{
        field<&T::band>("band", "wavevectors inside which there are data"),
        field<&T::rounds>("rounds", "number of rounds of tip simulations"),
        field<&T::converged>("converged", "whether the fit converged"),
        made<T>("agreement", "agreement of each instrument with the fitted spectrum in each decade",
                [](const T& of) {
                    std::vector<output::DecadeAgreement> all;
                    for (const auto& row : of.agreement) all.push_back({&row});
                    return all;
                }),
        field<&T::tips>("tip_factors", "power that tips and foils transmit"),
        field<&T::stretch>("stretch", "anisotropy against the wavevector"),
        made<T>("spectrum", "curves of the fitted spectrum", [](const T& of) { return output::FittedCurves{&of}; }),
        inner<&T::wavevector>(),
        inner<&T::C_iso>(),
        inner<&T::log_C_iso_standard_error>(),
        inner<&T::C1D>(),
        inner<&T::log_C1D_standard_error>(),
        inner<&T::agreement>(),
        inner<&T::C1D_along>(),
        inner<&T::C1D_across>(),
    };
    static constexpr Description description{"fitted_spectrum", "a spectrum fitted to all measurements of a surface",
                                             rows};
};
static_assert(complete<study::FittedSpectrum>);

template <>
struct Described<roughness::BeyondData> {
    using T = roughness::BeyondData;
    static constexpr std::array rows{
        quantity<&T::end>("end_of_data", "q_e", "1/m", "wavevector at the end of the data"),
        quantity<&T::up_to>("end_of_waves", "q_s", "1/m", "wavevector at the end of the continued spectrum"),
        quantity<&T::exponent>("exponent", "p", "1", "exponent of the continued C_iso").as("spectrum_exponent"),
        quantity<&T::rms_height>("rms_height", "h_rms", "m", "rms height with the continued spectrum"),
        quantity<&T::rms_slope>("rms_slope", "h'_rms", "1", "rms slope with the continued spectrum"),
        quantity<&T::excess_area>("excess_area", "A_true/A_app - 1", "1",
                                  "true area over nominal area minus 1, with the continued spectrum"),
        quantity<&T::elastic_energy_per_modulus>(
            "elastic_energy_per_modulus", "U_el/(A_app E*)", "m",
            "elastic energy per nominal area over E*, with the continued spectrum"),
    };
    static constexpr Description description{
        "continuation", "parameters of a surface if its spectrum continues beyond the data as it ends", rows};
};
static_assert(complete<roughness::BeyondData>);

template <>
struct Described<output::AnalysedSurface> {
    using T = output::AnalysedSurface;
    static constexpr std::array rows{
        fields_of<T>([](const T& of) {
            return output::SpectrumOfSurface{of.surface, &of.surface->used(), of.options};
        }),
        made<T>("spectrum_method", "`average`, `likelihood`, `given` or `moments`",
                [](const T& of) { return study::method_name(*of.surface, of.surface->method); }),
        made<T>("spectra", "parameters by each method that was used", [](const T& of) { return of.spectra(); })
            .with(Missing::left_out),
        made<T>("likelihood", "spectrum fitted to all measurements",
                [](const T& of) -> const auto& { return of.surface->fitted; }),
        made<T>("likelihood_error", "the reason for a missing fitted spectrum",
                [](const T& of) { return output::where_given(of.surface->likelihood_error); }),
        made<T>("reconstructed", "whether the spectrum was constructed from published moments",
                [](const T& of) { return of.surface->reconstructed; }),
        made<T>("n_measurements", "number of measurements",
                [](const T& of) { return of.surface->measurements.size(); }),
    };
    static constexpr Description description{"", "an analysed surface", rows};
};

template <>
struct Described<output::SurfaceEntry> {
    using T = output::SurfaceEntry;
    static constexpr std::array rows{
        made<T>("error", "the reason for the failure",
                [](const T& of) { return output::where_given(of.surface->error); }),
        fields_of<T>([](const T& of) -> std::optional<output::AnalysedSurface> {
            if (of.surface->failed()) return std::nullopt;
            return output::AnalysedSurface{of.surface, of.options};
        }),
        list_filled_later<output::MeasurementEntry>("measurements", "one entry per measurement"),
        made<T>("beyond_data", "parameters with waves shorter than those of the data",
                [](const T& of) -> const auto& { return of.surface->beyond_data; }),
        made<T>("longer_waves", "parameters with waves longer than those of the data",
                [](const T& of) -> const auto& { return of.surface->longer_waves; }),
        made<T>("alerts", "warnings on the surface", [](const T& of) -> const auto& { return of.surface->alerts; }),
        made<T>("spectrum_file", "table of the spectrum, in the folder of study.json",
                [](const T& of) { return output::where_given(of.spectrum_file); }),
    };
    static constexpr Description description{
        "surface", "a rough surface: parameters by the spectrum used, and its measurements", rows};
};

}  // namespace setae::fields
