// SPDX-License-Identifier: GPL-3.0-or-later
#include "pairs.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "failed_part.hpp"
#include "loop_quantities.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "statistics.hpp"

namespace setae::study {
namespace {

const PublishedPair* published_of(const Study& study, const PairResult& pair) {
    for (const auto& p : study.published)
        if (p.surface == pair.surface && p.elastomer == pair.elastomer) return &p;
    return nullptr;
}

void take_published(PairResult& pair, const PublishedPair& published) {
    pair.approach = published.approach;
    pair.pull_off = published.pull_off;
    pair.retraction = published.retraction;
    pair.loss = published.loss;
    if (published.contact_radius) pair.contact_area = pi * *published.contact_radius * *published.contact_radius;
}

/// Inputs of the mean contact area of loops: their fits, and inputs that loops share.
Components area_inputs_of(const std::vector<const ExperimentResult*>& loops) {
    const double share = 1.0 / static_cast<double>(loops.size());
    std::vector<Components> fits(loops.size());
    std::vector<Dependence> terms;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const auto& e = *loops[i];
        terms.push_back({share, e.dependence.contact_area});
        const auto& loading = e.analysis->loading;
        auto noise = area_noise_of(loading.primary(), e.bodies, loading.range.force_last);
        if (noise.directions.size() == 0) continue;
        fits[i][fit_name(e.input.file)] = std::move(noise);
        terms.push_back({share, fits[i]});
    }
    return combined(terms);
}

void take_loops(PairResult& pair, const StudyResult& result, const ElastomerResult& elastomer) {
    for (const auto& quantity : loop_quantities()) {
        auto loops = loops_with(result, quantity, pair.elastomer, pair.surface, false);
        if (loops.loops.empty()) continue;
        auto [mean, weights] = weighted_mean_of(loops.values);
        pair.*quantity.of_pair = std::move(mean);
        loops.weights = std::move(weights);
        take_dependence(pair, quantity, loops, elastomer.modulus_from_loops);
        if (quantity.of_pair != &PairResult::approach) continue;  // which every loop has
        std::vector<double> area, ideal_loss, bulk;
        pair.contact_area_inputs = area_inputs_of(loops.loops);
        for (const auto* e : loops.loops) {
            area.push_back(e->analysis->context.largest_contact_area);
            ideal_loss.push_back(e->analysis->context.ideal_smooth_sphere_loss);
            if (e->analysis->bulk) bulk.push_back(e->analysis->bulk->energy_loss);
        }
        if (!bulk.empty()) pair.bulk_loss = mean_of(bulk);
        pair.experiments = static_cast<int>(loops.loops.size());
        pair.contact_area = mean_of(area);
        pair.ideal_loss = mean_of(ideal_loss);
    }
}

/// W_ret along the retraction of the pair's loops; of published pairs, and without it, why not.
loops::Outcome<PairWorkAlong> work_along_of(const PairResult& pair, const StudyResult& result) {
    using Along = loops::Outcome<PairWorkAlong>;
    const auto loops_of_pair = loops_with(result, loop_quantities().front(), pair.elastomer, pair.surface, false);
    if (loops_of_pair.loops.empty())
        return Along::missing(pair.retraction || pair.pull_off ? "undetermined: only W_ret at pull-off is known"
                                                               : "the retraction was not measured");
    std::vector<Estimate> at_pull_off, at_largest, slope, loss, recorded;
    for (const auto* e : loops_of_pair.loops) {
        const auto& along = e->analysis->work_along_retraction;
        if (!along) continue;
        at_pull_off.push_back(along->at_pull_off);
        at_largest.push_back(along->at_largest_contact);
        slope.push_back(along->slope);
        loss.push_back(along->energy_loss);
        if (e->analysis->loop) recorded.push_back(e->analysis->loop->estimate());
    }
    if (slope.empty()) return Along::missing(loops_of_pair.loops.front()->analysis->work_along_retraction.reason);
    const auto mean = [](const std::vector<Estimate>& values) {
        return values.empty() ? Estimate{.value = undefined} : mean_of(values);
    };
    return PairWorkAlong{mean(at_pull_off), mean(at_largest), mean(slope),
                         mean(loss),        mean(recorded),   static_cast<int>(slope.size())};
}

/// Measured values by the mixed model, where the loops on the pair's elastomer name replicates.
void take_replicates(PairResult& pair, const StudyResult& result, const ElastomerResult& elastomer) {
    for (const auto& replicates : result.replicates) {
        if (replicates.elastomer != pair.elastomer || !replicates.model) continue;
        for (const auto& quantity : loop_quantities()) {
            if (replicates.data.quantity != quantity.name) continue;
            for (const auto& surface : replicates.model->surfaces) {
                if (surface.surface != pair.surface) continue;
                auto rows = loops_with(result, quantity, pair.elastomer, std::nullopt, true);
                rows.weights = surface.weights;
                pair.*quantity.of_pair = surface.mean;
                take_dependence(pair, quantity, rows, elastomer.modulus_from_loops);
            }
        }
    }
}

void take_measured(PairResult& pair, const StudyResult& result, const ElastomerResult& elastomer) {
    if (const auto* published = published_of(result.study, pair)) take_published(pair, *published);
    take_loops(pair, result, elastomer);
    take_replicates(pair, result, elastomer);
    pair.work_along_retraction = work_along_of(pair, result);
    if (!pair.ideal_loss && pair.approach) pair.ideal_loss = ideal_loss(elastomer, pair.approach->value);
}

}  // namespace

std::string pair_name(const PairResult& pair) { return pair.surface + " × " + pair.elastomer; }

std::optional<double> ideal_loss(const ElastomerResult& elastomer, double work_of_adhesion) {
    if (!elastomer.input.sphere_radius || !(elastomer.contact_modulus.value > 0.0)) return std::nullopt;
    if (!(work_of_adhesion > 0.0)) return 0.0;
    return contact::jkr::ideal_loop_loss(
               {elastomer.input.sphere_radius->value, elastomer.contact_modulus.value, work_of_adhesion})
        .total;
}

std::vector<PairResult> measured_pairs(const StudyResult& result) {
    std::vector<PairResult> pairs;
    for (const auto& surface : result.surfaces)
        for (const auto& elastomer : result.elastomers) {
            PairResult pair;
            pair.surface = surface.name;
            pair.elastomer = elastomer.input.name;
            auto measured = pair;
            if (isolated(pair.alerts, pair_name(pair), [&] { take_measured(measured, result, elastomer); }))
                pair = std::move(measured);
            pairs.push_back(std::move(pair));
        }
    return pairs;
}

}  // namespace setae::study
