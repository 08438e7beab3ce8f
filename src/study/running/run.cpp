// SPDX-License-Identifier: GPL-3.0-or-later
#include "run.hpp"

#include "setae/cache/key.hpp"
#include "setae/core/errors.hpp"
#include "setae/study/pipeline_file.hpp"

namespace setae::study {
namespace {

/// Adds the content of files; false where that of one is unknown.
bool add_content(cache::KeyBuilder& key, const Run& run, const std::vector<std::string>& files) {
    for (const auto& file : files) {
        const auto digest = run.digest(file);
        if (digest.empty()) return false;
        key.add("content", digest);
    }
    return true;
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
    for (const auto& input : inputs) digests_[input.path] = input.sha256;
}

std::string Run::digest(const std::string& file) const {
    const auto found = digests_.find(file);
    return found == digests_.end() ? std::string() : found->second;
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

std::string measurement_key(const Run& run, const MeasurementInput& input, std::size_t ordinal,
                            const SurfaceAnalysisOptions& options) {
    cache::KeyBuilder key("measurement");
    // what analyse_measurement() looks at
    SurfaceAnalysisOptions relevant;
    relevant.window = options.window;
    relevant.contours = options.contours;
    relevant.tip_percentile = options.tip_percentile;
    relevant.largest_map = options.largest_map;
    key.add("input", bytes_of(input)).add("ordinal", std::to_string(ordinal)).add("options", bytes_of(relevant));
    return add_content(key, run, files_of(input)) ? key.key() : std::string();
}

std::string surface_key(const Run& run, const SurfaceInput& input, const SurfaceAnalysisOptions& options) {
    cache::KeyBuilder key("surface");
    auto relevant = options;
    relevant.cutoff_scan.clear();
    key.add("input", bytes_of(input)).add("options", bytes_of(relevant));
    for (const auto& measurement : input.measurements)
        if (!add_content(key, run, files_of(measurement))) return {};
    return key.key();
}

std::string experiment_key(const Run& run, const ExperimentInput& input, const loops::LensAndCounterBody& bodies) {
    cache::KeyBuilder key("experiment");
    key.add("input", bytes_of<LoopSource>(input))
        .add("bodies", bytes_of(bodies))
        .add("options", bytes_of(input.options))
        .add("calibration", bytes_of(calibration_of(input)));
    return add_content(key, run, input.files()) ? key.key() : std::string();
}

std::string edge_key(const std::string& of_experiment) {
    if (of_experiment.empty()) return {};
    cache::KeyBuilder key("speed of an edge");
    key.add("experiment", of_experiment);
    return key.key();
}

std::string derivatives_key(const std::string& of_experiment, const std::vector<UncertainInput>& inputs) {
    if (of_experiment.empty()) return {};
    cache::KeyBuilder key("loop derivatives");
    key.add("experiment", of_experiment);
    for (const auto& input : inputs) key.add("input", loops::shared_input_name(input.input));
    return key.key();
}

}  // namespace setae::study
