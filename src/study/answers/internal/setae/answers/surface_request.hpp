// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/core/units.hpp"
#include "setae/fields/option.hpp"
#include "setae/formats/channel.hpp"
#include "setae/processing/pipeline.hpp"
#include "setae/processing/step_text.hpp"
#include "setae/spectra/window.hpp"
#include "setae/study/file_content.hpp"
#include "setae/study/surface_analysis.hpp"
#include "setae/topography/detrend.hpp"

/// Requests of users as typed texts, and their results. Empty texts are not given.
namespace setae::answers {

/// "1 mm x 1 mm" or "2 mm" [m]. @throws InvalidArgument for more than two lengths, and as parse_quantity().
[[nodiscard]] std::vector<double> lengths_of(const std::string& text);

/// Metadata that files may not contain.
struct FileRequest {
    std::string size, unit, as;
    formats::ChannelChoice channel;
    bool keep_values = false;

    /// @throws InvalidArgument for a malformed size, and for a table of a spectrum, which holds no heights.
    [[nodiscard]] formats::ReadOptions read_options() const;
    /// The same of files of any kind. @throws InvalidArgument for malformed texts.
    [[nodiscard]] study::FileQuestions questions() const;

    friend bool operator==(const FileRequest&, const FileRequest&) = default;
};

/// Names of all processing steps.
[[nodiscard]] std::vector<std::string> step_names();

/// Processing before analysis: the steps of a file, then those of the list.
struct ProcessingRequest {
    std::string file;
    std::vector<std::string> steps;

    [[nodiscard]] bool given() const { return !file.empty() || !steps.empty(); }
    /// @throws as read_pipeline() and step_from_text() do.
    [[nodiscard]] processing::Pipeline pipeline() const;
};

/// Reading and preparation of the files of one surface.
struct MeasurementRequest {
    FileRequest file;
    ProcessingRequest processing;
    std::string instrument, tip_radius, resolution, trend;

    /// One of them. @throws InvalidArgument for a malformed text.
    [[nodiscard]] study::MeasurementInput input(const std::string& path) const;
};

/// Analysis of a surface.
struct AnalysisRequest {
    std::string longest, shortest, window, contours, conversion;
    double memory = 2.0;
    int resamples = 200;

    /// By the average over measurements, whose spectrum can be shown bin by bin. @throws InvalidArgument.
    [[nodiscard]] study::SurfaceAnalysisOptions analysis() const;
};

/// Files that are measurements of one surface, or the table of its spectrum.
struct SurfaceRequest : MeasurementRequest, AnalysisRequest {
    std::vector<std::string> files;

    /// Whether the one file is the table of a spectrum. @throws InvalidArgument for one among others.
    [[nodiscard]] bool is_spectrum() const;
    /// @throws InvalidArgument for a malformed text; as is_spectrum().
    [[nodiscard]] study::SurfaceInput surface() const;
};

/// All warnings of a surface and its measurements.
[[nodiscard]] std::vector<Alert> alerts_of(const study::SurfaceResult& surface);

/// Layouts of text files.
inline constexpr std::array<std::string_view, 3> layouts{"matrix", "columns", "spectrum"};

/// Options that more than one request has.
template <auto Member>
consteval fields::Option layout_option() {
    return fields::option<Member>("as",
                                  "layout of a text file: a narrow map (matrix), points x y z (columns), or the table "
                                  "of a spectrum (spectrum)")
        .one_of(layouts)
        .or_else("from numbers and header")
        .in_python("layout");
}
template <auto Member>
consteval fields::Option keep_values_option() {
    return fields::option<Member>("keep_values",
                                  "values that mark missing heights (NO_DATA), such as -9999, stay heights; without it "
                                  "they become undefined");
}
template <auto Member>
consteval fields::Option tip_radius_option() {
    return fields::option<Member>("tip_radius", "radius of the tip, with its standard error where it is known")
        .of(positive(dimension::length), "nm")
        .such_as("10 ± 2 nm")
        .or_else("that of the file");
}
template <auto Member>
consteval fields::Option trend_option(std::string_view meaning) {
    return fields::option<Member>("trend", meaning)
        .offering([] {
            return std::vector<std::string>{"none", "mean", "tilt", "parabola"};
        })
        .read_by([](const std::string& text) { (void)topography::trend_from_name(text); });
}

}  // namespace setae::answers

