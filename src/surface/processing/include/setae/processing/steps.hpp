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

/// Every step there is, in the order of documents. A new one is named here and gets its sentence in steps.cpp, which
/// does not compile before.
using Step =
    std::variant<LevelMean, LevelPlane, LevelPolynomial, LevelFacet, LevelLines, AlignRows, Despike, RemoveScars,
                 MaskOut, Undefine, FillUndefined, GaussianFilter, RobustGaussianFilter, SplineFilter, FourierCut, Crop,
                 Resample, Rotate, Transpose, Flip, QuarterTurns, AddMap, SubtractMap>;

/// How steps that name another file get its heights; channel: its name, empty for the first one of heights.
using LoadMeasurement = std::function<topography::Measurement(const std::string& file, const std::string& channel)>;

/// A measurement after a step. `load` serves steps that name another file.
/// @throws what the step throws, and InvalidArgument for a step that needs another file where nobody loads any.
[[nodiscard]] Processed apply(const Step& step, topography::Measurement measurement, const LoadMeasurement& load,
                              parallel::Threads threads = {});

/// Name of a step in pipeline files.
[[nodiscard]] std::string name(const Step& step);

/// The step of that name, or of the trend it removes, with its defaults. @throws InvalidArgument with the nearest name.
[[nodiscard]] Step step_named(std::string_view name);

/// A step's parameter as documents show it.
struct ParameterDescription {
    std::string name;
    std::string values;  ///< "length", "number", "angle", "whole number", "true or false", "text", "region", or the
                         ///< choices "x or y"
    std::string default_value;  ///< empty where there is none
    std::string meaning;
};

/// A step as documents show it.
struct StepDescription {
    std::string name;
    std::string sentence;
    std::vector<ParameterDescription> parameters;
};

/// All steps, in the order of documents.
[[nodiscard]] std::vector<StepDescription> step_descriptions();

}  // namespace setae::processing
