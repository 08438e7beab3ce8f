// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/processed_file.hpp"

#include "setae/study/pipeline_file.hpp"

namespace setae::answers {

ProcessedFile processed_file(const std::string& file, const formats::ReadOptions& options,
                             const formats::ChannelChoice& channel, const processing::Pipeline& pipeline,
                             parallel::Threads threads) {
    const auto channels = formats::open(file, options);
    const auto& chosen = channels[formats::chosen_channels(file, channels, channel).front()];
    ProcessedFile processed{.file = file, .channel = chosen.info, .before = chosen.read(), .result = {}};
    processed.result = processing::apply(pipeline, processed.before, study::measurement_loader(options), threads);
    return processed;
}

ProcessingRecord record_of(const ProcessedFile& processed, const std::string& output) {
    return {processed.file, output, processed.channel.name, processed.result.records};
}

}  // namespace setae::answers
