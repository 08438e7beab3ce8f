// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "setae/processing/align_rows.hpp"
#include "setae/processing/combine_maps.hpp"
#include "setae/processing/crop.hpp"
#include "setae/processing/despike.hpp"
#include "setae/processing/fill.hpp"
#include "setae/processing/fourier_cut.hpp"
#include "setae/processing/iso_filter.hpp"
#include "setae/processing/level.hpp"
#include "setae/processing/region.hpp"
#include "setae/processing/resample.hpp"
#include "setae/processing/rotate.hpp"
#include "setae/processing/scars.hpp"
#include "setae/processing/turn.hpp"
#include "setae/processing/undefine.hpp"

namespace setae::processing {

/// All steps, in the order of documents. A new step is added here; steps.cpp does not compile without its description.
using Step =
    std::variant<LevelMean, LevelPlane, LevelPolynomial, LevelFacet, LevelLines, AlignRows, Despike, RemoveScars,
                 MaskOut, Undefine, FillUndefined, GaussianFilter, RobustGaussianFilter, SplineFilter, FourierCut, Crop,
                 Resample, Rotate, Transpose, Flip, QuarterTurns, AddMap, SubtractMap>;

/// Supplies the heights of another file to steps that use one; channel: its name, empty for the first one with heights.
using LoadMeasurement = std::function<topography::Measurement(const std::string& file, const std::string& channel)>;

/// A measurement after a step. `load` supplies heights of other files.
/// @throws exceptions of the step, and InvalidArgument for a step that needs another file without `load`.
[[nodiscard]] Processed apply(const Step& step, topography::Measurement measurement, const LoadMeasurement& load,
                              parallel::Threads threads = {});

/// Name of a step in pipeline files.
[[nodiscard]] std::string name(const Step& step);

/// The step with this name, or the step that removes the trend with this name, with defaults. @throws InvalidArgument
/// with the nearest name.
[[nodiscard]] Step step_named(std::string_view name);

/// A parameter of a step in documents.
struct ParameterDescription {
    std::string name;
    std::string values;  ///< "length", "number", "angle", "whole number", "true or false", "text", "region", or the
                         ///< choices "x or y"
    std::string default_value;  ///< empty without default
    std::string meaning;
};

/// A step in documents.
struct StepDescription {
    std::string name;
    std::string sentence;
    std::vector<ParameterDescription> parameters;
};

/// All steps, in the order of documents.
[[nodiscard]] std::vector<StepDescription> step_descriptions();

}  // namespace setae::processing
