// SPDX-License-Identifier: GPL-3.0-or-later
#include "loop_quantities.hpp"

#include <cmath>

#include "pairs.hpp"

namespace setae::study {
namespace {

/// Σ weight × part of each loop.
template <class PartOf>
Components in_mean(const LoopsInMean& mean, const PartOf& part_of) {
    std::vector<Components> parts(mean.loops.size());
    std::vector<Dependence> terms;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const double weight = mean.weights[static_cast<Index>(i)];
        if (weight == 0.0) continue;
        parts[i] = part_of(*mean.loops[i]);
        terms.push_back({weight, parts[i]});
    }
    return combined(terms);
}

}  // namespace

const std::vector<LoopQuantity>& loop_quantities() {
    using loops::LoopAnalysis;
    static const std::vector<LoopQuantity> quantities{
        {work_of_approach, "W_app", "J/m2",
         [](const LoopAnalysis& loop) { return std::optional(loop.loading.primary().work_of_adhesion); },
         &LoopDependence::approach, &PairResult::approach, &PairResult::approach_inputs},
        {work_of_pull_off, "W_po", "J/m2",
         [](const LoopAnalysis& loop) {
             return loop.pull_off ? std::optional(loop.pull_off->work_of_adhesion) : std::nullopt;
         },
         &LoopDependence::pull_off, &PairResult::pull_off, &PairResult::pull_off_inputs},
        {work_of_retraction, "W_ret", "J/m2",
         [](const LoopAnalysis& loop) {
             return loop.retraction ? std::optional(loop.retraction->work_of_adhesion) : std::nullopt;
         },
         &LoopDependence::retraction, &PairResult::retraction, &PairResult::retraction_inputs},
        {energy_loss, "E_loss", "J",
         [](const LoopAnalysis& loop) { return loop.loop ? std::optional(loop.loop->estimate()) : std::nullopt; },
         &LoopDependence::loss, &PairResult::loss, &PairResult::loss_inputs}};
    return quantities;
}

LoopsInMean loops_with(const StudyResult& result, const LoopQuantity& quantity, const std::string& elastomer,
                       const std::optional<std::string>& surface, bool excluded) {
    LoopsInMean found;
    for (const auto& e : result.experiments) {
        if (!e.analysis || e.input.reference || e.input.elastomer != elastomer) continue;
        if ((surface && e.input.surface != *surface) || (e.input.excluded() && !excluded)) continue;
        const auto value = quantity.of(*e.analysis);
        if (!value || !std::isfinite(value->value)) continue;
        found.loops.push_back(&e);
        found.values.push_back(*value);
    }
    return found;
}

Components fits_in_mean(const LoopsInMean& mean, Component FitNoise::*of_fit) {
    return in_mean(mean, [&](const ExperimentResult& e) {
        Components own;
        auto noise = fit_noise_of(e.analysis->loading.primary()).*of_fit;
        if (noise.directions.size() > 0) own[fit_name(e.input.file)] = std::move(noise);
        return own;
    });
}

Components inputs_in_mean(const LoopsInMean& mean, Components LoopDependence::*number) {
    return in_mean(mean, [&](const ExperimentResult& e) { return e.dependence.*number; });
}

void take_dependence(PairResult& pair, const LoopQuantity& quantity, const LoopsInMean& mean, bool modulus_from_loops) {
    pair.*quantity.inputs_of_pair = inputs_in_mean(mean, quantity.dependence);
    if (modulus_from_loops && quantity.of_pair == &PairResult::approach)
        pair.approach_fits = fits_in_mean(mean, &FitNoise::work_of_adhesion);
}

}  // namespace setae::study
