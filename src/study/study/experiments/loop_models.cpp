// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/loop_models.hpp"

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::study {
namespace {

using loops::ContactModel;
using loops::FitErrors;

loops::ModelFitOptions options_of(const LoopModelOptions& options, ContactModel model) {
    loops::ModelFitOptions fit{.model = model, .errors = options.errors, .contact_point = options.contact_point};
    if (model == ContactModel::maugis_dugdale) fit.cohesive_stress = options.cohesive_stress;
    return fit;
}

/// Runs a requested computation; an error of the data becomes a sentence.
template <class Computation>
void attempt(LoopModels& models, const std::string& what, const Computation& computation) {
    try {
        computation();
    } catch (const std::exception& error) {
        models.failures.push_back(what + ": " + reason_of(error));
    }
}

loops::ProfileLikelihood profile_of(const loops::BranchData& data, const loops::LensAndCounterBody& bodies) {
    using loops::ProfiledFit;
    const auto fit = data.contact_radius.size() == 0 ? ProfiledFit::force_displacement
                     : data.displacement.size() == 0 ? ProfiledFit::effective_variance
                                                     : ProfiledFit::joint;
    return loops::profile_likelihood(data, bodies, {.fit = fit});
}

}  // namespace

FitErrors fit_errors_named(const std::string& name) {
    for (const auto errors : {FitErrors::orthogonal_distance, FitErrors::effective_variance, FitErrors::force_only})
        if (to_string(errors) == name) return errors;
    throw InvalidArgument(
        fmt::format("errors '{}'; expected orthogonal_distance, effective_variance or force_only", name));
}

ContactModel LoopModelOptions::shared_model() const {
    return models.size() == 1 && models.front() != "all" ? loops::model_named(models.front()) : ContactModel::jkr;
}

LoopModels loop_models(const loops::LoopAnalysis& analysis, const loops::LensAndCounterBody& bodies,
                       const loops::AnalysisOptions& analysis_options, const LoopModelOptions& options) {
    LoopModels models;
    const auto samples = [&] { return loops::branch_samples(analysis, options.branch, analysis_options).data; };
    for (const auto& name : options.models) {
        attempt(models, name, [&] {
            if (name == "all")
                models.comparison = loops::compare_models(samples(), bodies, options_of(options, ContactModel::jkr));
            else
                models.fits.push_back(
                    loops::fit_model(samples(), bodies, options_of(options, loops::model_named(name))));
        });
    }
    if (options.profile) attempt(models, "profile likelihood", [&] { models.profile = profile_of(samples(), bodies); });
    if (options.crack_speed)
        attempt(models, "crack speed", [&] {
            models.crack_speed =
                loops::fit_crack_speed(loops::retracting_edge(analysis, analysis_options), bodies.radius,
                                       analysis.loading.primary().contact_modulus, {.exponent = options.exponent});
        });
    return models;
}

loops::GlobalBranch branch_to_share(const std::string& name, const loops::LoopAnalysis& analysis,
                                    const loops::LensAndCounterBody& bodies,
                                    const loops::AnalysisOptions& analysis_options, const LoopModelOptions& options) {
    return {
        .name = name, .data = loops::branch_samples(analysis, options.branch, analysis_options).data, .bodies = bodies};
}

loops::GlobalFit shared_fit(const std::vector<loops::GlobalBranch>& loops, const LoopModelOptions& options) {
    if (loops.size() < 2)
        throw UndefinedDataError(
            fmt::format("{} of the loops can be fitted together; a shared fit needs at least 2", loops.size()));
    return loops::fit_globally(loops, {.share_contact_modulus = options.share_contact_modulus,
                                       .share_work_of_adhesion = options.share_work_of_adhesion,
                                       .fit = options_of(options, options.shared_model())});
}

}  // namespace setae::study
