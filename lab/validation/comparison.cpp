// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/validation/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "setae/core/constants.hpp"
#include "setae/core/resampling.hpp"
#include "surface_quantities.hpp"

namespace setae::validation {
namespace {

using study::SpectrumResult;
using study::StudyResult;

/// True values within the band of a spectrum: where it begins above the roll-off, of the waves from there on.
simulation::TrueSurfaceValues true_values_within(const simulation::KnownSurface& known,
                                                 const simulation::TrueSurfaceValues& whole,
                                                 const SpectrumResult& spectrum) {
    const double lowest = spectrum.curve.band.lower;
    if (!known.gaussian() || lowest <= known.band().lower) return whole;
    return simulation::true_surface_values(known, {lowest, known.band().upper});
}

/// Calls visit(surface's result, known surface, true values) for every surface of the study without failure.
void for_each_surface(const simulation::Recipe& recipe, const TrueValues& true_values, const StudyResult& study,
                      const std::function<void(const study::SurfaceResult&, const simulation::KnownSurface&,
                                               const simulation::TrueSurfaceValues&)>& visit) {
    for (std::size_t i = 0; i < recipe.surfaces.size(); ++i) {
        const auto& surface = study.surface(recipe.surfaces[i].surface.name);
        if (!surface.failed()) visit(surface, recipe.surfaces[i].surface, true_values.surfaces[i]);
    }
}

/// One row, unless either value is undefined.
void add(std::vector<Comparison>& rows, Comparison row) {
    if (std::isfinite(row.true_value) && std::isfinite(row.found.value)) rows.push_back(std::move(row));
}

void add_spectrum(std::vector<Comparison>& rows, int run, const std::string& surface, const std::string& method,
                  const SpectrumResult& spectrum, const simulation::TrueSurfaceValues& truth) {
    for (const auto& quantity : surface_quantities()) {
        if (!std::isfinite(quantity.value(spectrum.parameters))) continue;
        add(rows, {run, surface, quantity.name, method, quantity.unit, Deviation::relative,
                   true_value_of(quantity, truth), spectrum.estimate(quantity.value, quantity.least)});
    }
}

Estimate between_percentiles(const SpectrumResult& spectrum, const SurfaceQuantity& quantity) {
    std::vector<double> replicas;
    for (const auto& p : spectrum.spread.replicas)
        if (const double value = quantity.value(p); std::isfinite(value)) replicas.push_back(value);
    Estimate result{quantity.value(spectrum.parameters), undefined, "bootstrap percentile"};
    if (replicas.size() < 2) return result;
    const Eigen::Map<const Array1D> values(replicas.data(), static_cast<Index>(replicas.size()));
    result.standard_error =
        std::sqrt((values - values.mean()).square().sum() / static_cast<double>(replicas.size() - 1));
    result.interval = percentile_interval(std::move(replicas));
    return result;
}

void add_work_of_adhesion(std::vector<Comparison>& rows, int run, double true_value, const std::string& method,
                          const study::Conclusions& study) {
    const auto add_work = [&](const char* quantity, const Estimate& found) {
        add(rows, {run, "all", quantity, method, "J/m2", Deviation::absolute, true_value, found});
    };
    const auto generalised = [](const adhesion::WorkFit& fit) { return fit.stated(); };
    if (study.modified) add_work("work_of_adhesion", generalised(*study.modified));
    if (study.work_of_adhesion) add_work("work_of_predictions", *study.work_of_adhesion);
    if (study.loop) add_work("work_of_adhesion_from_loss", generalised(study.loop->through_origin));
}

/// Calls visit(known loop, result of the pair) for every pair of the study that has one.
void for_each_pair(const TrueValues& true_values, const study::Conclusions& study,
                   const std::function<void(const simulation::KnownLoop&, const study::PairResult&)>& visit) {
    for (const auto& loop : true_values.loops) {
        const auto pair = std::find_if(study.pairs.begin(), study.pairs.end(), [&](const auto& p) {
            return p.surface == loop.surface && p.elastomer == loop.elastomer;
        });
        if (!loop.surface.empty() && loop.number == 1 && pair != study.pairs.end()) visit(loop, *pair);
    }
}

std::string pair_name(const simulation::KnownLoop& loop) {
    return (loop.surface.empty() ? "reference" : loop.surface) + " × " + loop.elastomer;
}

void add_predictions(std::vector<Comparison>& rows, int run, const TrueValues& true_values, const std::string& method,
                     const study::Conclusions& study) {
    for_each_pair(true_values, study, [&](const simulation::KnownLoop& loop, const study::PairResult& pair) {
        if (pair.modified)
            add(rows, {run, pair_name(loop), loop.measured ? "predicted_work" : "new_pair_work", method, "J/m2",
                       Deviation::absolute, loop.specimen.work_approach, pair.modified->estimate});
        if (pair.predicted_loss)
            add(rows, {run, pair_name(loop), loop.measured ? "predicted_loss" : "new_pair_loss", method, "J",
                       Deviation::relative, loop.truth.energy_loss(), pair.predicted_loss->estimate()});
    });
}

/// W_app of each pair by the full-contact balance (Eq. 7), fitted to the pairs of the other surfaces, of the other
/// elastomers.
void add_left_out(std::vector<Comparison>& rows, int run, const TrueValues& true_values, const std::string& method,
                  const study::Conclusions& study) {
    for_each_pair(true_values, study, [&](const simulation::KnownLoop& loop, const study::PairResult&) {
        for (const auto& left : study.left_out)
            if (left.surface == loop.surface && left.elastomer == loop.elastomer)
                add(rows, {run, pair_name(loop), left.surface_left_out ? "next_surface_work" : "next_elastomer_work",
                           method, "J/m2", Deviation::absolute, loop.specimen.work_approach, left.predicted});
    });
}

/// Results for all loops on a pair, and for all on an elastomer, with every input.
void add_measured(std::vector<Comparison>& rows, int run, const TrueValues& true_values, const StudyResult& study) {
    for_each_pair(true_values, study, [&](const simulation::KnownLoop& loop, const study::PairResult& pair) {
        if (const auto found = pair.traced_approach())
            add(rows, {run, pair_name(loop), "work_approach", "pairs", "J/m2", Deviation::relative,
                       loop.specimen.work_approach, found->estimate()});
        if (const auto found = pair.traced_loss())
            add(rows, {run, pair_name(loop), "energy_loss", "pairs", "J", Deviation::relative, loop.truth.energy_loss(),
                       found->estimate()});
    });
    for (const auto& elastomer : study.elastomers) {
        const auto& name = elastomer.input.name;
        const auto loop = std::find_if(true_values.loops.begin(), true_values.loops.end(),
                                       [&](const auto& known_loop) { return known_loop.elastomer == name; });
        if (loop != true_values.loops.end() && elastomer.contact_modulus.value > 0.0)
            add(rows, {run, name, "contact_modulus", "elastomers", "Pa", Deviation::relative,
                       loop->specimen.contact_modulus, elastomer.contact_modulus});
    }
}

void add_loop(std::vector<Comparison>& rows, int run, const simulation::KnownLoop& loop, const StudyResult& study) {
    if (!loop.measured) return;
    const auto& file = loop.file;
    const auto found = std::find_if(study.experiments.begin(), study.experiments.end(),
                                    [&](const auto& e) { return e.input.file.ends_with(file) && e.analysis; });
    if (found == study.experiments.end()) return;
    const auto& analysis = *found->analysis;
    const auto& fit = analysis.loading.primary();
    const auto relative = [&](const char* quantity, const char* unit, double value, const Estimate& estimate) {
        add(rows, {run, pair_name(loop), quantity, "loops", unit, Deviation::relative, value, estimate});
    };
    relative("contact_modulus", "Pa", loop.specimen.contact_modulus, fit.contact_modulus);
    relative("work_approach", "J/m2", loop.specimen.work_approach, fit.work_of_adhesion);
    if (analysis.pull_off)
        relative("work_from_pull_off", "J/m2", loop.specimen.work_retraction, analysis.pull_off->work_of_adhesion);
    if (analysis.retraction)
        relative("work_retraction", "J/m2", loop.specimen.work_retraction, analysis.retraction->work_of_adhesion);
    if (analysis.loop) relative("energy_loss", "J", loop.truth.energy_loss(), analysis.loop->estimate());
}

}  // namespace

double Comparison::deviation() const {
    return measure == Deviation::relative ? found.value / true_value - 1.0 : found.value - true_value;
}

double Comparison::stated_deviation() const {
    const auto interval = interval_of(found);
    if (!interval) return undefined;
    constexpr double quantile = 1.959963984540054;
    const double half = 0.5 * (interval->upper - interval->lower) / quantile;
    return measure == Deviation::relative ? half / std::abs(true_value) : half;
}

bool Comparison::covered() const {
    const auto interval = interval_of(found);
    return interval && interval->lower <= true_value && true_value <= interval->upper;
}

TrueValues true_values_of(const simulation::Recipe& recipe) {
    TrueValues true_values;
    for (const auto& rough : recipe.surfaces)
        true_values.surfaces.push_back(simulation::true_surface_values(rough.surface));
    true_values.loops = simulation::known_loops(recipe);
    return true_values;
}

std::vector<Comparison> comparisons(int run, const simulation::Recipe& recipe, const TrueValues& true_values,
                                    const StudyResult& study) {
    std::vector<Comparison> rows;
    for_each_surface(recipe, true_values, study,
                     [&](const study::SurfaceResult& surface, const simulation::KnownSurface& known,
                         const simulation::TrueSurfaceValues& truth) {
                         for (const auto& [method, spectrum] : study::spectra_of(surface))
                             add_spectrum(rows, run, surface.name, method, *spectrum,
                                          true_values_within(known, truth, *spectrum));
                     });
    const bool likelihood = study.by_average.has_value();
    const auto add_related = [&](const std::string& method, const study::Conclusions& related) {
        add_work_of_adhesion(rows, run, recipe.work_of_adhesion, method, related);
        add_predictions(rows, run, true_values, method, related);
        add_left_out(rows, run, true_values, method, related);
    };
    add_related(likelihood ? "likelihood" : "average", study);
    if (likelihood) add_related("average", *study.by_average);
    add_measured(rows, run, true_values, study);
    for (const auto& loop : true_values.loops) add_loop(rows, run, loop, study);
    return rows;
}

std::vector<Comparison> comparisons_by_paper(int run, const simulation::Recipe& recipe, const TrueValues& true_values,
                                             const StudyResult& study) {
    std::vector<Comparison> rows;
    for_each_surface(recipe, true_values, study,
                     [&](const study::SurfaceResult& surface, const simulation::KnownSurface& known,
                         const simulation::TrueSurfaceValues& whole) {
                         const auto truth = true_values_within(known, whole, surface.average);
                         for (const auto& quantity : surface_quantities())
                             add(rows,
                                 {run, surface.name, quantity.name, "paper", quantity.unit, Deviation::relative,
                                  true_value_of(quantity, truth), between_percentiles(surface.average, quantity)});
                     });
    add_work_of_adhesion(rows, run, recipe.work_of_adhesion, "paper", study);
    return rows;
}

}  // namespace setae::validation
