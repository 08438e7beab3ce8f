// SPDX-License-Identifier: GPL-3.0-or-later
#include "pairs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "statistics.hpp"

namespace setae::workflow {
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
        if (!e.analysis || e.input.reference || e.input.surface != pair.surface || e.input.elastomer != pair.elastomer) continue;
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

/// Balances of one pair as lines in W_int, with the covariances their uncertain inputs give them.
class Balances {
public:
    Balances(const SurfaceResult& surface, const ElastomerResult& elastomer, const SpectralParameters& parameters)
        : surface_(surface), elastomer_(elastomer), parameters_(parameters) {}

    [[nodiscard]] PairPoint modified() const { return point(roughness::gaussian_area_ratio, elastomer_.input.surface_energy); }
    [[nodiscard]] PairPoint persson_tosatti() const { return point(roughness::small_slope_area_ratio, {}); }
    [[nodiscard]] PairPoint without_area_change() const { return point(roughness::gaussian_area_ratio, {}); }

private:
    using AreaRatio = double (*)(double);

    /// prediction = W r − γ1 (r − 1) − E* u; its variance is quadratic in W − γ1
    [[nodiscard]] PairPoint point(AreaRatio area_ratio, const Estimate& surface_energy) const {
        const double r = area_ratio(parameters_.rms_slope), u = parameters_.elastic_energy_per_modulus;
        const auto& modulus = elastomer_.contact_modulus;
        const auto ratio = [area_ratio](const SpectralParameters& p) { return area_ratio(p.rms_slope); };
        const auto energy = [&modulus](const SpectralParameters& p) { return modulus.value * p.elastic_energy_per_modulus; };
        PairPoint pair;
        pair.surface = surface_.name;
        pair.elastomer = elastomer_.input.name;
        pair.slope = r;
        pair.offset = surface_energy.value * (r - 1.0) + modulus.value * u;
        pair.slope_centre = surface_energy.value;
        pair.slope_variance = surface_.used().spread.covariance(ratio, ratio);
        pair.slope_offset_covariance = surface_.used().spread.covariance(ratio, energy);
        pair.offset_variance = surface_.used().spread.covariance(energy, energy) + u * u * modulus.variance() +
                               (r - 1.0) * (r - 1.0) * surface_energy.variance();
        return pair;
    }

