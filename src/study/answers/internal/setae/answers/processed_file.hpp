// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "setae/fields/describe.hpp"
#include "setae/formats/channel.hpp"
#include "setae/output/step_fields.hpp"
#include "setae/processing/pipeline.hpp"

namespace setae::answers {

/// Heights of a file before and after a pipeline.
struct ProcessedFile {
    std::string file;
    formats::ChannelInfo channel;
    topography::Measurement before;
    processing::PipelineResult result;
};

/// The requested channel, or the first with heights, processed by a pipeline. @throws what reading and the steps throw.
[[nodiscard]] ProcessedFile processed_file(const std::string& file, const formats::ReadOptions& options,
                                           const formats::ChannelChoice& channel, const processing::Pipeline& pipeline,
                                           parallel::Threads threads = {});

/// Results of the steps for a file, without heights.
struct ProcessingRecord {
    std::string input;
    std::string output;   ///< empty where nothing was written
    std::string channel;  ///< name of the channel
    std::vector<processing::StepRecord> steps;
};
[[nodiscard]] ProcessingRecord record_of(const ProcessedFile& processed, const std::string& output = {});

/// The answer of `setae level`.
struct ProcessingRecords {
    std::vector<std::string> pipeline;  ///< lines of study::step_lines()
    std::vector<ProcessingRecord> files;
};

}  // namespace setae::answers

template <>
struct setae::fields::Described<setae::answers::ProcessingRecord> {
    using T = answers::ProcessingRecord;
    static constexpr std::array rows{
        field<&T::input>("input", "name of the input as it was given"),
        field<&T::output>("output", "path of the file that was written; null where nothing was written").or_null(),
        field<&T::channel>("channel", "name of the channel"),
        field<&T::steps>("steps", "results of each step"),
    };
    static constexpr Description description{"", "a file that was processed", rows};
};
static_assert(setae::fields::complete<setae::answers::ProcessingRecord>);

template <>
struct setae::fields::Described<setae::answers::ProcessingRecords> {
    using T = answers::ProcessingRecords;
    static constexpr std::array rows{
        field<&T::pipeline>("pipeline", "steps of the pipeline"),
        field<&T::files>("files", "files that were processed"),
    };
    static constexpr Description description{"", "results of each processing step", rows};
};
static_assert(setae::fields::complete<setae::answers::ProcessingRecords>);
