// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/core/units.hpp"
#include "setae/fields/describe.hpp"
#include "setae/fields/option.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/study/surface_analysis.hpp"
#include "setae/texture/profile_parameters.hpp"

namespace setae::answers {

/// Request of `setae params --standard`: parameters, filters, and format.
struct TextureRequest {
    std::string standard, s_filter, l_filter, section_length, kind, averages, mean_line, between, format,
        material_height, only;
    std::optional<double> material_ratio;

    /// Whether a standard's parameters are requested.
    /// @throws InvalidArgument where only options of them are given.
    [[nodiscard]] bool asked() const;

    /// Parameters of one measurement; of a map by ISO 21920-2 the mean over its scan lines, with the standard error of
    /// their spread.
    [[nodiscard]] std::vector<texture::TextureParameter> parameters_of(const topography::Measurement& measurement,
                                                                       parallel::Threads threads) const;

    /// Symbols of the table that `only` names. @throws InvalidArgument for others.
    [[nodiscard]] std::vector<std::string> chosen() const;

private:
    [[nodiscard]] texture::Filters filters() const;
    [[nodiscard]] texture::ProfileOptions profile() const;
};

/// Parameters of one measurement.
struct MeasuredTexture {
    std::string file;
    std::string measurement;
    std::vector<texture::TextureParameter> parameters;
};

/// Parameters of all measurements of a surface, and their problems.
struct TextureAnswer {
    std::vector<MeasuredTexture> list;
    std::vector<Alert> alerts;
    std::vector<std::string> failures;  ///< failures of measurements that could not be read
};

/// every_measurement: the first failure is thrown. @throws what reading and the parameters throw then.
[[nodiscard]] TextureAnswer texture_of(const study::SurfaceInput& surface, const TextureRequest& request,
                                       parallel::Threads threads = {}, bool every_measurement = false);

/// A parameter of a standard, and its measurement.
struct TextureEntry {
    const MeasuredTexture* measured;
    const texture::TextureParameter* parameter;
};

/// Parameters of all measurements.
[[nodiscard]] std::vector<TextureEntry> texture_entries(const TextureAnswer& answer);

}  // namespace setae::answers

template <>
struct setae::fields::Described<setae::answers::TextureEntry> {
    using T = answers::TextureEntry;
    static constexpr std::array<std::string_view, 2> states{"ok", "warn"};
    static constexpr std::array rows{
        quantity_fields<T>([](const T& of) -> const Quantity& { return of.parameter->quantity; }),
        made<T>("filter", "filters of the heights", [](const T& of) -> const auto& { return of.parameter->filter; }),
        made<T>("status", "`warn` for a parameter with warnings",
                [](const T& of) { return states[of.parameter->ok() ? 0 : 1]; })
            .one_of(states),
        made<T>("file", "name of the file as it was given",
                [](const T& of) -> const auto& { return of.measured->file; }),
        made<T>("measurement", "name of the measurement",
                [](const T& of) -> const auto& { return of.measured->measurement; }),
    };
    static constexpr Description description{"", "with `--standard` the parameters of the standard", rows};
};

template <>
struct setae::fields::Asked<setae::answers::TextureRequest> {
    using R = answers::TextureRequest;
    static constexpr std::array<std::string_view, 2> standards{"iso25178", "iso21920"};
    static constexpr std::array<std::string_view, 3> profiles{"primary", "waviness", "roughness"};
    static constexpr std::array<std::string_view, 2> averages{"evaluation_length", "sections"};
    static constexpr std::array<std::string_view, 2> mean_lines{"mean", "zero"};
    static constexpr std::array<std::string_view, 2> between{"linear", "nothing"};
    static constexpr std::array options{
        option<&R::standard>("standard",
                             "standard of the parameters: of maps (iso25178), or of lines (iso21920; of a map the mean "
                             "over scan lines)")
            .one_of(standards),
        option<&R::only>("only", "symbols or names of the parameters of a standard that are wanted")
            .such_as("Sq, Sdr")
            .or_else("all"),
        option<&R::s_filter>("s_filter", "nesting index of the Gaussian S-filter (λs)")
            .of(positive(dimension::length))
            .such_as("2.5um"),
        option<&R::l_filter>(
            "l_filter",
            "Gaussian L-filter: \"default\" for both filters of iso21920 by Ra (ISO 4288), or a nesting index (λc)")
            .read_by([](const std::string& text) {
                if (text != "default") (void)parse_quantity(text, positive(dimension::length));
            })
            .such_as("0.8mm"),
        option<&R::section_length>("section_length", "length of a section by iso21920")
            .of(positive(dimension::length))
            .such_as("0.8mm")
            .or_else("the nesting index of the L-filter, else all")
            .advanced(),
        option<&R::kind>("profile", "profile whose parameters iso21920 gives").one_of(profiles).or_else("roughness"),
        option<&R::averages>(
            "averages", "averages of iso21920: over the evaluation length (2021), or over sections (ISO 4287:1997)")
            .one_of(averages)
            .or_else("evaluation_length")
            .advanced(),
        option<&R::mean_line>("mean_line",
                              "zero of heights in iso21920: the mean, or zero for profiles that an instrument filtered")
            .one_of(mean_lines)
            .or_else("mean")
            .advanced(),
        option<&R::between>("between", "heights between points in the material ratio: linear (triangles), or nothing")
            .one_of(between)
            .or_else("linear")
            .advanced(),
        option<&R::material_height>("material_height", "height c above the mean in Smr(c) and Rmr(c)")
            .of(dimension::length)
            .such_as("0.2um")
            .or_else("0")
            .advanced(),
        option<&R::material_ratio>("material_ratio", "material ratio p in Smc(p) and Rmc(p), from 0 to 1")
            .within(domain::share)
            .or_else("0.5, the median")
            .advanced(),
    };
};