    const SurfaceResult& surface_;
    const ElastomerResult& elastomer_;
    const SpectralParameters& parameters_;
};

/// Why a pair cannot be predicted, or empty.
std::string obstacle(const SurfaceResult& surface, const ElastomerResult& elastomer) {
    if (surface.failed()) return fmt::format("surface '{}' failed", surface.name);
    if (!(elastomer.contact_modulus.value > 0.0)) return fmt::format("no modulus of elastomer '{}'", elastomer.input.name);
    return {};
}

using Balance = PairPoint (Balances::*)() const;
using ParametersOf = std::function<const SpectralParameters&(std::size_t surface)>;

/// Points of all pairs with a measured approach, for one balance.
std::vector<PairPoint> points(const StudyResult& result, Balance balance, const ParametersOf& parameters_of) {
    std::vector<PairPoint> found;
    for (const auto& pair : result.pairs) {
        if (!pair.approach) continue;
        const auto& surface = result.surface(pair.surface);
        const auto& elastomer = result.elastomer(pair.elastomer);
        if (!obstacle(surface, elastomer).empty()) continue;
        const auto index = static_cast<std::size_t>(&surface - result.surfaces.data());
        auto point = (Balances(surface, elastomer, parameters_of(index)).*balance)();
        point.measured = *pair.approach;
        point.measured.value = std::max(0.0, point.measured.value);
        found.push_back(std::move(point));
    }
    return found;
}

Outcome<WorkFit> fit_approach(const StudyResult& result, Balance balance) {
    const auto found = points(result, balance, [&](std::size_t i) -> const SpectralParameters& { return result.surfaces[i].used().parameters; });
    if (found.size() < 2)
        return Outcome<WorkFit>::missing(fmt::format("{} pairs have both a measured work of adhesion and a predictable surface, a fit needs at least 2", found.size()));
    return fit_work_of_adhesion(found);
}

Outcome<LoopFits> fit_loops(const StudyResult& result) {
    std::vector<PairPoint> whole, reduced;
    for (const auto& pair : result.pairs) {
        const auto& surface = result.surface(pair.surface);
        if (!pair.loss || !pair.contact_area || surface.failed()) continue;
        PairPoint point;
        point.surface = pair.surface;
        point.elastomer = pair.elastomer;
        point.measured = *pair.loss;
        point.slope = surface.area_ratio() * *pair.contact_area;
        point.slope_variance = std::pow(*pair.contact_area * surface.used().spread.standard_error([](const SpectralParameters& p) { return roughness::gaussian_area_ratio(p.rms_slope); }), 2);
        if (!std::isfinite(point.slope_variance)) point.slope_variance = 0.0;
        point.floored = false;
        whole.push_back(point);
        if (!pair.ideal_loss) continue;
        point.measured.value -= *pair.ideal_loss;
        reduced.push_back(point);
    }
    if (whole.size() < 2)
        return Outcome<LoopFits>::missing(fmt::format("{} pairs have a loop energy and a contact radius, a fit needs at least 2", whole.size()));
    const auto line = [](const std::vector<PairPoint>& points) -> std::optional<LineFit> {
        std::vector<double> area, energy;
        for (const auto& p : points) {
            area.push_back(p.slope);
            energy.push_back(p.measured.value);
        }
        if (points.size() < 3 || *std::max_element(area.begin(), area.end()) == *std::min_element(area.begin(), area.end())) return std::nullopt;
        return fit_line(area, energy);
    };
    LoopFits fits;
    fits.through_origin = fit_work_of_adhesion(whole);
    fits.with_intercept = line(whole);
    if (reduced.size() >= 2) fits.through_origin_without_ideal_loss = fit_work_of_adhesion(reduced);
    fits.with_intercept_without_ideal_loss = line(reduced);
    return fits;
}

Outcome<FreeEnergyFit> fit_free(const StudyResult& result) {
    std::vector<FreeEnergyPoint> found;
    for (const auto& p : points(result, &Balances::modified, [&](std::size_t i) -> const SpectralParameters& { return result.surfaces[i].used().parameters; })) {
        const auto& elastomer = result.elastomer(p.elastomer);
        found.push_back({p.surface, p.measured.value, p.slope, elastomer.input.surface_energy.value * (p.slope - 1.0), elastomer.contact_modulus.value});
    }
    if (found.size() < 2) return Outcome<FreeEnergyFit>::missing("fewer than 2 pairs with a measured work of adhesion");
    return fit_with_free_energies(found);
}

std::vector<CutoffPoint> scan_cutoffs(const StudyResult& result) {
    std::vector<CutoffPoint> scan;
    for (const double shortest : result.study.analysis.cutoff_scan) {
        CutoffPoint point;
        point.shortest_wavelength = shortest;
        for (const auto& surface : result.surfaces)
            point.surfaces.push_back(surface.failed() ? SpectralParameters{} : parameters_within(surface.used(), {.shortest = shortest}, result.study.analysis.conversion));
        const auto of_cut = [&](std::size_t i) -> const SpectralParameters& { return point.surfaces[i]; };
        point.modified = fit_work_of_adhesion(points(result, &Balances::modified, of_cut));
        point.persson_tosatti = fit_work_of_adhesion(points(result, &Balances::persson_tosatti, of_cut));
        scan.push_back(std::move(point));
    }
    return scan;
}

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// A term of a sum of variances from an input and how fast the sum's square root moves with it.
VarianceTerm term(const Estimate& input, double derivative) {
    return {derivative * derivative * input.variance(), input.degrees_of_freedom.value_or(unlimited)};
}

/// Degrees of freedom of a sum of variances, absent where they count as known.
std::optional<double> freedom(const std::vector<VarianceTerm>& terms) {
    const double found = satterthwaite_degrees_of_freedom(terms);
    return std::isfinite(found) ? std::optional(found) : std::nullopt;
}

PredictedWork predicted(const adhesion::ApparentWork& apparent, const PairPoint& point, const Estimate& work, std::optional<double> degrees_of_freedom, bool known_spread) {
    const double variance = point.prediction_variance(work.value) + point.slope * point.slope * work.variance();
    PredictedWork result{apparent, {apparent.raw, known_spread ? std::sqrt(variance) : undefined, "delta"}};
    result.estimate.degrees_of_freedom = degrees_of_freedom;
    return result;
}

PredictionBudget budget(const PairPoint& point, const SurfaceResult& surface, const ElastomerResult& elastomer, const Estimate& work) {
    const double r = point.slope;
    const double modulus = surface.used().parameters.elastic_energy_per_modulus * std::sqrt(elastomer.contact_modulus.variance());
    const double surface_energy = (r - 1.0) * std::sqrt(elastomer.input.surface_energy.variance());
    const double spectrum2 = point.prediction_variance(work.value) - modulus * modulus - surface_energy * surface_energy;
    return {std::sqrt(std::max(0.0, spectrum2)), modulus, surface_energy, r * std::sqrt(work.variance())};
}

void predict(PairResult& pair, const SurfaceResult& surface, const ElastomerResult& elastomer, const Estimate& work) {
    const Balances balances(surface, elastomer, surface.used().parameters);
    const bool known_spread = !surface.used().spread.replicas.empty() || !surface.used().spread.sources.empty();
    const auto modified = balances.modified();
    const adhesion::ConformalState state{pair.area_ratio, pair.stored_energy.value};
    const double surface_energy = elastomer.input.surface_energy.value;
    const auto& parameters = surface.used().parameters;
    const auto freedom_with = [&](double (*area_ratio)(double), const Estimate& soft_surface_energy) {
        const auto prediction = [&](const SpectralParameters& p) {
            return (work.value - soft_surface_energy.value) * area_ratio(p.rms_slope) - elastomer.contact_modulus.value * p.elastic_energy_per_modulus;
        };
        const double ratio = area_ratio(parameters.rms_slope);
        return freedom({surface.used().spread.variance_term(prediction), term(elastomer.contact_modulus, parameters.elastic_energy_per_modulus),
                        term(soft_surface_energy, ratio - 1.0), term(work, ratio)});
    };
    pair.modified = predicted(adhesion::modified_balance(work.value, surface_energy, state), modified, work,
                              freedom_with(roughness::gaussian_area_ratio, elastomer.input.surface_energy), known_spread);
    pair.persson_tosatti = predicted(adhesion::persson_tosatti_balance(work.value, surface.used().parameters.rms_slope, state.stored_energy),
                                     balances.persson_tosatti(), work, freedom_with(roughness::small_slope_area_ratio, Estimate{}), known_spread);
    pair.without_area_change = predicted(adhesion::balance_without_area_change(work.value, state), balances.without_area_change(), work,
                                         freedom_with(roughness::gaussian_area_ratio, Estimate{}), known_spread);
    if (const auto& law = elastomer.input.surface_energy_law) pair.general = adhesion::general_balance(work.value, *law, state);
    pair.budget = budget(modified, surface, elastomer, work);
    pair.scales = adhesion::scale_balance(roughness::cumulative_parameters(surface.used().curve), elastomer.contact_modulus.value, work.value, surface_energy);
    const auto subject = pair.surface + " × " + pair.elastomer;
    if (!pair.modified->work.conforms)
        pair.alerts.push_back({"WILL_NOT_CONFORM", subject, fmt::format("(7) gives {:.3g} mJ/m2, floored at 0", 1e3 * pair.modified->work.raw),
                               "conformal contact is not predicted; area and energy of full contact do not apply"});
    if (const auto& band = pair.scales->bridging)
        pair.alerts.push_back({"CONFORMAL_INVALID", subject,
                               fmt::format("the roughness above q stores more than it gains for q between {:.3g} and {:.3g} 1/m (wavelengths {:.3g} to {:.3g} m)",
                                           band->lower, band->upper, 2.0 * pi / band->upper, 2.0 * pi / band->lower),
                               "the solid would rather bridge these wavelengths than conform"});
}

}  // namespace

