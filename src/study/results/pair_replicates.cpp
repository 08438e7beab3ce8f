// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>

#include "pairs.hpp"
#include "setae/core/errors.hpp"

namespace setae::study {
namespace {

/// A quantity of loops, where a loop has it.
struct LoopQuantity {
    const char* name;
    const char* symbol;
    const char* unit;
    std::function<std::optional<Estimate>(const loops::LoopAnalysis&)> of;
};

const std::vector<LoopQuantity>& loop_quantities() {
    using loops::LoopAnalysis;
    static const std::vector<LoopQuantity> quantities{
        {work_of_approach, "W_app", "J/m2",
         [](const LoopAnalysis& loop) { return std::optional(loop.loading.primary().work_of_adhesion); }},
        {work_of_pull_off, "W_po", "J/m2",
         [](const LoopAnalysis& loop) {
             return loop.pull_off ? std::optional(loop.pull_off->work_of_adhesion) : std::nullopt;
         }},
        {work_of_retraction, "W_ret", "J/m2",
         [](const LoopAnalysis& loop) {
             return loop.retraction ? std::optional(loop.retraction->work_of_adhesion) : std::nullopt;
         }},
        {energy_loss, "E_loss", "J",
         [](const LoopAnalysis& loop) { return loop.loop ? std::optional(loop.loop->estimate()) : std::nullopt; }}};
    return quantities;
}

statistics::ReplicateData data_of(const StudyResult& result, const std::string& elastomer,
                                  const LoopQuantity& quantity) {
    statistics::ReplicateData data{
        .crossed = result.study.comparison.crossed, .quantity = quantity.name, .unit = quantity.unit};
    for (const auto& e : result.experiments) {
        if (!e.analysis || e.input.reference || e.input.elastomer != elastomer) continue;
        const auto value = quantity.of(*e.analysis);
        if (!value) continue;
        data.rows.push_back({value->value,
                             value->uncertain() ? value->standard_error : undefined,
                             {e.input.surface, e.input.lens, e.input.spot},
                             e.input.file});
        if (e.input.excluded()) data.exclusions.push_back({data.rows.size() - 1, e.input.exclusion});
    }
    return data;
}

}  // namespace

std::vector<ElastomerReplicates> elastomer_replicates(const StudyResult& result) {
    std::vector<ElastomerReplicates> list;
    for (const auto& elastomer : result.elastomers) {
        const auto& name = elastomer.input.name;
        const bool wanted =
            std::any_of(result.experiments.begin(), result.experiments.end(), [&](const ExperimentResult& e) {
                return !e.input.reference && e.input.elastomer == name &&
                       (!e.input.lens.empty() || !e.input.spot.empty() || e.input.excluded());
            });
        if (!wanted) continue;
        for (const auto& quantity : loop_quantities()) {
            ElastomerReplicates replicates{
                .elastomer = name, .symbol = quantity.symbol, .data = data_of(result, name, quantity)};
            if (replicates.data.rows.empty()) continue;
            try {
                replicates.model = statistics::mixed_model(replicates.data);
            } catch (const UndefinedDataError& error) {
                replicates.model = loops::Outcome<statistics::MixedModel>::missing(error.what());
            }
            list.push_back(std::move(replicates));
        }
    }
    return list;
}

}  // namespace setae::study
