// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "serialization.hpp"
#include "setae/workflow/provenance.hpp"
#include "setae/workflow/run_options.hpp"

namespace setae::workflow {

/// One run of a study: what its steps ask of the store, and what they say when they are done.
class Run {
public:
    /// Without store and progress.
    Run() = default;
    Run(const RunOptions& options, const std::vector<InputFile>& inputs);

    /// SHA-256 of an input's content; empty where it is not known.
    [[nodiscard]] std::string digest(const std::string& file) const;
    [[nodiscard]] const cache::Store* store() const { return options_.store; }
    /// Steps that are still to come beside those known.
    void expect(std::size_t steps);
    void step_done(const std::string& stage, const std::string& item, bool cached);
    [[nodiscard]] bool cancelled() const { return options_.cancelled && *options_.cancelled; }
    /// @throws Cancelled where the caller asked for it.
    void stop_if_cancelled() const;

    /// The result under a key; nothing where there is no key, no store or no such result.
    template <class T>
    [[nodiscard]] std::optional<T> find(const std::string& key) const {
        if (key.empty() || !options_.store) return std::nullopt;
        auto bytes = options_.store->find(key);
        return bytes ? value_of<T>(std::move(*bytes)) : std::nullopt;
    }
    template <class T>
    void keep(const std::string& key, const T& value) const {
        if (!key.empty() && options_.store) options_.store->keep(key, bytes_of(value));
    }

private:
    RunOptions options_;
    std::map<std::string, std::string> digests_;
    std::mutex mutex_;
    std::size_t done_ = 0, total_ = 0;
};

/// Keys of results, from the content of their files and all settings they depend on; empty where a file's content is unknown.
[[nodiscard]] std::string measurement_key(const Run& run, const MeasurementInput& input, std::size_t ordinal, const AnalysisOptions& options);
[[nodiscard]] std::string surface_key(const Run& run, const SurfaceInput& input, const AnalysisOptions& options);
[[nodiscard]] std::string experiment_key(const Run& run, const ExperimentInput& input, const experiment::LensAndCounterBody& bodies);

}  // namespace setae::workflow
