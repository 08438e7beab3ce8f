// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "results/failed_part.hpp"
#include "results/losses_of_works.hpp"
#include "results/pairs.hpp"
#include "results/same_measurements.hpp"
#include "run.hpp"
#include "setae/core/errors.hpp"
#include "setae/parallel/cancellation.hpp"
#include "setae/study/hysteresis.hpp"
#include "setae/study/open_loop.hpp"
#include "setae/study/study_result.hpp"
#include "surfaces/surface_run.hpp"

namespace setae::study {
namespace {

/// Memory of the heights of a surface [bytes], from the sizes of its files.
double memory_of(const SurfaceInput& surface) {
    constexpr double bytes_per_byte = 4.0;  // heights of 16 bits become doubles
    std::set<std::string> files;
    for (const auto& m : surface.measurements) files.insert(m.file);
    double sum = 0.0;
    for (const auto& file : files) {
        std::error_code missing;
        const auto size = std::filesystem::file_size(file, missing);
        if (!missing) sum += bytes_per_byte * static_cast<double>(size);
    }
    return sum;
}

/// Surfaces in parallel, as many as there are threads and memory for their heights; remaining threads are used within
/// each.
std::vector<SurfaceResult> analyse_surfaces(const Study& study, Run& run, parallel::Threads threads) {
    constexpr double max_memory = 2e9;  // [bytes]
    std::vector<double> memory;
    for (const auto& surface : study.surfaces) memory.push_back(memory_of(surface));
    std::sort(memory.rbegin(), memory.rend());
    int at_once = 0;
    for (double sum = 0.0; at_once < std::min<int>(threads.resolved(), static_cast<int>(memory.size())); ++at_once) {
        sum += memory[static_cast<std::size_t>(at_once)];
        if (at_once > 0 && sum > max_memory) break;
    }
    std::vector<SurfaceResult> results(study.surfaces.size());
    const parallel::Threads inside{threads.resolved() / std::max(1, at_once)};
    parallel::for_each_index(results.size(), {std::max(1, at_once)}, [&](std::size_t i) {
        run.stop_if_cancelled();
        results[i] = analyse_surface(study.surfaces[i], study.analysis, run, inside).surface;
    });
    return results;
}

/// @throws InvalidArgument without a radius of the sphere.
loops::LensAndCounterBody bodies_of(const ExperimentInput& input, const Study& study) {
    const auto& elastomer = *study.elastomer(input.elastomer);
    const auto radius = input.sphere_radius ? input.sphere_radius : elastomer.sphere_radius;
    if (!radius)
        throw InvalidArgument(
            fmt::format("{}: no sphere_radius is given, neither for the experiment nor for elastomer '{}'", input.file,
                        elastomer.name));
    loops::LensAndCounterBody bodies;
    bodies.radius = radius->value;
    bodies.lens_poisson_ratio = elastomer.poisson_ratio.value;
    bodies.counter_youngs_modulus = study.counter_youngs_modulus;
    bodies.counter_poisson_ratio = study.counter_poisson_ratio;
    if (elastomer.sphere_height) bodies.lens_height = elastomer.sphere_height->value;
    return bodies;
}

/// The experiment with the time dependence of its elastomer.
ExperimentInput with_relaxation(ExperimentInput input, const Study& study) {
    for (const auto& term : study.elastomer(input.elastomer)->relaxation)
        input.options.relaxation.push_back({term.share.value, term.time.value});
    return input;
}

/// A loop's record, calibrations applied: opened when it is first needed.
class Record {
public:
    Record(const ExperimentInput& input) : input_(input) {}

