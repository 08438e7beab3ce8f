// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/closure/closure.hpp"

#include <filesystem>
#include <mutex>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::closure {
namespace {

namespace fs = std::filesystem;

/// What one run leaves.
struct RunResult {
    std::vector<Comparison> comparisons;
    std::string failure;
};

workflow::Study study_of(const std::string& folder, const ClosureOptions& options) {
    auto study = workflow::read_study((fs::path(folder) / "study.toml").string());
    study.analysis.spectrum = options.spectrum;
    study.analysis.likelihood.tip_factor = options.tip_factor;
    study.analysis.likelihood.tip_band = options.tip_band;
    return study;
}

/// The same study as [D19] would do it.
workflow::Study by_paper(workflow::Study study) {
    study.analysis.spectrum = workflow::SpectrumMethod::average;
    study.analysis.conversion = roughness::Conversion::eq11;
    study.analysis.contours = spectra::ContourTreatment::segments;
    return study;
}

RunResult run_once(const std::string& recipe_file, int run, const ClosureOptions& options) {
    RunResult result;
    constexpr parallel::Threads one{1};
    const auto folder = (fs::path(options.folder) / fmt::format("run_{:04}", run)).string();
    try {
        const auto recipe = laboratory::read_recipe(recipe_file, options.first_seed + static_cast<std::uint64_t>(run));
        const auto planted = planted_in(recipe);
        laboratory::make(recipe, folder, one);
        const auto study = study_of(folder, options);
        result.comparisons = comparisons(run, recipe, planted, workflow::run_study(study, one));
        const auto paper = comparisons_by_paper(run, recipe, planted, workflow::run_study(by_paper(study), one));
        result.comparisons.insert(result.comparisons.end(), paper.begin(), paper.end());
    } catch (const Error& error) {
        result.failure = error.what();
    }
    std::error_code ignored;
    if (!options.keep) fs::remove_all(folder, ignored);
    return result;
}

}  // namespace

Closure run_closure(const std::string& recipe, const ClosureOptions& options) {
    if (options.runs < 1) throw InvalidArgument(fmt::format("{} runs; expected at least 1", options.runs));
    (void)laboratory::read_recipe(recipe);  // what is wrong in it is said once, not once a run
    std::error_code error;
    fs::create_directories(options.folder, error);
    if (error) throw FileError(fmt::format("{}: cannot make the folder: {}", options.folder, error.message()));
    std::vector<RunResult> results(static_cast<std::size_t>(options.runs));
    std::mutex counting;
    int done = 0;
    parallel::for_each_index(results.size(), options.threads, [&](std::size_t r) {
        results[r] = run_once(recipe, static_cast<int>(r), options);
        const std::lock_guard lock(counting);
        ++done;
        if (options.progress) options.progress(done);
    });
    Closure closure;
    for (std::size_t r = 0; r < results.size(); ++r) {
        auto& result = results[r];
        closure.comparisons.insert(closure.comparisons.end(), result.comparisons.begin(), result.comparisons.end());
        if (!result.failure.empty()) closure.failed.push_back({options.first_seed + r, std::move(result.failure)});
    }
    return closure;
}

}  // namespace setae::closure
