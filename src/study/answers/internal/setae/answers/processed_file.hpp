// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/formats/channel.hpp"
#include "setae/output/json.hpp"
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

/// "input", "output" (null where nothing was written), "channel" and "steps".
[[nodiscard]] output::Json to_json(const ProcessedFile& processed, const std::string& output = {});

/// "pipeline" and "files".
[[nodiscard]] output::Json processing_json(const processing::Pipeline& pipeline, const output::Json& files);

}  // namespace setae::answers