std::optional<double> ideal_loss(const ElastomerResult& elastomer, double work_of_adhesion) {
    if (!elastomer.input.sphere_radius || !(elastomer.contact_modulus.value > 0.0)) return std::nullopt;
    if (!(work_of_adhesion > 0.0)) return 0.0;
    return contact::jkr::ideal_loop_loss({*elastomer.input.sphere_radius, elastomer.contact_modulus.value, work_of_adhesion}).total;
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

void predict_pairs(StudyResult& result) {
    Estimate work;
    if (result.study.work_of_adhesion) {
        work = *result.study.work_of_adhesion;
        result.work_of_adhesion_source = "given in the study";
    } else if (result.modified) {
        work = result.modified->clustered;
        result.work_of_adhesion_source = "fit of (7) to the measured pairs";
    } else {
        result.work_of_adhesion = Outcome<Estimate>::missing("no work_of_adhesion in the study, and no fit: " + result.modified.reason);
        return;
    }
    result.work_of_adhesion = work;
    for (auto& pair : result.pairs) {
        const auto& surface = result.surface(pair.surface);
        const auto& elastomer = result.elastomer(pair.elastomer);
        if (!obstacle(surface, elastomer).empty()) continue;
        pair.area_ratio = surface.area_ratio();
        const double modulus = elastomer.contact_modulus.value;
        const double energy = surface.used().parameters.elastic_energy_per_modulus;
        const auto spread = surface.used().spread.standard_error([](const SpectralParameters& p) { return p.elastic_energy_per_modulus; });
        pair.stored_energy = {modulus * energy, std::hypot(modulus * spread, energy * std::sqrt(elastomer.contact_modulus.variance())), "delta"};
        pair.stored_energy.degrees_of_freedom = freedom({surface.used().spread.variance_term([modulus](const SpectralParameters& p) { return modulus * p.elastic_energy_per_modulus; }),
                                                         term(elastomer.contact_modulus, energy)});
        predict(pair, surface, elastomer, work);
    }
}

}  // namespace setae::workflow
