// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/core/units.hpp"
#include "setae/fields/option.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/synthesis/transformed_heights.hpp"

namespace setae::answers {

/// Points along x and y of "1024x512", or of "1024" for both. @throws InvalidArgument.
[[nodiscard]] std::array<Index, 2> point_counts(const std::string& text);

/// Lengths [m] along x and y of "5 um x 2 um", or of "5 um" for both. @throws InvalidArgument.
[[nodiscard]] std::array<double, 2> extents(const std::string& text);

/// Plan of a synthesis: spectrum, grid, and the window written where that is not the whole surface.
struct SynthesisPlan {
    spectra::SpectralDensity density;  ///< C_iso for a surface, C1D for a line
    synthesis::SurfaceGrid grid;       ///< for a line: nx and size_x
    synthesis::SurfaceOptions options;
    bool line = false;
    synthesis::HeightTransform heights;          ///< distribution of heights; empty: Gaussian
    std::optional<std::array<Index, 2>> window;  ///< points of the window, from the surface's first point on
    std::vector<Alert> alerts;                   ///< warnings of the table of its spectrum

    /// Roughness of the spectrum on the grid.
    [[nodiscard]] synthesis::ExpectedRoughness expected() const;
    [[nodiscard]] topography::Measurement make() const;
};

/// Request of `setae synthesize`: surface or line to be generated.
struct SynthesisRequest {
    std::optional<double> hurst;
    std::string rolloff, short_cutoff, long_cutoff, rms_height, rms_slope, plateau, spectrum;
    std::string spectrum_unit, pixels = "1024", size, window_of;
    std::uint64_t seed = 0;
    bool line = false, exact_rms = false;
    std::string amplitudes = "gaussian";
    double stretch = 1.0, angle = 0.0;
    std::optional<double> skewness, kurtosis;

    /// @throws InvalidArgument for options that are missing, malformed or contradict each other; as the reader of
    /// spectra.
    [[nodiscard]] SynthesisPlan plan(parallel::Threads threads) const;

private:
    [[nodiscard]] spectra::SpectralDensity self_affine(const synthesis::SurfaceGrid& grid) const;
};

/// A surface or line that was made; its roughness by the spectrum and by its heights.
struct Synthesis {
    SynthesisPlan plan;
    topography::Measurement measurement;
    std::vector<Quantity> quantities;
};

/// @throws as SynthesisRequest::plan().
[[nodiscard]] Synthesis synthesis_of(const SynthesisRequest& request, parallel::Threads threads = {});

}  // namespace setae::answers

template <>
struct setae::fields::Asked<setae::answers::SynthesisRequest> {
    using R = answers::SynthesisRequest;
    static constexpr std::array<std::string_view, 2> amplitudes{"gaussian", "exact"};
    static constexpr std::array options{
        option<&R::hurst>("hurst", "Hurst exponent H of a self-affine spectrum, 0 < H <= 1").within(domain::share),
        option<&R::rolloff>("rolloff", "roll-off wavelength, above which the spectrum is flat")
            .of(positive(dimension::length))
            .such_as("2 um"),
        option<&R::short_cutoff>("short_cutoff", "shortest wavelength of a self-affine spectrum")
            .of(positive(dimension::length))
            .such_as("20 nm"),
        option<&R::long_cutoff>("long_cutoff", "longest wavelength of a self-affine spectrum")
            .of(positive(dimension::length))
            .such_as("20 um")
            .or_else("no limit"),
        option<&R::rms_height>("rms_height", "rms height of the spectrum")
            .of(positive(dimension::length))
            .such_as("20 nm"),
        option<&R::rms_slope>("rms_slope", "rms slope of the spectrum").of(positive(dimension::none)).such_as("0.3"),
        option<&R::plateau>("plateau", "C_iso at wavelengths longer than the roll-off")
            .of(positive(dimension::power_spectrum_2d))
            .such_as("5e-27 m4"),
        option<&R::spectrum>("spectrum", "table of q and C_iso [m4] or C1D [m3] instead of a self-affine spectrum")
            .or_word("table"),
        option<&R::spectrum_unit>("unit", "units of the columns of a spectrum's table whose header has none")
            .such_as("frequency 1/um, one-sided nm3"),
        option<&R::pixels>("pixels", "points along x and y, 1024x512, or one number for both")
            .read_by([](const std::string& text) { (void)answers::point_counts(text); })
            .default_shown(),
        option<&R::size>("size", "extent of the surface along x and y, or one length for both")
            .read_by([](const std::string& text) { (void)answers::extents(text); })
            .such_as("5 um x 2 um"),
        option<&R::window_of>(
            "window_of",
            "extent of the periodic surface from which a window of the size given is cut, which is not periodic")
            .read_by([](const std::string& text) { (void)answers::extents(text); })
            .such_as("20 um")
            .advanced(),
        option<&R::seed>("seed", "seed of the random numbers; equal seeds give equal surfaces").default_shown(),
        option<&R::line>("line", "a line on a surface with the spectrum, instead of a map"),
        option<&R::exact_rms>("exact_rms",
                              "heights are scaled to the rms height of the spectrum, or to the rms height given")
            .advanced(),
        option<&R::amplitudes>("amplitudes", "amplitudes of the modes: random, or exactly those of the spectrum")
            .one_of(amplitudes)
            .default_shown()
            .advanced(),
        option<&R::stretch>("stretch", "factor by which features are longer along one direction")
            .default_shown()
            .advanced(),
        option<&R::angle>("angle", "angle between the long direction of stretched features and x in degrees")
            .default_shown()
            .advanced(),
        option<&R::skewness>("skewness", "skewness of the heights of a surface, which keeps the spectrum")
            .or_else("0")
            .advanced(),
        option<&R::kurtosis>("kurtosis", "kurtosis of the heights of a surface, which keeps the spectrum")
            .or_else("3, Gaussian")
            .advanced(),
    };
};
