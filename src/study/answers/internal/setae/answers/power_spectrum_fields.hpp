// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A power spectrum and its self-affine fit, as the JSON of `setae psd` has them.

#include <array>
#include <string_view>
#include <vector>

#include "setae/answers/power_spectrum.hpp"
#include "setae/answers/surface_request.hpp"
#include "setae/fields/describe.hpp"
#include "setae/output/step_fields.hpp"

namespace setae::answers {

/// Words for the result of a fit, in the order of the enumerators.
inline constexpr std::array<std::string_view, 3> scale_status_words{"found", "bounded", "not_asked"};
inline constexpr std::array<std::string_view, 2> fit_status_words{"converged", "not_converged"};

/// A measurement of the spectrum.
struct MeasuredSpectrumEntry {
    const study::MeasurementResult* measurement;
};
[[nodiscard]] inline std::vector<MeasuredSpectrumEntry> measurements_of(const study::SurfaceResult& surface) {
    std::vector<MeasuredSpectrumEntry> entries;
    for (const auto& measurement : surface.measurements)
        if (!measurement.failed()) entries.push_back({&measurement});
    return entries;
}

}  // namespace setae::answers

namespace setae::fields {

template <>
struct Described<spectra::SelfAffineFit> {
    using T = spectra::SelfAffineFit;
    static constexpr std::array rows_of_covariance{
        field<&T::parameters>("of", "names of the parameters"),
        field<&T::covariance>("rows", "rows of the matrix"),
    };
    static constexpr Description covariance{"", "covariance of the parameters", rows_of_covariance};
    static constexpr std::array rows_of_residuals{
        field<&T::wavevector>("wavevector", "wavevector q").in_unit("1/m"),
        field<&T::residual>("residual", "signed root of the deviance of each value; normal if the model is correct")
            .in_unit("1"),
    };
    static constexpr Description residuals{"", "residuals of the fitted values", rows_of_residuals};
    static constexpr std::array rows{
        made<T>("parameters", "Hurst exponent, amplitude and scales that were fitted",
                [](const T& of) { return answers::parameters_of(of); }),
        made<T>("rolloff", "result for the roll-off wavelength",
                [](const T& of) { return answers::scale_status_words.at(static_cast<std::size_t>(of.rolloff)); })
            .one_of(answers::scale_status_words),
        made<T>("short_cutoff", "result for the shortest wavelength",
                [](const T& of) { return answers::scale_status_words.at(static_cast<std::size_t>(of.short_cutoff)); })
            .one_of(answers::scale_status_words),
        value<&T::reference_wavevector>("reference_wavevector", "1/m", "wavevector to which the amplitude refers"),
        field<&T::range>("range", "range of the fitted wavevectors"),
        part<T>("covariance", "covariance of the parameters", covariance),
        field<&T::correlation>("correlation", "correlation of the parameters: rows of the matrix"),
        field<&T::chi_squared>("chi_squared", "χ² of the fit"),
        field<&T::degrees_of_freedom>("degrees_of_freedom", "degrees of freedom of χ²"),
        field<&T::probability>("probability", "probability of a χ² at least as large by chance"),
        made<T>("status", "whether the fit converged",
                [](const T& of) { return answers::fit_status_words.at(static_cast<std::size_t>(of.status)); })
            .one_of(answers::fit_status_words),
        part<T>("residuals", "residuals of the fitted values", residuals),
        field<&T::alerts>("alerts", "warnings"),
        inner<&T::model>(),
        inner<&T::hurst_exponent>(),
        inner<&T::plateau>(),
        inner<&T::amplitude>(),
        inner<&T::rolloff_wavelength>(),
        inner<&T::shortest_wavelength>(),
        inner<&T::rolloff>(),
        inner<&T::short_cutoff>(),
        inner<&T::values>(),
        inner<&T::expected>(),
        inner<&T::iterations>(),
        inner<&T::status>(),
    };
    static constexpr Description description{"", "self-affine model of the spectrum", rows};
};
static_assert(complete<spectra::SelfAffineFit>);

template <>
struct Described<answers::MeasuredSpectrumEntry> {
    using T = answers::MeasuredSpectrumEntry;
    static constexpr std::array rows{
        made<T>("file", "name of the file as it was given",
                [](const T& of) -> const auto& { return of.measurement->file; }),
        made<T>("name", "name of the measurement", [](const T& of) -> const auto& { return of.measurement->name; }),
        made<T>("q_min", "smallest reliable wavevector",
                [](const T& of) { return of.measurement->spectrum.band.lower; })
            .in_unit("1/m"),
        made<T>("q_max", "largest reliable wavevector", [](const T& of) { return of.measurement->spectrum.band.upper; })
            .in_unit("1/m"),
        made<T>("window", "window of the transform",
                [](const T& of) -> const auto& { return of.measurement->spectrum.window; }),
        made<T>("processing", "processing steps that were applied to the heights",
                [](const T& of) -> const auto& { return of.measurement->processing; }),
        made<T>("channel", "number of the channel within the file, counted from 0",
                [](const T& of) { return of.measurement->channel; }),
    };
    static constexpr Description description{"", "a measurement of the spectrum", rows};
};

template <>
struct Described<answers::PowerSpectrum> {
    using T = answers::PowerSpectrum;
    static constexpr auto table = [](const T& of) -> const Table& { return of.table; };
    static constexpr std::array rows_of_columns{
        column("wavevector", "1/m", "wavevector q").with(Missing::never),
        column("C_iso", "m4", "isotropic density of the surface"),
        column("C1D", "m3", "C1D, two-sided: h_rms² = (1/π) ∫ C1D dq").with(Missing::never),
        column("standard_error", "", "standard error of C1D, or of C_iso in a table with C_iso"),
        column("count", "1", "number of modes or measurements of each value"),
        column("independent_lines", "1", "number of independent lines of a map, n; C1D has the relative variance 1/n"),
        column("interval_low", "m3", "lower end of the 95 % interval of C1D, for Gaussian heights"),
        column("interval_high", "m3", "upper end of the 95 % interval of C1D, for Gaussian heights"),
        column("instrument_count", "1", "number of instruments that contribute to each value"),
        column("C_iso_abel", "m4", "inverse Abel transform of C1D"),
        column("C_iso_abel_standard_error", "m4", "standard error of C_iso_abel"),
        column("C_iso_abel_over_pi_C1D_by_q", "1", "C_iso_abel divided by π C1D/q"),
        column("C1D_model", "m3", "C1D of the self-affine fit"),
        column("C1D_model_standard_error", "m3", "standard error of C1D of the self-affine fit"),
        column("extrapolated", "1", "1 outside the range of the fit, 0 within"),
    };
    static constexpr Description columns{"", "columns of the spectrum", rows_of_columns};
    static constexpr std::array rows{
        columns_among<T>(columns, table),
        units_of_columns<T>(table),
        made<T>("conventions", "conventions of the columns, and their origin",
                [](const T& of) -> const auto& { return of.table.metadata; }),
        made<T>("band", "range of the wavevectors of the data",
                [](const T& of) -> const Band& { return of.surface.average.curve.band; }),
        made<T>("measurements", "measurements that contribute to the spectrum",
                [](const T& of) { return answers::measurements_of(of.surface); }),
        made<T>("alerts", "warnings", [](const T& of) { return answers::alerts_of(of.surface); }),
        field<&T::fit>("fit", "self-affine model of the spectrum"),
        inner<&T::surface>(),
        inner<&T::table>(),
    };
    static constexpr Description description{"", "power spectral density", rows};
};
static_assert(complete<answers::PowerSpectrum>);

}  // namespace setae::fields
