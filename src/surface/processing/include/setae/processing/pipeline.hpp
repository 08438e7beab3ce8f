// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/processing/steps.hpp"

namespace setae::processing {

/// A step of a pipeline, and whether it is applied.
struct Entry {
    Step step;
    bool on = true;
};

/// Processing of heights before analysis, as an ordered list of steps: a value that is written to a file and applied to
/// any number of measurements.
struct Pipeline {
    std::vector<Entry> entries;

    /// Whether it changes nothing.
    [[nodiscard]] bool empty() const;
};

/// A measurement after a pipeline, with the record of every applied step.
struct PipelineResult {
    topography::Measurement measurement;
    std::vector<StepRecord> records;
};

/// Applies the enabled steps, in order.
///
/// Each record ends with the rms height Sq (lines: Rq) after its step. metadata.attributes["pipeline"] of the result
/// contains the text of each step, separated by " | ", after that of an earlier pipeline.
/// @throws exceptions of the steps. Cost: that of the steps, and one pass over the heights per step.
[[nodiscard]] PipelineResult apply(const Pipeline& pipeline, topography::Measurement measurement,
                                   const LoadMeasurement& load = {}, parallel::Threads threads = {});

}  // namespace setae::processing