template <>
struct setae::fields::Asked<setae::answers::FileRequest> {
    using R = answers::FileRequest;
    static constexpr std::array options{
        option<&R::size>("size", "extent of a map or length of a line, where the file does not state it")
            .read_by([](const std::string& text) { (void)answers::lengths_of(text); })
            .such_as("1 mm x 1 mm"),
        option<&R::unit>("unit",
                         "unit of lengths where the file does not state it, \"um\"; of x and heights, \"mm, um\"; of a "
                         "spectrum's columns, \"frequency 1/um, one-sided nm3\""),
        answers::layout_option<&R::as>(),
        option<&R::channel>("channel",
                            "channel by its number, counted from 0, or by its name or the beginning of the name; "
                            "`setae info` lists channels"),
        answers::keep_values_option<&R::keep_values>(),
    };
};

template <>
struct setae::fields::Asked<setae::answers::ProcessingRequest> {
    using R = answers::ProcessingRequest;
    static constexpr std::array options{
        option<&R::file>("pipeline", "file of processing steps, in YAML or TOML").such_as("p.yml"),
        option<&R::steps>(
            "step",
            "processing step after those of a pipeline file, named once per step; `setae level --explain` lists steps")
            .offering(answers::step_names)
            .read_by([](const std::string& text) { (void)processing::step_from_text(text); })
            .such_as("despike threshold=5")
            .one_at_a_time(),
    };
};

template <>
struct setae::fields::Asked<setae::answers::MeasurementRequest> {
    using R = answers::MeasurementRequest;
    static constexpr std::array<std::string_view, 4> instruments{"stylus", "afm", "tem", "optical"};
    static constexpr std::array options{
        option<&R::instrument>("instrument", "kind of instrument").one_of(instruments).or_else("that of the file"),
        answers::tip_radius_option<&R::tip_radius>(),
        option<&R::resolution>("resolution", "shortest wavelength that the instrument resolves")
            .of(positive(dimension::length), "nm")
            .such_as("500 nm")
            .or_else("that of the file"),
        answers::trend_option<&R::trend>("trend removed before analysis: none, mean, tilt or parabola")
            .or_else("none after a pipeline that levels, else by instrument"),
    };
};

template <>
struct setae::fields::Asked<setae::answers::AnalysisRequest> {
    using R = answers::AnalysisRequest;
    static constexpr std::array<std::string_view, 2> contours{"sinc_corrected", "segments"};
    static constexpr std::array<std::string_view, 2> conversions{"exact", "eq11"};
    /// For every analysis of heights.
    static constexpr std::array memory{
        option<&R::memory>("memory", "memory for heights in GiB; larger maps are read in bands of scan lines")
            .within(domain::positive)
            .default_shown()
            .advanced(),
    };
    static constexpr std::array options{
        option<&R::longest>("longest_wavelength", "longest wavelength in all integrals")
            .of(positive(dimension::length))
            .such_as("100 um")
            .in_python("longest")
            .advanced(),
        option<&R::shortest>("shortest_wavelength", "shortest wavelength in all integrals")
            .of(positive(dimension::length))
            .such_as("50 nm")
            .in_python("shortest")
            .advanced(),
        option<&R::window>("window", "window of the Fourier transform: automatic, none, hann or blackman_harris")
            .offering([] {
                return std::vector<std::string>{"automatic", "none", "hann", "blackman_harris"};
            })
            .read_by([](const std::string& text) { (void)spectra::window_from_name(text); })
            .or_else("automatic")
            .advanced(),
        option<&R::contours>("contours",
                             "spectrum of traced curves: corrected for straight segments between points, or of the "
                             "segments as they are")
            .one_of(contours)
            .or_else("sinc_corrected")
            .advanced(),
        option<&R::conversion>(
            "conversion",
            "conversion of C1D to parameters of the surface: exact, or Eq. 11 of Dalvi et al. 2019 (eq11)")
            .one_of(conversions)
            .or_else("exact")
            .advanced(),
        option<&R::resamples>("bootstrap_resamples", "bootstrap replicas for standard errors, 0 for none")
            .between(0, 1000000)
            .default_shown()
            .advanced(),
    };
};