    const OpenedLoop& opened() {
        if (!opened_) {
            opened_ = open_loop(input_);
            apply(calibration_of(input_), *opened_);
        }
        return *opened_;
    }

private:
    const ExperimentInput& input_;
    std::optional<OpenedLoop> opened_;
};

/// Contributions of shared inputs to an experiment's numbers.
LoopDependence dependence_of(const ExperimentResult& result, const std::vector<UncertainInput>& inputs,
                             const ResultKey& key, Record& record, const Run& run) {
    if (inputs.empty()) return {};
    const auto kept_under = derivatives_key(key, inputs);
    auto derivatives = run.find<std::vector<LoopNumbers>>(kept_under);
    if (!derivatives || derivatives->size() != inputs.size()) {
        derivatives = derivatives_of(loops::loop_from_table(record.opened().table), result.bodies, result.input.options,
                                     *result.analysis, inputs);
        run.keep(kept_under, *derivatives);
    }
    return dependence_of(numbers_of(*result.analysis), inputs, *derivatives);
}

/// Rate dependence of the edge of a reference, or the reason for which its record does not give it.
loops::Outcome<loops::CrackSpeedFit> edge_speed_of(const ExperimentResult& result, const ResultKey& key,
                                                   const Run& run) {
    using Fit = loops::Outcome<loops::CrackSpeedFit>;
    const auto kept_under = edge_key(key);
    if (auto kept = run.find<Fit>(kept_under)) return *kept;
    Fit fit;
    try {
        const auto& analysis = *result.analysis;
        fit = loops::fit_crack_speed(loops::retracting_edge(analysis, result.input.options), result.bodies.radius,
                                     analysis.loading.primary().contact_modulus);
    } catch (const Error& error) {
        fit = Fit::missing(error.what());
    }
    run.keep(kept_under, fit);
    return fit;
}

ExperimentResult analyse_experiment(const ExperimentInput& stated, const Study& study, Run& run) {
    const auto input = with_relaxation(stated, study);
    ExperimentResult result;
    result.input = input;
    bool cached = false;
    run.step_begins("experiment", input.file);
    try {
        result.bodies = bodies_of(input, study);
        const auto& bodies = result.bodies;
        const auto key = experiment_key(run, input, bodies);
        result.analysis = run.find<loops::LoopAnalysis>(key);
        cached = result.analysis.has_value();
        Record record(input);
        result.input.options = loops::calibrated(input.options, calibration_of(input));
        const auto& options = result.input.options;
        if (!cached) {
            result.analysis = analyse_loop(record.opened(), input.file, bodies, options);
            run.keep(key, *result.analysis);
        }
        result.alerts = result.analysis->alerts;
        const auto inputs = uncertain_inputs(input, *study.elastomer(input.elastomer));
        result.dependence = dependence_of(result, inputs, key, record, run);
        for (const auto& lost : result.dependence.lost)
            result.alerts.push_back(
                {"INPUT_LOST", input.file, lost,
                 "its standard error is missing in all results of the loop: set the segments in `segments`, or "
                 "look at the warnings of the loop"});
        if (input.reference && !study.elastomer(input.elastomer)->crack_speed)
            result.edge_speed = edge_speed_of(result, key, run);
        if (input.models.any()) result.models = loop_models(*result.analysis, bodies, options, input.models);
    } catch (const std::exception& error) {
        result.error = reason_of(error, input.file);
    }
    run.step_done("experiment", input.file, cached, experiment_work);
    return result;
}

void expect_steps(const Study& study, Run& run) {
    for (const auto& surface : study.surfaces) {
        run.expect(surface.measurements.size(), measurement_work);
        run.expect(1, surface_work(study.analysis, surface.measurements.size()));
    }
    run.expect(study.experiments.size(), experiment_work);
}

/// Results from all surfaces and loops of a study.
void bring_together(StudyResult& result) {
    for (const auto& input : result.study.elastomers) {
        ElastomerResult elastomer{.input = input};
        isolated(elastomer.alerts, "elastomer " + input.name, [&] { elastomer = elastomer_result(input, result); });
        result.elastomers.push_back(std::move(elastomer));
    }
    isolated(result.alerts, "repeated loops", [&] { result.replicates = elastomer_replicates(result); });
    result.pairs = measured_pairs(result);
    isolated(result.alerts, "smooth references", [&] { evaluate_references(result); });
    const bool likelihoods = std::any_of(result.surfaces.begin(), result.surfaces.end(),
                                         [](const auto& s) { return s.method == SpectrumMethod::likelihood; });
    if (likelihoods) {
        result.by_average = Conclusions{.of_averages = true, .pairs = result.pairs};
        conclude(result, *result.by_average);
    }
    conclude(result, result);
    isolated(result.alerts, "losses of the measured works", [&] {
        compare_losses_with_works(result);
        result.loss_slope_of_works = loss_slope_of_works(result);
    });
    for (const auto& alert : result.failed_parts) result.alerts.push_back(alert);
    if (result.by_average)
        for (auto alert : result.by_average->failed_parts) {
            alert.subject += ", by averages";
            result.alerts.push_back(std::move(alert));
        }
}

/// Retraction of pairs, where that does not take minutes.
Outcome<Hysteresis> retraction_fold_of(StudyResult& result, parallel::Threads threads) {
    using Missing = Outcome<Hysteresis>;
    const auto measured = std::ranges::count_if(
        result.pairs, [](const PairResult& pair) { return pair.approach && (pair.retraction || pair.pull_off); });
    if (measured > max_ranked_by_studies)
        return Missing::missing(
            fmt::format("ranking retraction models over {} pairs takes minutes; run setae predict {}", measured,
                        result.study.path));
    try {
        return hysteresis_of(result, {}, threads);
    } catch (const UndefinedDataError& error) {
        return Missing::missing(error.what());
    } catch (const InvalidArgument& error) {  // consequence of a wrong input
        add_failed_part(result.alerts, "retraction by roughness", error.what());
        return Missing::missing(error.what());
    }
}

/// Iterations below end on request of the caller.
class StopWhenCancelled {
public:
    explicit StopWhenCancelled(const RunOptions& options) {
        if (options.cancelled) scope_.emplace(*options.cancelled);
    }

private:
    std::optional<parallel::CancellationScope> scope_;
};

/// Files that other programs changed since the run began: results may be those of the old content, the new one or both.
void look_for_changed_inputs(StudyResult& result) {
    for (auto& input : result.inputs) {
        if (!input.sha256.empty()) input.changed = !is_unchanged(input);
        if (!input.changed) continue;
        input.sha256.clear();
        result.alerts.push_back(
            {"INPUT_CHANGED", input.path,
             "another program changed this file during the run; results may be those of its old or of its "
             "new content, and are not kept for later runs",
             "wait until the file is complete, then run the study again"});
    }
}

}  // namespace

StudyResult predicted_study(Study study, SurfaceResult surface) {
    StudyResult result;
    result.study = std::move(study);
    result.surfaces.push_back(std::move(surface));
    bring_together(result);
    return result;
}

StudyResult run_study(Study study, const RunOptions& options) {
    StudyResult result;
    result.study = std::move(study);
    const auto& inputs = result.study;
    result.alerts = inputs.alerts;
    result.inputs = input_files(inputs, options.threads);
    Run run(options, result.inputs);
    const StopWhenCancelled stop(options);
    expect_steps(inputs, run);
    if (inputs.surfaces.empty() && inputs.experiments.empty())
        result.alerts.push_back({"EMPTY_STUDY", inputs.title,
                                 "the study names no surface and no experiment, so that it has no results",
                                 "add [surfaces.NAME] or [[experiments]], see docs/guides/study.md"});
    result.surfaces = analyse_surfaces(inputs, run, options.threads);
    result.experiments.resize(inputs.experiments.size());
    parallel::for_each_index(inputs.experiments.size(), options.threads, [&](std::size_t i) {
        if (!run.cancelled()) result.experiments[i] = analyse_experiment(inputs.experiments[i], inputs, run);
    });
    run.stop_if_cancelled();
    look_for_changed_inputs(result);
    look_for_same_loops(result);
    bring_together(result);
    result.hysteresis = retraction_fold_of(result, options.threads);
    if (result.hysteresis)
        result.alerts.insert(result.alerts.end(), result.hysteresis->alerts.begin(), result.hysteresis->alerts.end());
    run.stop_if_cancelled();  // parts that were stopped are none that failed
    return result;
}

std::vector<PlannedStep> planned_steps(const Study& study, const RunOptions& options) {
    const Run run(options, input_files(study, options.threads));
    std::vector<PlannedStep> steps;
    for (const auto& surface : study.surfaces)
        for (auto& step : planned_steps(surface, study.analysis, run)) steps.push_back(std::move(step));
    for (const auto& input : study.experiments) {
        PlannedStep step{"experiment", input.file, {}, false};
        try {
            const auto key = experiment_key(run, with_relaxation(input, study), bodies_of(input, study));
            if (key.empty()) throw FileError(fmt::format("{}: cannot be read", input.file));
            step.cached = run.holds(key);
        } catch (const std::exception& error) {
            step.error = reason_of(error, input.file);
        }
        steps.push_back(std::move(step));
    }
    return steps;
}

}  // namespace setae::study
