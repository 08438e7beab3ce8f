// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/processing/steps.hpp"

namespace setae::processing {

/// A step of a pipeline, and whether it is done.
struct Entry {
    Step step;
    bool on = true;
};

/// What is done to heights before they are analysed, in order: a value that is written to a file and done to n
/// measurements.
struct Pipeline {
    std::vector<Entry> entries;

    /// Whether it leaves heights as they are.
    [[nodiscard]] bool empty() const;
};

/// A measurement after a pipeline, with the record of every step that was done.
struct PipelineResult {
    topography::Measurement measurement;
    std::vector<StepRecord> records;
};

/// The steps that are on, one after the other.
///
/// Each record ends with the rms height Sq (lines: Rq) after its step. metadata.attributes["pipeline"] of the result
/// has the text of each step, separated by " | ", behind what an earlier pipeline left there.
/// @throws what a step throws. Cost: the steps', and one pass over the heights for each.
[[nodiscard]] PipelineResult apply(const Pipeline& pipeline, topography::Measurement measurement,
                                   const LoadMeasurement& load = {}, parallel::Threads threads = {});

}  // namespace setae::processing
