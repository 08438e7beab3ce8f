// SPDX-License-Identifier: GPL-3.0-or-later
#include "pairs.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

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

/// Values of all loops on a pair, by quantity.
struct LoopValues {
    std::vector<Estimate> approach, pull_off, retraction, loss;
    std::vector<double> area, ideal_loss;
};

LoopValues loops_on(const StudyResult& result, const PairResult& pair) {
    LoopValues values;
    for (const auto& e : result.experiments) {
        if (!e.analysis || e.input.reference || e.input.surface != pair.surface ||
            e.input.elastomer != pair.elastomer || e.input.excluded())
            continue;
        const auto& loop = *e.analysis;
        values.approach.push_back(loop.loading.primary().work_of_adhesion);
        if (loop.pull_off) values.pull_off.push_back(loop.pull_off->work_of_adhesion);
        if (loop.retraction) values.retraction.push_back(loop.retraction->work_of_adhesion);
        if (loop.loop) values.loss.push_back(loop.loop->estimate());
        values.area.push_back(loop.context.largest_contact_area);
        values.ideal_loss.push_back(loop.context.ideal_smooth_sphere_loss);
    }
    return values;
}

void take_published(PairResult& pair, const PublishedPair& published) {
    pair.approach = published.approach;
    pair.pull_off = published.pull_off;
    pair.retraction = published.retraction;
    pair.loss = published.loss;
    if (published.contact_radius) pair.contact_area = pi * *published.contact_radius * *published.contact_radius;
}

void take_loops(PairResult& pair, const LoopValues& values) {
    if (values.approach.empty()) return;
    pair.experiments = static_cast<int>(values.approach.size());
    pair.approach = mean_of(values.approach);
    if (!values.pull_off.empty()) pair.pull_off = mean_of(values.pull_off);
    if (!values.retraction.empty()) pair.retraction = mean_of(values.retraction);
    if (!values.loss.empty()) pair.loss = mean_of(values.loss);
    pair.contact_area = mean_of(values.area);
    pair.ideal_loss = mean_of(values.ideal_loss);
}

/// Measured values by the mixed model, where the loops on the pair's elastomer name what was repeated.
void take_replicates(PairResult& pair, const StudyResult& result) {
    for (const auto& replicates : result.replicates) {
        if (replicates.elastomer != pair.elastomer) continue;
        std::optional<Estimate> mean;
        if (replicates.model)
            for (const auto& surface : replicates.model->surfaces)
                if (surface.surface == pair.surface) mean = surface.mean;
        if (!mean) continue;
        const auto& quantity = replicates.data.quantity;
        if (quantity == work_of_approach) pair.approach = mean;
        else if (quantity == work_of_pull_off) pair.pull_off = mean;
        else if (quantity == work_of_retraction) pair.retraction = mean;
        else if (quantity == energy_loss) pair.loss = mean;
    }
}

}  // namespace

std::optional<double> ideal_loss(const ElastomerResult& elastomer, double work_of_adhesion) {
    if (!elastomer.input.sphere_radius || !(elastomer.contact_modulus.value > 0.0)) return std::nullopt;
    if (!(work_of_adhesion > 0.0)) return 0.0;
    return contact::jkr::ideal_loop_loss(
               {*elastomer.input.sphere_radius, elastomer.contact_modulus.value, work_of_adhesion})
        .total;
}

std::vector<PairResult> measured_pairs(const StudyResult& result) {
    std::vector<PairResult> pairs;
    for (const auto& surface : result.surfaces)
        for (const auto& elastomer : result.elastomers) {
            PairResult pair;
            pair.surface = surface.name;
            pair.elastomer = elastomer.input.name;
            if (const auto* published = published_of(result.study, pair)) take_published(pair, *published);
            take_loops(pair, loops_on(result, pair));
            take_replicates(pair, result);
            if (!pair.ideal_loss && pair.approach) pair.ideal_loss = ideal_loss(elastomer, pair.approach->value);
            pairs.push_back(std::move(pair));
        }
    return pairs;
}

}  // namespace setae::study
