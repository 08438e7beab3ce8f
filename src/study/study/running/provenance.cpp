// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/provenance.hpp"

#include <cstdint>
#include <set>

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
    std::set<std::string> named(files.begin(), files.end());
    const auto add = [&](const std::string& file) {
        if (named.insert(file).second) files.push_back(file);
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

/// Time between two changes of a file that have equal times of change [ns], with a margin: systems count it in
/// hundredths of a second.
constexpr std::int64_t clock_step = 50'000'000;

/// The digest of a file's content, and its state before and after. @throws FileError where it cannot be read.
InputFile digested(const std::string& path) {
    InputFile input{.path = path};
    input.state = bytes::file_state(path);
    const auto source = bytes::file_source(path);
    input.sha256 = bytes::sha256(source);
    input.size = source.size;
    input.settled = bytes::age_of_change(path) > clock_step;
    if (bytes::file_state(path) != input.state) throw FileError(path + ": the file changed while it was read");
    return input;
}

/// The same once more where another program changed the file meanwhile.
InputFile input_file(const std::string& path) {
    InputFile input{.path = path};
    constexpr int max_tries = 3;
    for (int i = 0; i < max_tries; ++i) {
        const auto before = bytes::file_state(path);
        try {
            return digested(path);
        } catch (const FileError&) {
            // without digest: reading the file later reports the reason
            input.changed = bytes::file_state(path) != before;
        }
        if (!input.changed) break;
    }
    return input;
}

}  // namespace

bool is_unchanged(const InputFile& input) {
    if (input.sha256.empty() || bytes::file_state(input.path) != input.state) return false;
    if (input.settled) return true;
    try {
        return bytes::sha256(bytes::file_source(input.path)) == input.sha256;
    } catch (const FileError&) {
        return false;
    }
}

std::vector<InputFile> input_files(const Study& study, parallel::Threads threads) {
    const auto names = named_files(study);
    std::vector<InputFile> inputs(names.size());
    parallel::for_each_index(names.size(), threads, [&](std::size_t i) { inputs[i] = input_file(names[i]); });
    return inputs;
}

std::string version() { return fmt::format("{}+{}", SETAE_VERSION, setae_source_digest); }

}  // namespace setae::study
