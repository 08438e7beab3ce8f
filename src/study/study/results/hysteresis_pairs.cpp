// SPDX-License-Identifier: GPL-3.0-or-later
#include "hysteresis_pairs.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pairs.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"
#include "setae/roughness/energy_below.hpp"
#include "setae/study/loop_dependence.hpp"
#include "statistics.hpp"

namespace setae::study {
namespace {

using hysteresis::Reading;
using hysteresis::RetractionPair;

/// φ of an elastomer's references, the mean of both branches over all of them.
std::optional<TracedValue> tip_factor_of(const StudyResult& result, const std::string& elastomer) {
    const auto works = reference_works(result, elastomer);
    if (!works) return std::nullopt;
    const std::vector<Estimate> both{works->retraction, works->approach};
    return TracedValue(setae::propagated([](const Array1D& x) { return x[0] / x[1]; }, both),
                       fmt::format("W_ret/W_app of the reference on {}", elastomer));
}

/// U_el by bands of a factor of 4, finest first, divided by its sum; the mean wavelength of a band is that of narrow
/// parts.
std::vector<hysteresis::PinningBand> bands_of(const spectra::Spectrum& curve) {
    const auto cumulative = roughness::cumulative_parameters(curve);
    const auto &q = cumulative.wavevector, &energy = cumulative.elastic_energy_per_modulus;
    const Index last = q.size() - 1;
    if (last < 1 || !(energy[last] > 0.0)) return {};
    const auto below = [&](double wavevector) { return roughness::energy_below(cumulative, wavevector); };
    constexpr double factor = 4.0;
    constexpr int parts = 8;
    const double narrow = std::pow(factor, 1.0 / parts);
    std::vector<hysteresis::PinningBand> bands;
    for (double upper = q[last]; upper > q[0]; upper /= factor) {
        const double stored = below(upper) - below(upper / factor);
        double sum = 0.0, end = upper;
        for (int part = 0; part < parts; ++part, end /= narrow)
            sum += (below(end) - below(end / narrow)) * 2.0 * pi * std::sqrt(narrow) / end;
        if (stored > 0.0) bands.push_back({.share = stored / energy[last], .mean_wavelength = sum / stored});
    }
    return bands;
}

/// The preload that the study states, else the force under which the measured contact area is reached.
std::optional<hysteresis::Pressing> pressing_of(const ElastomerResult& elastomer, const PairResult& pair,
                                                const RetractionPair& base) {
    if (elastomer.input.preload) return hysteresis::Pressing{.maximum_force = *elastomer.input.preload};
    if (!base.radius || !pair.contact_area || !pair.approach || !(pair.approach->value > 0.0)) return std::nullopt;
    const contact::jkr::Contact as_measured{.radius = base.radius->value,
                                            .contact_modulus = base.soft.contact_modulus.value,
                                            .work_of_adhesion = pair.approach->value};
    const double force = contact::jkr::force(std::sqrt(*pair.contact_area / pi), as_measured);
    return hysteresis::Pressing{.maximum_force = std::max(0.0, force)};
}

/// The mean of loops on the pair, else of loops on its elastomer; empty where none states it.
std::optional<TracedValue> machine_stiffness_of(const StudyResult& result, const PairResult& pair) {
    const auto stated = [&](bool on_pair) {
        std::vector<TracedValue> found;
        for (const auto& e : result.experiments) {
            if (e.failed() || e.input.excluded() || !e.input.machine_stiffness || e.input.elastomer != pair.elastomer)
                continue;
            if (on_pair && (e.input.reference || e.input.surface != pair.surface)) continue;
            const auto& value = *e.input.machine_stiffness;
            found.emplace_back(value, input_name(value, e.input.file + ".machine_stiffness"));
        }
        return found;
    };
    auto found = stated(true);
    if (found.empty()) found = stated(false);
    if (found.empty()) return std::nullopt;
    const double share = 1.0 / static_cast<double>(found.size());
    TracedValue mean;
    for (const auto& one : found) {
        mean.value += share * one.value;
        mean.components = combined({{1.0, mean.components}, {share, one.components}});
    }
    return mean;
}

/// Method for W_ret of a pair: Eq. S1 where there is none by Eq. S2.
Reading reading_of(const PairResult& pair) {
    return !pair.retraction && pair.pull_off ? Reading::smallest_force : Reading::last_points;
}

/// The factor of the pair's edge: about measured W_ret, else about twice W_int; empty where an input is unknown.
std::optional<hysteresis::SpeedFactor> speed_factor_of(const RetractionPair& pair, const PairDrive& drive,
                                                       Reading reading, const std::optional<Estimate>& read) {
    if (!pair.edge_speed || !pair.radius || !(pair.contact_area || pair.pressing)) return std::nullopt;
    hysteresis::TracedSphere sphere{
        .radius = *pair.radius, .contact_modulus = pair.soft.contact_modulus, .contact_radius = {}};
    if (pair.machine_stiffness) sphere.machine_stiffness = *pair.machine_stiffness;
    const double work = pair.work_of_adhesion.value;
    if (pair.contact_area)
        sphere.contact_radius = setae::propagated([](const std::vector<double>& in) { return std::sqrt(in[0] / pi); },
                                                  {*pair.contact_area});
    else
        sphere.contact_radius = contact::jkr::contact_radius_at_force(
            pair.pressing->maximum_force, {.radius = pair.radius->value,
                                           .contact_modulus = pair.soft.contact_modulus.value,
                                           .work_of_adhesion = work});
    const hysteresis::EdgePull pull{
        .motor_speed = drive.drive.retraction_speed, .reading_time = drive.reading_time, .reading = reading};
    try {
        if (read && read->value > 0.0) return speed_factor_of_reading(sphere, *pair.edge_speed, pull, read->value);
        return speed_factor(sphere, *pair.edge_speed, pull, 2.0 * work);
    } catch (const InvalidArgument&) {
        return std::nullopt;  // a law so steep that the edge cannot be computed
    }
}

/// W_ret for which a loop with the measured W_app and contact area would have the measured loss, without the share of
/// the bulk.
std::optional<TracedValue> work_of_area(const PreparedPair& pair) {
    const auto loss = pair.measured.traced_loss();
    const auto& as = *pair.as_measured;
    if (!loss || !as.approach || !(as.approach->value > 0.0) || !as.radius || !as.contact_area) return std::nullopt;
    const double bulk = pair.measured.bulk_loss.value_or(0.0);
    enum Input : std::size_t { approach, radius, modulus, contact_area, energy_loss, stiffness };
    const auto work = [&](const std::vector<double>& in) {
        const hysteresis::HystereticSphere sphere{.radius = in[radius],
                                                  .contact_modulus = in[modulus],
                                                  .work_approach = in[approach],
                                                  .work_retraction = in[approach]};
        const auto pressing = as.pressed(sphere.approach(), in[contact_area], in[stiffness]);
        return hysteresis::work_retraction_for_loss(sphere, pressing, in[energy_loss] - bulk);
    };
    try {
        return setae::propagated(work, {*as.approach, *as.radius, as.soft.contact_modulus, *as.contact_area, *loss,
                                        as.machine_stiffness.value_or(TracedValue())});
    } catch (const InvalidArgument&) {
        return std::nullopt;  // the jumps would dissipate more
    }
}

void read_area(PreparedPair& pair, const std::optional<PairDrive>& drive) {
    auto work = work_of_area(pair);
    if (!work) return;
    hysteresis::MeasuredWork read{.value = {.value = work->value, .standard_error = 0.0}, .inputs = {}};
    const auto noise = work->components.find(input_name(
        *pair.measured.loss, adhesion::own_noise_name("E_loss", pair.measured.surface, pair.measured.elastomer)));
    if (noise != work->components.end()) {
        read.value.standard_error = std::sqrt(noise->second.variance());
        work->components.erase(noise);
    }
    read.inputs = std::move(work->components);
    pair.by_area.emplace(*pair.as_measured);
    if (drive) pair.by_area->speed_factor = speed_factor_of(*pair.by_area, *drive, Reading::loop_area, read.value);
    pair.of_area = std::move(read);
}

/// Reason for which retraction models do not apply to a pair; empty where they do.
std::string reason_against(const SurfaceResult& surface, const PairResult& pair, double work_of_adhesion,
                           const ElastomerResult& elastomer) {
    if (surface.failed()) return surface.error;
    if (!pair.modified) return "the modulus is not known";
    const hysteresis::PairState state{.area_ratio = pair.area_ratio,
                                      .work_of_adhesion = work_of_adhesion,
                                      .surface_energy = elastomer.input.surface_energy.value};
    return state.full_contact_gain() > 0.0 ? "" : "stretching the soft side costs more than W_int gains";
}

/// Reason for which a retraction model cannot be evaluated for a pair; empty where all can.
std::string reason_of_models(const PreparedPair& pair) {
    const hysteresis::MeasuredWork any{.value = {.value = 1.0, .standard_error = 0.0}, .inputs = {}};
    try {
        for (const auto& model : hysteresis::retraction_models())
            for (const auto* of : {&*pair.from_roughness, &*pair.as_measured})
                if (of->lacks(model).empty()) (void)hysteresis::retraction_point(model, *of, any);
    } catch (const InvalidArgument& error) {
        return error.what();
    }
    return "";
}

const ElastomerTimes& times_of(std::vector<ElastomerTimes>& known, const StudyResult& result,
                               const std::string& elastomer) {
    for (const auto& times : known)
        if (times.elastomer == elastomer) return times;
    return known.emplace_back(
        ElastomerTimes{elastomer, edge_speed_of(result, elastomer), relaxation_of(result, elastomer)});
}

}  // namespace

PreparedPairs prepared_pairs(const StudyResult& result) {
    PreparedPairs found;
    for (const auto& pair : result.pairs) {
        const auto& surface = result.surface(pair.surface);
        const auto& elastomer = result.elastomer(pair.elastomer);
        if (auto reason = reason_against(surface, pair, result.traced_work_of_adhesion.value, elastomer);
            !reason.empty()) {
            found.skipped.push_back({pair.surface, pair.elastomer, std::move(reason)});
            continue;
        }
        const auto& spectrum = surface.used();
        auto& prepared = found.pairs.emplace_back(
            PreparedPair{.measured = pair,
                         .elastomer = elastomer,
                         .roughness = adhesion::roughness_in_contact(spectrum.parameters, spectrum.spread, pair.seen),
                         .from_roughness = {},
                         .as_measured = {},
                         .by_area = {},
                         .of_area = {}});
        RetractionPair base{.rough = {surface.name, prepared.roughness.parameters, prepared.roughness.spread},
                            .soft = elastomer.soft_side(),
                            .work_of_adhesion = result.traced_work_of_adhesion,
                            .reference_work = reference_work(result, pair.elastomer),
                            .tip_factor = tip_factor_of(result, pair.elastomer),
                            .bands = bands_of(spectrum.curve)};
        if (elastomer.input.sphere_radius) base.radius = elastomer.traced_radius();
        base.pressing = pressing_of(elastomer, pair, base);
        base.machine_stiffness = machine_stiffness_of(result, pair);
        const auto& times = times_of(found.elastomers, result, pair.elastomer);
        if (times.edge) base.edge_speed = times.edge->law;
        base.relaxation = times.relaxation;
        auto measured = base;
        measured.approach = pair.traced_approach();
        if (pair.contact_area) measured.contact_area = TracedValue(*pair.contact_area, pair.contact_area_inputs);
        const auto drive = drive_of(result, pair.surface, pair.elastomer);
        if (drive) {
            base.drive = hysteresis::Drive{.approach_speed = drive->drive.approach_speed,
                                           .retraction_speed = drive->drive.retraction_speed,
                                           .hold_time = drive->drive.hold_time};
            base.speed_factor = speed_factor_of(measured, *drive, reading_of(pair), prepared.retraction());
            measured.drive = base.drive;
            measured.speed_factor = base.speed_factor;
        }
        prepared.from_roughness.emplace(std::move(base));
        prepared.as_measured.emplace(std::move(measured));
        read_area(prepared, drive);
        if (auto reason = reason_of_models(prepared); !reason.empty()) {
            found.skipped.push_back({pair.surface, pair.elastomer, std::move(reason)});
            found.pairs.pop_back();
        }
    }
    return found;
}

}  // namespace setae::study
