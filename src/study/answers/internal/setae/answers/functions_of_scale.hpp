// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/core/table.hpp"
#include "setae/core/units.hpp"
#include "setae/fields/option.hpp"
#include "setae/scales/function_of_scale.hpp"
#include "setae/study/surface_analysis.hpp"

namespace setae::answers {

/// Function of a distance: of `setae sdrp`, `setae acf`, `setae vbw`.
enum class ScaleFunction { differences, autocorrelation, variable_bandwidth };

/// "10nm,100nm" [m]. @throws InvalidArgument.
[[nodiscard]] std::vector<double> distances_of(const std::string& text);

/// Request of these commands.
struct ScaleRequest {
    study::SurfaceInput surface;
    std::uint64_t largest_map = study::SurfaceAnalysisOptions{}.largest_map;
    bool area = false, slope = false, all = false, binned = false;
    int order = 1, bins_per_decade = 10;
    std::string distance, longest, statistic = "rms", along = "x", weighting = "equal";
    bool every_measurement = false;  ///< the first failure of one is thrown
};

/// A function of a distance, of each measurement and combined from several.
struct FunctionsOfScale {
    ScaleFunction function = ScaleFunction::differences;
    std::vector<scales::FunctionOfScale> functions;    ///< none where every measurement failed
    std::optional<scales::CombinedFunction> combined;  ///< for several measurements, or where bins are requested
    Table table;                                       ///< the one that is shown
    std::vector<Alert> alerts;
    std::vector<std::string> failures;  ///< failures of measurements
};

/// @throws InvalidArgument for a table of a spectrum; what the functions throw where every measurement is requested.
[[nodiscard]] FunctionsOfScale functions_of_scale(ScaleFunction function, const ScaleRequest& request,
                                                  parallel::Threads threads = {});

}  // namespace setae::answers

template <>
struct setae::fields::Asked<setae::answers::ScaleRequest> {
    using R = answers::ScaleRequest;
    static constexpr std::array<std::string_view, 3> weightings{"equal", "per_instrument", "by_count"};
    static constexpr std::array<std::string_view, 7> statistics{"rms",      "variance", "mean",   "skewness",
                                                                "kurtosis", "minimum",  "maximum"};
    static constexpr std::array<std::string_view, 3> directions{"x", "y", "both"};
    /// For all functions.
    static constexpr std::array options{
        option<&R::all>("all", "unreliable distances, too: those that sampling, tip or resolution distort"),
        option<&R::binned>("binned", "one measurement is shown in the bins of combined measurements, too"),
        option<&R::bins_per_decade>("bins_per_decade", "bins per decade of combined functions")
            .between(1, 1000)
            .default_shown()
            .advanced(),
        option<&R::weighting>("weighting", "weights of measurements that are combined")
            .one_of(weightings)
            .default_shown()
            .advanced(),
    };
    static constexpr std::array differences{
        option<&R::distance>("distance", "length of the stencil, or several lengths separated by commas")
            .read_by([](const std::string& text) { (void)answers::distances_of(text); })
            .such_as("10nm,100nm")
            .or_else("ten per decade"),
        option<&R::order>("order", "order of the derivative: 1 slope, 2 curvature, 3 third derivative")
            .between(1, 3)
            .default_shown(),
        option<&R::statistic>("statistic", "statistic of the derivative").one_of(statistics).default_shown(),
        option<&R::along>("along", "direction of the differences").one_of(directions).default_shown(),
    };
    /// For autocorrelation and variable bandwidth.
    static constexpr std::array of_area{
        option<&R::area>("area", "maps as areas, over all directions or by planes, instead of along scan lines"),
    };
    static constexpr std::array autocorrelation{
        option<&R::longest>("longest", "longest distance over an area, needed for maps that are read in bands")
            .of(positive(dimension::length))
            .such_as("5 um"),
        option<&R::slope>("slope", "rms slope between points, sqrt(2A)/d, instead of A"),
    };
};
