// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "serialization.hpp"
#include "setae/study/provenance.hpp"
#include "setae/study/run_options.hpp"

namespace setae::study {

/// Key of a stored result, and the files on whose content it depends.
struct ResultKey {
    std::string text;  ///< as of cache::KeyBuilder; empty: the result is not kept
    std::vector<std::string> files;

    [[nodiscard]] bool empty() const { return text.empty(); }
};

/// One run of a study: access of its steps to the store, and progress.
class Run {
public:
    /// Without store and progress.
    Run() = default;
    Run(const RunOptions& options, const std::vector<InputFile>& inputs);

    /// SHA-256 of an input's content; empty where it is not known.
    [[nodiscard]] std::string digest(const std::string& file) const;
    /// Adds steps to the expected ones, each with an amount of work.
    void expect(std::size_t steps, double work);
    void step_begins(const std::string& stage, const std::string& item);
    void step_done(const std::string& stage, const std::string& item, bool cached, double work);
    [[nodiscard]] bool cancelled() const { return options_.cancelled && *options_.cancelled; }
    /// @throws Cancelled on request of the caller.
    void stop_if_cancelled() const;

    /// The result under a key; empty where there is no key, no store or no such result.
    template <class T>
    [[nodiscard]] std::optional<T> find(const ResultKey& key) const {
        if (key.empty() || !options_.store) return std::nullopt;
        auto bytes = options_.store->find(key.text);
        return bytes ? value_of<T>(*bytes) : std::nullopt;
    }
    /// Not stored where a file has changed since its digest was taken, because the value may be that of another
    /// content, and where the run is stopped, because an iteration may be incomplete.
    template <class T>
    void keep(const ResultKey& key, const T& value) const {
        if (cancelled() || key.empty() || !options_.store || !are_unchanged(key.files)) return;
        options_.store->keep(key.text, bytes_of(value));
    }
    /// Whether find() would give something.
    [[nodiscard]] bool holds(const ResultKey& key) const {
        return !key.empty() && options_.store && options_.store->holds(key.text);
    }

private:
    [[nodiscard]] bool are_unchanged(const std::vector<std::string>& files) const;
    void say(const std::string& stage, const std::string& item, bool begins, bool cached) const;

    RunOptions options_;
    std::map<std::string, InputFile> inputs_;
    std::mutex mutex_;
    std::size_t done_ = 0, total_ = 0;
    double work_done_ = 0.0, work_computed_ = 0.0, work_ = 0.0;
};

/// Whether the likelihood's spectrum is computed for a number of measurements: not for a single one.
[[nodiscard]] bool wants_likelihood(const SurfaceAnalysisOptions& options, std::ptrdiff_t measurements);

/// Expected work of steps, in measurements, for the remaining time of a progress bar.
inline constexpr double measurement_work = 1.0, experiment_work = 0.5;
[[nodiscard]] double surface_work(const SurfaceAnalysisOptions& options, std::size_t measurements);

/// Keys of results, from the content of their files and all settings they depend on; empty where a file's content is
/// unknown.
[[nodiscard]] ResultKey measurement_key(const Run& run, const MeasurementInput& input, std::size_t ordinal,
                                        const SurfaceAnalysisOptions& options);
[[nodiscard]] ResultKey surface_key(const Run& run, const SurfaceInput& input, const SurfaceAnalysisOptions& options);
[[nodiscard]] ResultKey edge_key(const ResultKey& of_experiment);
[[nodiscard]] ResultKey experiment_key(const Run& run, const ExperimentInput& input,
                                       const loops::LensAndCounterBody& bodies);
/// Key of the derivatives of an experiment's numbers by some of its inputs. key: that of the experiment, or empty.
[[nodiscard]] ResultKey derivatives_key(const ResultKey& of_experiment, const std::vector<UncertainInput>& inputs);

}  // namespace setae::study
