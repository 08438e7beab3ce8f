// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/pipeline.hpp"

#include <algorithm>
#include <utility>

#include "setae/processing/step_text.hpp"
#include "step_record.hpp"

namespace setae::processing {

bool Pipeline::empty() const {
    return std::none_of(entries.begin(), entries.end(), [](const Entry& entry) { return entry.on; });
}

PipelineResult apply(const Pipeline& pipeline, topography::Measurement measurement, const LoadMeasurement& load,
                     parallel::Threads threads) {
    PipelineResult result{std::move(measurement), {}};
    for (const auto& entry : pipeline.entries) {
        if (!entry.on) continue;
        auto processed = apply(entry.step, std::move(result.measurement), load, threads);
        result.measurement = std::move(processed.measurement);
        if (auto rms = rms_height(result.measurement, threads)) processed.record.numbers.push_back(std::move(*rms));
        result.records.push_back(std::move(processed.record));
        auto& note = topography::metadata(result.measurement).attributes["pipeline"];
        note += (note.empty() ? "" : " | ") + text(entry.step);
    }
    return result;
}

}  // namespace setae::processing
