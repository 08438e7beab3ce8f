// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/loops/model_fits.hpp"

namespace setae::loops {
namespace {

/// A model's fit with the options it has, or why there is none.
Outcome<ModelFit> fitted(const BranchData& data, const LensAndCounterBody& bodies, ModelFitOptions options,
                         ContactModel model) {
    options.model = model;
    if (model == ContactModel::hertz) options.work_of_adhesion.reset();
    if (model != ContactModel::maugis_dugdale) {
        options.cohesive_stress.reset();
        options.transition_parameter.reset();
    }
    try {
        return fit_model(data, bodies, options);
    } catch (const InvalidArgument& error) {
        return Outcome<ModelFit>::missing(error.what());
    } catch (const UndefinedDataError& error) {
        return Outcome<ModelFit>::missing(error.what());
    }
}

/// AICc of a fit whose residuals count as `independent` ones; the correction for few samples goes by the samples.
double akaike(const ModelFit& fit, double independent) {
    const double unknowns = static_cast<double>(fit.parameters.size()) + 1.0;
    const double residuals = fit.degrees_of_freedom + unknowns - 1.0;
    return independent * std::log(fit.chi2 / residuals) + 2.0 * unknowns * residuals / (residuals - unknowns - 1.0);
}

}  // namespace

ModelComparison compare_models(const BranchData& data, const LensAndCounterBody& bodies,
                               const ModelFitOptions& options) {
    ModelComparison comparison{.channels = options.channels ? *options.channels : channels_of(data)};
    const ComparedModel* best = nullptr;
    for (const ContactModel model : contact_models())
        comparison.models.push_back(
            {.model = model, .fit = fitted(data, bodies, options, model), .akaike_difference = undefined});
    for (const ComparedModel& model : comparison.models)
        if (model.fit && std::isfinite(model.fit->akaike) && (!best || model.fit->akaike < best->fit->akaike))
            best = &model;
    if (!best) {
        comparison.sentence = "no model could be fitted: " + comparison.models.front().fit.reason;
        return comparison;
    }
    const double residuals = best->fit->degrees_of_freedom + static_cast<double>(best->fit->parameters.size());
    const double independent = residuals / best->fit->correlated_samples;
    double least = std::numeric_limits<double>::infinity(), weights = 0.0;
    for (const ComparedModel& model : comparison.models)
        if (model.fit) least = std::min(least, akaike(*model.fit, independent));
    for (ComparedModel& model : comparison.models) {
        if (!model.fit) continue;
        model.akaike_difference = akaike(*model.fit, independent) - least;
        model.akaike_weight = std::exp(-0.5 * model.akaike_difference);
        weights += model.akaike_weight;
    }
    const ComparedModel* second = nullptr;
    for (ComparedModel& model : comparison.models) {
        if (!model.fit) continue;
        model.akaike_weight /= weights;
        if (model.akaike_difference == 0.0) {
            comparison.best = model.model;
            best = &model;
        } else if (!second || model.akaike_difference < second->akaike_difference) second = &model;
    }
    comparison.sentence = fmt::format("{} fits best", to_string(best->model));
    if (second)
        comparison.sentence +=
            fmt::format(", {} {} with an AICc higher by {:.1f}", to_string(second->model),
                        second->akaike_difference < 2.0 ? "equally well" : "second best", second->akaike_difference);
    if (best->fit->verdict) comparison.sentence += "; " + best->fit->verdict->sentence;
    return comparison;
}

}  // namespace setae::loops
