// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "loop_quantities.hpp"
#include "pairs.hpp"
#include "setae/core/errors.hpp"

namespace setae::study {
namespace {

statistics::ReplicateData data_of(const StudyResult& result, const std::string& elastomer,
                                  const LoopQuantity& quantity) {
    statistics::ReplicateData data{
        .crossed = result.study.comparison.crossed, .quantity = quantity.name, .unit = quantity.unit};
    const auto rows = loops_with(result, quantity, elastomer, std::nullopt, true);
    for (std::size_t i = 0; i < rows.loops.size(); ++i) {
        const auto& input = rows.loops[i]->input;
        const auto& value = rows.values[i];
        data.rows.push_back({value.value,
                             value.uncertain() ? value.standard_error : undefined,
                             {input.surface, input.lens, input.spot},
                             input.file});
        if (input.excluded()) data.exclusions.push_back({i, input.exclusion});
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
