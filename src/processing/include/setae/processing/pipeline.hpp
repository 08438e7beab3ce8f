// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "setae/processing/align_rows.hpp"
#include "setae/processing/crop.hpp"
#include "setae/processing/despike.hpp"
#include "setae/processing/level.hpp"
#include "setae/processing/region.hpp"
#include "setae/processing/scars.hpp"
#include "setae/processing/turn.hpp"

namespace setae::processing {

/// Every step there is, in the order of documents. A new step is named here and in pipeline.cpp's sentences, which does not compile before.
using Step = std::variant<LevelMean, LevelPlane, LevelPolynomial, LevelFacet, LevelLines, AlignRows, Despike, RemoveScars, MaskOut, Crop, Transpose, Flip, QuarterTurns>;

/// A step of a pipeline, and whether it is done.
struct Entry {
    Step step;
    bool on = true;
};

/// What is done to heights before they are analysed, in order: a value that is written to a file and done to n measurements.
struct Pipeline {
    std::vector<Entry> entries;
};

/// A measurement after a pipeline, with the record of every step that was done.
struct PipelineResult {
    topography::Measurement measurement;
    std::vector<StepRecord> records;
};

/// The steps that are on, one after the other.
///
/// Each record gains the rms height Sq (lines: Rq) after its step. metadata.attributes["pipeline"] of the result says the steps, behind what
/// an earlier pipeline left there.
/// @throws what a step throws, its name before the message.
[[nodiscard]] PipelineResult apply(const Pipeline& pipeline, topography::Measurement measurement, parallel::Threads threads = {});

/// The same for one step.
[[nodiscard]] Processed apply_step(const Step& step, topography::Measurement measurement, parallel::Threads threads = {});

/// A step's parameter as documents show it.
struct ParameterDescription {
    std::string name;
    std::string kind;           ///< "length", "number", "angle", "count", "yes or no", "text", "region", or the choices "x | y"
    std::string default_value;  ///< empty where nothing is the default
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

/// Name of a step in pipeline files.
[[nodiscard]] std::string name(const Step& step);

/// A step of that name with its defaults. @throws InvalidArgument with the nearest name.
[[nodiscard]] Step step_named(std::string_view name);

/// A parameter as text: its value with its unit, as pipeline files have it.
struct ParameterText {
    std::string name;
    std::string value;

    friend bool operator==(const ParameterText&, const ParameterText&) = default;
};

/// Sets a parameter from text such as "8 um", "30 deg", "true", "median".
/// @throws InvalidArgument for an unknown parameter (with the nearest name) and a value that is none.
void set_parameter(Step& step, const ParameterText& parameter);

/// The parameters that differ from their defaults; set_parameter() makes the same values of them again.
[[nodiscard]] std::vector<ParameterText> changed_parameters(const Step& step);

/// A step from one line, as the command line has it: its name, then parameters NAME=VALUE, values with blanks in quotes, such as
/// align_rows method=median region="exclude heights above 20 nm". @throws InvalidArgument.
[[nodiscard]] Step step_from_text(std::string_view text);

/// The line step_from_text() reads back to the same step.
[[nodiscard]] std::string text(const Step& step);

}  // namespace setae::processing
