// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Functions of a distance, as the JSON of `setae acf`, `setae sdrp` and `setae vbw` has them.

#include <array>
#include <optional>
#include <vector>

#include "setae/answers/functions_of_scale.hpp"
#include "setae/fields/describe.hpp"

namespace setae::answers {

/// A measurement of a function.
struct ScaleMeasurement {
    const scales::FunctionOfScale* function;
};
[[nodiscard]] inline std::vector<ScaleMeasurement> measurements_of(const FunctionsOfScale& found) {
    std::vector<ScaleMeasurement> measurements;
    for (const auto& function : found.functions) measurements.push_back({&function});
    return measurements;
}

/// Measurements that contribute to each value of a combined function.
using Contributors = std::vector<std::vector<Index>>;
[[nodiscard]] inline std::optional<Contributors> contributors_of(const FunctionsOfScale& found) {
    if (!found.combined) return std::nullopt;
    return found.combined->contributors;
}

}  // namespace setae::answers

namespace setae::fields {

template <>
struct Described<answers::ScaleMeasurement> {
    using T = answers::ScaleMeasurement;
    static constexpr std::array rows{
        made<T>("file", "name of the file as it was given",
                [](const T& of) -> const auto& { return of.function->metadata.file; }),
        made<T>("name", "name of the measurement",
                [](const T& of) -> const auto& { return of.function->metadata.name; }),
        made<T>("reliable_from", "shortest reliable distance; shorter distances are left out",
                [](const T& of) { return of.function->reliable_from; })
            .in_unit("m"),
    };
    static constexpr Description description{"", "a measurement of the function", rows};
};

/// The rows of a function with these columns.
consteval auto rows_of_scales(const Description& columns) {
    using T = answers::FunctionsOfScale;
    constexpr auto table = [](const T& of) -> const Table& { return of.table; };
    return std::array{
        columns_among<T>(columns, table),
        units_of_columns<T>(table),
        made<T>("measurements", "measurements that were analysed",
                [](const T& of) { return answers::measurements_of(of); }),
        made<T>("contributors", "numbers of the measurements that contribute to each value, counted from 0",
                [](const T& of) { return answers::contributors_of(of); }),
        field<&T::alerts>("alerts", "warnings"),
    };
}

inline constexpr std::array columns_of_combined_scales{
    column("standard_error", "", "standard error between measurements; null for one measurement"),
    column("instrument_count", "1", "number of instruments that contribute to each value"),
};

}  // namespace setae::fields

namespace setae::answers {

/// JSON of `setae acf`.
inline constexpr auto columns_of_acf = fields::joined(
    std::array{
        fields::column("distance", "m", "distance over which heights are compared").with(fields::Missing::never),
        fields::column("autocorrelation", "m2", "<(h(x + d) − h(x))²>/2 along lines"),
        fields::column("autocorrelation_of_area", "m2", "<(h(x + d) − h(x))²>/2 over all directions"),
        fields::column("rms_slope", "1", "rms slope between points, from the autocorrelation along lines"),
        fields::column("count", "",
                       "number of pairs of heights of each value, a length of polylines; number of "
                       "measurements where they are combined"),
    },
    fields::columns_of_combined_scales);
inline constexpr fields::Description acf_columns{"", "columns of the autocorrelation", columns_of_acf};
inline constexpr auto rows_of_acf = fields::rows_of_scales(acf_columns);
inline constexpr fields::Description acf_description{"", "height-difference autocorrelation", rows_of_acf};

/// JSON of `setae sdrp`.
inline constexpr auto columns_of_sdrp = fields::joined(
    std::array{
        fields::column("distance", "m", "distance over which heights are compared").with(fields::Missing::never),
        fields::column("rms_slope", "",
                       "rms slope at each distance; columns of other options have the names of statistic, derivative "
                       "and direction, such as `rms_curvature` and `variance_slope_xy`"),
        fields::column("count", "",
                       "number of differences of each value, a length of polylines; number of "
                       "measurements where they are combined"),
    },
    fields::columns_of_combined_scales);
inline constexpr fields::Description sdrp_columns{"", "columns of the slope or curvature", columns_of_sdrp};
inline constexpr auto rows_of_sdrp = fields::rows_of_scales(sdrp_columns);
inline constexpr fields::Description sdrp_description{"", "slope or curvature at every scale", rows_of_sdrp};

/// JSON of `setae vbw`.
inline constexpr auto columns_of_vbw = fields::joined(
    std::array{
        fields::column("distance", "m", "size of the cells").with(fields::Missing::never),
        fields::column("variable_bandwidth", "m", "rms height within cells of this size"),
        fields::column("count", "",
                       "number of residuals of each value, a length of polylines; number of measurements "
                       "where they are combined"),
    },
    fields::columns_of_combined_scales);
inline constexpr fields::Description vbw_columns{"", "columns of the rms height", columns_of_vbw};
inline constexpr auto rows_of_vbw = fields::rows_of_scales(vbw_columns);
inline constexpr fields::Description vbw_description{"", "rms height within cells of every size", rows_of_vbw};

/// The description of the output of a command.
[[nodiscard]] constexpr const fields::Description& description_of(ScaleFunction function) {
    switch (function) {
        case ScaleFunction::differences: return sdrp_description;
        case ScaleFunction::autocorrelation: return acf_description;
        case ScaleFunction::variable_bandwidth: break;
    }
    return vbw_description;
}

}  // namespace setae::answers
