// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/patches/survey.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <mutex>

#include "setae/core/errors.hpp"

namespace setae::patches {
namespace {

constexpr double large_jump = 0.01;  ///< share of w

void require(const SurveyDesign& design) {
    if (design.designs.empty() || design.seeds < 1)
        throw InvalidArgument("the survey has no patch; expected at least one design and one seed");
}

struct Drawn {
    PatchContact contact;
    double range_over_height = 0.0;
};

template <class Value>
PatchMean mean_of(const std::vector<Drawn>& drawn, const Value& value) {
    const auto n = static_cast<Index>(drawn.size());
    if (n == 0) return {};
    const Array1D values =
        Array1D::NullaryExpr(n, [&](Index i) { return value(drawn[static_cast<std::size_t>(i)].contact); });
    PatchMean mean{.value = values.mean()};
    if (n > 1 && values.maxCoeff() - values.minCoeff() > 1e-12)
        mean.standard_error =
            std::sqrt((values - mean.value).square().sum() / static_cast<double>(n - 1) / static_cast<double>(n));
    return mean;
}

double in_large_jumps(const PatchLoop& loop) {
    double lost = 0.0;
    for (const auto* classes : {&loop.approach_jumps, &loop.separation_jumps})
        for (const auto& jumps : *classes)
            if (jumps.from >= large_jump) lost += jumps.loss;
    return lost / (loop.approach_dissipation + loop.separation_dissipation);
}

std::vector<JumpClass> mean_jumps(const std::vector<Drawn>& drawn, std::vector<JumpClass> PatchLoop::*branch) {
    const auto n = static_cast<double>(drawn.size());
    std::vector<JumpClass> mean = (*drawn.front().contact.loop).*branch;
    for (auto& of : mean) of.jumps = of.loss = 0.0;
    for (const auto& one : drawn)
        for (std::size_t k = 0; k < mean.size(); ++k) {
            mean[k].jumps += ((*one.contact.loop).*branch)[k].jumps / n;
            mean[k].loss += ((*one.contact.loop).*branch)[k].loss / n;
        }
    return mean;
}

void add_loops(SurveyRow& row, const std::vector<Drawn>& drawn) {
    row.approach_work = mean_of(drawn, [](const PatchContact& of) { return of.loop->approach_work; });
    row.separation_work = mean_of(drawn, [](const PatchContact& of) { return of.loop->separation_work; });
    row.loss = mean_of(drawn, [](const PatchContact& of) { return of.loop->loss(); });
    row.greatest_tension = mean_of(drawn, [](const PatchContact& of) { return of.loop->greatest_tension; });
    row.approach_jumps = mean_jumps(drawn, &PatchLoop::approach_jumps);
    row.separation_jumps = mean_jumps(drawn, &PatchLoop::separation_jumps);
    row.large_jumps = mean_of(drawn, [](const PatchContact& of) { return in_large_jumps(*of.loop); });
}

SurveyRow row_of(const PatchDesign& design, const std::vector<Drawn>& drawn, const ContactProtocol& protocol) {
    SurveyRow row{.design = design,
                  .range_over_height = drawn.front().range_over_height,
                  .patches = static_cast<int>(drawn.size())};
    row.area_from_far = mean_of(drawn, [](const PatchContact& of) { return of.from_far.area_fraction; });
    row.gain_from_far = mean_of(drawn, [](const PatchContact& of) { return of.from_far.gain; });
    row.area_after_preload = mean_of(drawn, [](const PatchContact& of) { return of.after_preload.area_fraction; });
    row.gain_after_preload = mean_of(drawn, [](const PatchContact& of) { return of.after_preload.gain; });
    row.opening_tension = mean_of(drawn, [](const PatchContact& of) { return of.opening_tension; });
    std::vector<Drawn> closed;
    std::ranges::copy_if(drawn, std::back_inserter(closed),
                         [](const Drawn& of) { return of.contact.closing_pressure.has_value(); });
    row.closed = static_cast<int>(closed.size());
    row.closing_pressure = mean_of(closed, [](const PatchContact& of) { return *of.closing_pressure; });
    if (protocol.loop) add_loops(row, drawn);
    row.converged = std::ranges::all_of(drawn, [](const Drawn& of) {
        return of.contact.from_far.converged && of.contact.after_preload.converged &&
               (!of.contact.loop || of.contact.loop->complete);
    });
    return row;
}

}  // namespace

std::vector<SurveyRow> survey(const SurveyDesign& design) {
    require(design);
    const auto& designs = design.designs;
    const auto seeds = static_cast<std::size_t>(design.seeds), all = designs.size() * seeds;
    std::vector<std::vector<Drawn>> drawn(designs.size(), std::vector<Drawn>(seeds));
    std::mutex telling;
    std::size_t done = 0;
    // expensive ones first, so that no thread works at the end without the others
    std::vector<std::size_t> order(all);
    for (std::size_t k = 0; k < all; ++k) order[k] = k;
    std::ranges::stable_sort(order, std::greater{}, [&](std::size_t k) { return designs[k / seeds].points; });
    parallel::for_each_index(all, design.threads, [&](std::size_t task) {
        const std::size_t k = order[task];
        auto one = designs[k / seeds];
        one.seed = design.first_seed + k % seeds;
        const Patch patch = make_patch(one, {1});
        drawn[k / seeds][k % seeds] = {bring_into_contact(patch, design.protocol, {1}), patch.range_over_height()};
        if (!design.progress) return;
        const std::scoped_lock lock(telling);
        design.progress(++done, all);
    });
    std::vector<SurveyRow> rows;
    for (std::size_t d = 0; d < designs.size(); ++d) rows.push_back(row_of(designs[d], drawn[d], design.protocol));
    return rows;
}

}  // namespace setae::patches
