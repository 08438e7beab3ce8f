// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/core/table.hpp"
#include "setae/output/json.hpp"
#include "setae/scales/function_of_scale.hpp"
#include "setae/study/surface_analysis.hpp"

namespace setae::answers {

/// Which function of a distance: of `setae sdrp`, `setae acf`, `setae vbw`.
enum class ScaleFunction { differences, autocorrelation, variable_bandwidth };

/// "10nm,100nm" [m]. @throws InvalidArgument.
[[nodiscard]] std::vector<double> distances_of(const std::string& text);

/// What these verbs are asked.
struct ScaleRequest {
    study::SurfaceInput surface;
    std::uint64_t largest_map = study::SurfaceAnalysisOptions{}.largest_map;
    bool area = false;    ///< maps over all directions (autocorrelation, variable bandwidth)
    bool slope = false;   ///< the rms slope between points (autocorrelation)
    bool all = false;     ///< also distances that sampling, tip or resolution make unreliable
    bool binned = false;  ///< one measurement in the bins of combined ones too
    int order = 1;        ///< of the derivative (differences)
    int bins_per_decade = 10;
    std::string distance;                        ///< of differences; empty: ten a decade
    std::string longest;                         ///< of an area's autocorrelation
    std::string statistic = "rms", along = "x";  ///< of differences
    std::string weighting = "equal";             ///< of measurements
    bool every_measurement = false;              ///< the first failure of one is thrown
};

/// A function of a distance, of each measurement and combined from several.
struct FunctionsOfScale {
    std::vector<scales::FunctionOfScale> functions;    ///< none where every measurement failed
    std::optional<scales::CombinedFunction> combined;  ///< of several, or where bins are asked for
    Table table;                                       ///< the one that is shown
    std::vector<Alert> alerts;
    std::vector<std::string> failures;  ///< of measurements
};

/// @throws InvalidArgument for a table of a spectrum; what the functions throw where every measurement is wanted.
[[nodiscard]] FunctionsOfScale functions_of_scale(ScaleFunction function, const ScaleRequest& request,
                                                  parallel::Threads threads = {});

/// Columns by name, "units", "measurements", "contributors" and "alerts".
[[nodiscard]] output::Json to_json(const FunctionsOfScale& found);

}  // namespace setae::answers
