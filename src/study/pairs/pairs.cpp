// SPDX-License-Identifier: GPL-3.0-or-later
#include "pairs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "balances.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "statistics.hpp"

namespace setae::study {
namespace {

using roughness::SpectralParameters;

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

using Balance = adhesion::PairPoint (Balances::*)() const;
using ParametersOf = std::function<const SpectralParameters&(std::size_t surface)>;

/// Points of all pairs with a measured approach, for one balance.
std::vector<adhesion::PairPoint> points(const StudyResult& result, Balance balance, const ParametersOf& parameters_of) {
    std::vector<adhesion::PairPoint> found;
    for (const auto& pair : result.pairs) {
        if (!pair.approach) continue;
        const auto& surface = result.surface(pair.surface);
        const auto& elastomer = result.elastomer(pair.elastomer);
        if (!predictable(surface, elastomer)) continue;
        const auto index = static_cast<std::size_t>(&surface - result.surfaces.data());
        auto point = (Balances(surface, elastomer, parameters_of(index)).*balance)();
        point.measured = *pair.approach;
        point.measured.value = std::max(0.0, point.measured.value);
        found.push_back(std::move(point));
    }
    return found;
}

Outcome<adhesion::WorkFit> fit_approach(const StudyResult& result, Balance balance) {
    const auto found = points(result, balance, [&](std::size_t i) -> const SpectralParameters& {
        return result.surfaces[i].used().parameters;
    });
    if (found.size() < 2)
        return Outcome<adhesion::WorkFit>::missing(fmt::format(
            "{} pairs have both a measured work of adhesion and a predictable surface, a fit needs at least 2",
            found.size()));
    return adhesion::fit_work_of_adhesion(found);
}

Outcome<LoopFits> fit_loops(const StudyResult& result) {
    std::vector<adhesion::PairPoint> whole, reduced;
    for (const auto& pair : result.pairs) {
        const auto& surface = result.surface(pair.surface);
        if (!pair.loss || !pair.contact_area || surface.failed()) continue;
        adhesion::PairPoint point;
        point.surface = pair.surface;
        point.elastomer = pair.elastomer;
        point.measured = *pair.loss;
        point.slope = surface.area_ratio() * *pair.contact_area;
        point.slope_variance =
            std::pow(*pair.contact_area * surface.used().spread.standard_error([](const SpectralParameters& p) {
                return roughness::gaussian_area_ratio(p.rms_slope);
            }),
                     2);
        if (!std::isfinite(point.slope_variance)) point.slope_variance = 0.0;
        point.floored = false;
        whole.push_back(point);
        if (!pair.ideal_loss) continue;
        point.measured.value -= *pair.ideal_loss;
        reduced.push_back(point);
    }
    if (whole.size() < 2)
        return Outcome<LoopFits>::missing(
            fmt::format("{} pairs have a loop energy and a contact radius, a fit needs at least 2", whole.size()));
    const auto line = [](const std::vector<adhesion::PairPoint>& points) -> std::optional<adhesion::LineFit> {
        std::vector<double> area, energy;
        for (const auto& p : points) {
            area.push_back(p.slope);
            energy.push_back(p.measured.value);
        }
        if (points.size() < 3 ||
            *std::max_element(area.begin(), area.end()) == *std::min_element(area.begin(), area.end()))
            return std::nullopt;
        return adhesion::fit_line(area, energy);
    };
    LoopFits fits;
    fits.through_origin = adhesion::fit_work_of_adhesion(whole);
    fits.with_intercept = line(whole);
    if (reduced.size() >= 2) fits.through_origin_without_ideal_loss = adhesion::fit_work_of_adhesion(reduced);
    fits.with_intercept_without_ideal_loss = line(reduced);
    return fits;
}

Outcome<adhesion::FreeEnergyFit> fit_free(const StudyResult& result) {
    std::vector<adhesion::FreeEnergyPoint> found;
    for (const auto& p : points(result, &Balances::modified, [&](std::size_t i) -> const SpectralParameters& {
             return result.surfaces[i].used().parameters;
         })) {
        const auto& elastomer = result.elastomer(p.elastomer);
        found.push_back({p.surface, p.measured.value, p.slope, elastomer.input.surface_energy.value * (p.slope - 1.0),
                         elastomer.contact_modulus.value});
    }
    if (found.size() < 2)
        return Outcome<adhesion::FreeEnergyFit>::missing("fewer than 2 pairs with a measured work of adhesion");
    return adhesion::fit_with_free_energies(found);
}

std::vector<CutoffPoint> scan_cutoffs(const StudyResult& result) {
    std::vector<CutoffPoint> scan;
    for (const double shortest : result.study.analysis.cutoff_scan) {
        CutoffPoint point;
        point.shortest_wavelength = shortest;
        for (const auto& surface : result.surfaces)
            point.surfaces.push_back(surface.failed() ? SpectralParameters{}
                                                      : parameters_within(surface.used(), {.shortest = shortest},
                                                                          result.study.analysis.conversion));
        const auto of_cut = [&](std::size_t i) -> const SpectralParameters& { return point.surfaces[i]; };
        point.modified = adhesion::fit_work_of_adhesion(points(result, &Balances::modified, of_cut));
        point.persson_tosatti = adhesion::fit_work_of_adhesion(points(result, &Balances::persson_tosatti, of_cut));
        scan.push_back(std::move(point));
    }
    return scan;
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

void fit_pairs(StudyResult& result) {
    result.modified = fit_approach(result, &Balances::modified);
    result.persson_tosatti = fit_approach(result, &Balances::persson_tosatti);
    result.without_area_change = fit_approach(result, &Balances::without_area_change);
    result.loop = fit_loops(result);
    result.free_energies = fit_free(result);
    if (result.modified) result.cutoff_scan = scan_cutoffs(result);
}

}  // namespace setae::study
