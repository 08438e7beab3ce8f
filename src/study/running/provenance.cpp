// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/provenance.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "setae/bytes/digest.hpp"
#include "setae/bytes/source.hpp"
#include "setae/core/errors.hpp"
#include "setae/study/pipeline_file.hpp"

extern const char* const setae_source_digest;  // cmake/source_digest.cmake

namespace setae::study {
namespace {

std::vector<std::string> named_files(const Study& study) {
    std::vector<std::string> files{study.path};
    const auto add = [&files](const std::string& file) {
        if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
    };
    for (const auto& surface : study.surfaces) {
        if (surface.power_spectrum) add(*surface.power_spectrum);
        for (const auto& measurement : surface.measurements) {
            add(measurement.file);
            for (const auto& reference : measurement.references) add(reference);
            if (measurement.tip_file) add(*measurement.tip_file);
            if (measurement.pipeline) add(*measurement.pipeline);
            for (const auto& file : files_of_steps(measurement.steps)) add(file);
        }
    }
    for (const auto& experiment : study.experiments)
        for (const auto& file : experiment.files()) add(file);
    return files;
}

}  // namespace

std::vector<InputFile> input_files(const Study& study, parallel::Threads threads) {
    const auto names = named_files(study);
    std::vector<InputFile> inputs(names.size());
    parallel::for_each_index(names.size(), threads, [&](std::size_t i) {
        inputs[i].path = names[i];
        try {
            const auto source = bytes::file_source(names[i]);
            inputs[i].sha256 = bytes::sha256(source);
            inputs[i].size = source.size;
        } catch (const FileError&) {
            // without digest: whoever reads the file says why
        }
    });
    return inputs;
}

std::string version() { return fmt::format("{}+{}", SETAE_VERSION, setae_source_digest); }

}  // namespace setae::study
