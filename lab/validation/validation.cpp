// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/validation/validation.hpp"

#include <algorithm>

#include "data_sets.hpp"

namespace setae::validation {
namespace {

study::Study study_of(const std::string& folder, const ValidationOptions& options) {
    auto study = study_of_data_set(folder);
    study.analysis.spectrum = options.spectrum;
    study.analysis.likelihood.tip_factor = options.tip_factor;
    study.analysis.likelihood.tip_band = options.tip_band;
    return study;
}

/// The same study as [D19] would do it.
study::Study by_paper(study::Study study) {
    study.analysis.spectrum = study::SpectrumMethod::average;
    study.analysis.conversion = roughness::Conversion::eq11;
    study.analysis.contours = spectra::ContourTreatment::segments;
    return study;
}

}  // namespace

Validation run_validation(const std::string& recipe, const ValidationOptions& options) {
    const DataSets sets{recipe,       options.folder,  options.runs,    options.first_seed,
                        options.keep, options.threads, options.progress};
    std::vector<std::vector<Comparison>> found(static_cast<std::size_t>(std::max(options.runs, 0)));
    auto failures = for_each_data_set(sets, [&](int run, const simulation::Recipe& made, const std::string& folder) {
        constexpr parallel::Threads one{1};
        const auto true_values = true_values_of(made);
        const auto study = study_of(folder, options);
        auto rows = comparisons(run, made, true_values, study::run_study(study, {one}));
        const auto paper = comparisons_by_paper(run, made, true_values, study::run_study(by_paper(study), {one}));
        rows.insert(rows.end(), paper.begin(), paper.end());
        found[static_cast<std::size_t>(run)] = std::move(rows);
    });
    Validation validation;
    for (std::size_t r = 0; r < failures.size(); ++r) {
        validation.comparisons.insert(validation.comparisons.end(), found[r].begin(), found[r].end());
        if (!failures[r].empty()) validation.failed.push_back({options.first_seed + r, std::move(failures[r])});
    }
    return validation;
}

}  // namespace setae::validation
