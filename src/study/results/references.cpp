// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "pairs.hpp"
#include "setae/core/errors.hpp"
#include "statistics.hpp"

namespace setae::study {
namespace {

/// A loop on a smooth standard as a reference, and what experiment knows of it.
struct MeasuredReference {
    std::string elastomer, stage;
    loops::ReferenceLoop loop;
};

std::vector<MeasuredReference> measured_references(StudyResult& result) {
    std::vector<MeasuredReference> found;
    for (auto& e : result.experiments) {
        if (!e.analysis || !e.input.reference || e.input.excluded()) continue;
        try {
            found.push_back({e.input.elastomer, e.input.stage, loops::evaluate_reference(*e.analysis)});
        } catch (const Error& error) {
            e.alerts.push_back({"REFERENCE_INCOMPLETE", e.input.file, error.what(),
                                "record the whole loop of a reference, retraction included"});
        }
    }
    return found;
}

std::optional<double> mean_rough_loss(const StudyResult& result, const std::string& elastomer) {
    std::vector<double> losses;
    for (const auto& pair : result.pairs)
        if (pair.elastomer == elastomer && pair.loss) losses.push_back(pair.loss->value);
    return losses.empty() ? std::nullopt : std::optional(mean_of(losses));
}

ReferenceResult published_reference(const PublishedPair& published, const StudyResult& result) {
    ReferenceResult reference;
    reference.elastomer = published.elastomer;
    reference.approach = published.approach.value_or(Estimate{.value = undefined});
    reference.retraction = published.retraction.value_or(Estimate{.value = undefined});
    reference.excess_energy = published.loss;
    reference.ideal_loss = ideal_loss(result.elastomer(published.elastomer), reference.approach.value);
    return reference;
}

void add_loss_ratio(ReferenceResult& reference, const StudyResult& result) {
    const auto rough = mean_rough_loss(result, reference.elastomer);
    if (!rough || !reference.excess_energy || !(reference.excess_energy->value > 0.0)) return;
    reference.loss_ratio =
        loops::loss_ratios(Array1D::Constant(1, *rough), {{.excess_energy = *reference.excess_energy}})[0];
}

}  // namespace

void evaluate_references(StudyResult& result) {
    const auto measured = measured_references(result);
    for (const auto& [elastomer, stage, loop] : measured) {
        ReferenceResult reference;
        reference.elastomer = elastomer;
        reference.stage = stage;
        reference.approach = loop.work_of_adhesion_loading;
        reference.retraction = loop.work_of_adhesion_retraction;
        reference.excess_energy = loop.excess_energy;
        reference.ideal_loss = loop.ideal_loss;
        result.references.push_back(std::move(reference));
    }
    for (const auto& published : result.study.published)
        if (published.surface.empty()) result.references.push_back(published_reference(published, result));
    for (auto& reference : result.references) {
        add_loss_ratio(reference, result);
        constexpr double wanted_ratio = 10.0;  // [D19]: rough loops lose at least an order of magnitude more
        if (reference.loss_ratio && *reference.loss_ratio < wanted_ratio)
            result.alerts.push_back({"REFERENCE_LOSS", reference.elastomer,
                                     fmt::format("rough loops lose only {:.2g} times what the smooth reference loses",
                                                 *reference.loss_ratio),
                                     "part of the loss is not roughness: look at rate, drift and the lens"});
    }
    for (const auto& before : measured) {
        if (before.stage != "before") continue;
        for (const auto& after : measured)
            if (after.stage == "after" && after.elastomer == before.elastomer)
                result.reference_drifts.push_back({before.elastomer, loops::change(before.loop, after.loop)});
    }
}

}  // namespace setae::study
