// SPDX-License-Identifier: GPL-3.0-or-later
#include "run.hpp"

#include <algorithm>
#include <utility>

#include "setae/cache/key.hpp"
#include "setae/core/errors.hpp"
#include "setae/study/pipeline_file.hpp"

namespace setae::study {
namespace {

/// The key with the content of files; none where that of one is unknown.
ResultKey with_content(cache::KeyBuilder& key, const Run& run, std::vector<std::string> files) {
    for (const auto& file : files) {
        const auto digest = run.digest(file);
        if (digest.empty()) return {};
        key.add("content", digest);
    }
    return {key.key(), std::move(files)};
}

std::vector<std::string> files_of(const MeasurementInput& input) {
    auto files = input.references;
    files.push_back(input.file);
    if (input.tip_file) files.push_back(*input.tip_file);
    const auto named = files_of_steps(input.steps);
    files.insert(files.end(), named.begin(), named.end());
    return files;
}

}  // namespace

Run::Run(const RunOptions& options, const std::vector<InputFile>& inputs) : options_(options) {
    for (const auto& input : inputs) inputs_[input.path] = input;
}

std::string Run::digest(const std::string& file) const {
    const auto found = inputs_.find(file);
    return found == inputs_.end() ? std::string() : found->second.sha256;
}

bool Run::are_unchanged(const std::vector<std::string>& files) const {
    return std::all_of(files.begin(), files.end(), [&](const auto& file) {
        const auto found = inputs_.find(file);
        return found != inputs_.end() && is_unchanged(found->second);
    });
}

void Run::expect(std::size_t steps, double work) {
    const std::lock_guard lock(mutex_);
    total_ += steps;
    work_ += static_cast<double>(steps) * work;
}

void Run::say(const std::string& stage, const std::string& item, bool begins, bool cached) const {
    if (options_.progress)
        options_.progress({stage, item, begins, cached, done_, total_, work_done_ / work_, work_computed_ / work_});
}

void Run::step_begins(const std::string& stage, const std::string& item) {
    const std::lock_guard lock(mutex_);
    say(stage, item, true, false);
}

void Run::step_done(const std::string& stage, const std::string& item, bool cached, double work) {
    const std::lock_guard lock(mutex_);
    ++done_;
    work_done_ += work;
    if (!cached) work_computed_ += work;
    say(stage, item, false, cached);
}

void Run::stop_if_cancelled() const {
    if (cancelled()) throw Cancelled("stopped before all was done");
}

bool wants_likelihood(const SurfaceAnalysisOptions& options, std::ptrdiff_t measurements) {
    return options.spectrum ? *options.spectrum == SpectrumMethod::likelihood : measurements > 1;
}

double surface_work(const SurfaceAnalysisOptions& options, std::size_t measurements) {
    constexpr double share_of_a_fit = 8.0;
    return wants_likelihood(options, static_cast<std::ptrdiff_t>(measurements))
               ? share_of_a_fit * static_cast<double>(measurements)
               : 1.0;
}

ResultKey measurement_key(const Run& run, const MeasurementInput& input, std::size_t ordinal,
                          const SurfaceAnalysisOptions& options) {
    cache::KeyBuilder key("measurement");
    // options that analyse_measurement() uses
    SurfaceAnalysisOptions relevant;
    relevant.window = options.window;
    relevant.contours = options.contours;
    relevant.tip_percentile = options.tip_percentile;
    relevant.largest_map = options.largest_map;
    key.add("input", bytes_of(input)).add("ordinal", std::to_string(ordinal)).add("options", bytes_of(relevant));
    return with_content(key, run, files_of(input));
}

ResultKey surface_key(const Run& run, const SurfaceInput& input, const SurfaceAnalysisOptions& options) {
    cache::KeyBuilder key("surface");
    auto relevant = options;
    relevant.cutoff_scan.clear();
    key.add("input", bytes_of(input)).add("options", bytes_of(relevant));
    std::vector<std::string> files;
    for (const auto& measurement : input.measurements)
        for (auto& file : files_of(measurement)) files.push_back(std::move(file));
    return with_content(key, run, std::move(files));
}

ResultKey experiment_key(const Run& run, const ExperimentInput& input, const loops::LensAndCounterBody& bodies) {
    cache::KeyBuilder key("experiment");
    key.add("input", bytes_of<LoopSource>(input))
        .add("bodies", bytes_of(bodies))
        .add("options", bytes_of(input.options))
        .add("calibration", bytes_of(calibration_of(input)));
    return with_content(key, run, input.files());
}

ResultKey edge_key(const ResultKey& of_experiment) {
    if (of_experiment.empty()) return {};
    cache::KeyBuilder key("speed of an edge");
    key.add("experiment", of_experiment.text);
    return {key.key(), of_experiment.files};
}

ResultKey derivatives_key(const ResultKey& of_experiment, const std::vector<UncertainInput>& inputs) {
    if (of_experiment.empty()) return {};
    cache::KeyBuilder key("loop derivatives");
    key.add("experiment", of_experiment.text);
    for (const auto& input : inputs) key.add("input", loops::shared_input_name(input.input));
    return {key.key(), of_experiment.files};
}

}  // namespace setae::study
