// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/validation/record_trials.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include <fmt/format.h>

#include "record_kinds.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"
#include "setae/loops/analysis.hpp"

namespace setae::validation {
namespace {

using numerics::RandomKey;

/// The kinds of one set of trials.
using Combination = std::vector<const RecordKind*>;

const RecordKind& kind_named(const std::string& name) {
    std::string names;
    for (const auto& kind : record_kinds()) {
        if (kind.name == name) return kind;
        names += (names.empty() ? "" : ", ") + kind.name;
    }
    throw InvalidArgument(fmt::format("unknown kind of record '{}'; there are {}", name, names));
}

/// Whether a record can be of both kinds. Free flight is cut at contact, which there must be.
bool go_together(const RecordKind& a, const RecordKind& b) {
    const auto cuts = [](const RecordKind& kind) { return kind.group == "free flight"; };
    const auto contactless = [](const RecordKind& kind) { return kind.name == "no_contact"; };
    return a.group != b.group && !(cuts(a) && contactless(b)) && !(cuts(b) && contactless(a));
}

std::vector<Combination> combinations(const RecordTrialOptions& options) {
    Combination chosen;
    if (options.kinds.empty())
        for (const auto& kind : record_kinds()) chosen.push_back(&kind);
    for (const auto& name : options.kinds) chosen.push_back(&kind_named(name));
    std::vector<Combination> result;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        if (!options.pairs) result.push_back({chosen[i]});
        for (std::size_t j = i + 1; options.pairs && j < chosen.size(); ++j)
            if (go_together(*chosen[i], *chosen[j])) result.push_back({chosen[i], chosen[j]});
    }
    return result;
}

double between(RandomKey key, std::uint64_t counter, double low, double high) {
    return low + (high - low) * numerics::uniform_number(key, counter);
}
double between_decades(RandomKey key, std::uint64_t counter, double low, double high) {
    return low * std::pow(high / low, numerics::uniform_number(key, counter));
}

/// A sphere and its machine, drawn.
RecordInMaking drawn_record(RandomKey key) {
    RecordInMaking record{.key = key};
    auto& specimen = record.specimen;
    specimen = {.radius = between_decades(key, 0, 6e-6, 2e-3),
                .contact_modulus = between_decades(key, 1, 0.2e6, 8e6),
                .work_approach = between(key, 2, 0.020, 0.060)};
    specimen.work_retraction = specimen.work_approach * between(key, 3, 1.05, 2.0);
    record.pull_off = 1.5 * pi * specimen.radius * specimen.work_retraction;
    record.protocol.maximum_force = 4.0 * record.pull_off;
    const auto turn = contact::jkr::contact_radius_at_force(record.protocol.maximum_force, specimen.approach());
    record.penetration = contact::jkr::displacement(turn, specimen.approach());
    return record;
}

/// Speed and free flight, for a known machine. The first sample is anywhere in a step.
void set_pace(RecordInMaking& record) {
    auto& protocol = record.protocol;
    const double samples = std::floor(between(record.key, 4, 200.0, 600.0));
    const double way =
        record.penetration +
        (std::isinf(protocol.machine_stiffness) ? 0.0 : protocol.maximum_force / protocol.machine_stiffness);
    const double step = way / samples;
    protocol.approach_speed = protocol.retraction_speed = step * protocol.force_rate;
    protocol.start_gap = 0.35 * way + step * numerics::uniform_number(record.key, 5);
    if (protocol.camera_rate > protocol.force_rate || !record.camera) protocol.camera_rate = protocol.force_rate;
}

/// x_i = φ x_(i−1) + √(1 − φ²) e_i of variance 1.
Array1D noise_of(RandomKey key, Index samples, double correlation) {
    Array1D values = numerics::normal_numbers(key, 0, samples);
    for (Index i = 1; i < samples; ++i)
        values[i] = correlation * values[i - 1] + std::sqrt(1.0 - correlation * correlation) * values[i];
    return values;
}

void simulate(RecordInMaking& record) {
    const auto made = simulation::simulated_loop(record.specimen, record.protocol, {.compliance = record.compliance});
    record.loop = made.loop;
    record.energy_loss = made.truth.energy_loss();
    if (!record.camera) record.loop.contact_radius = Array1D();
    if (!record.touches) record.loop.force.setZero();
}

void add_noise(RecordInMaking& record) {
    auto& loop = record.loop;
    const Index n = loop.force.size();
    const auto noise = [&](std::uint64_t stream, double correlation) {
        return noise_of(numerics::substream(record.key, stream), n, correlation);
    };
    loop.force += record.force_noise * record.pull_off * noise(1, record.force_correlation);
    loop.displacement += record.displacement_noise * record.penetration * noise(2, record.displacement_correlation);
    if (loop.contact_radius.size() == 0) return;
    constexpr double radius_noise = 0.005;
    const double largest = loop.contact_radius.unaryExpr([](double a) { return a > 0.0 ? a : 0.0; }).maxCoeff();
    const Array1D of_radius = noise(3, 0.0);
    for (Index i = 0; i < n; ++i)
        if (loop.contact_radius[i] > 0.0)
            loop.contact_radius[i] =
                std::max(loop.contact_radius[i] + radius_noise * largest * of_radius[i], 1e-3 * largest);
}

RecordInMaking made_record(const Combination& kinds, RandomKey key) {
    RecordInMaking record = drawn_record(key);
    for (const auto* kind : kinds) change_experiment(kind->name, record);
    set_pace(record);
    simulate(record);
    // contact is identified by a force that is not 0: changes of the zero are applied last
    const auto changes = [&](const std::string& group) {
        for (const auto* kind : kinds)
            if (kind->group == group) change_course(kind->name, record);
    };
    for (const char* group : {"turn", "free flight", "drift", "offset"}) changes(group);
    add_noise(record);
    for (const auto* kind : kinds) change_channels(kind->name, record);
    return record;
}

bool names_cause(const RecordTrial& trial, const Combination& kinds) {
    const std::string refusal = "refused:";
    for (const auto* kind : kinds)
        for (const auto& cause : kind->causes) {
            if (cause.starts_with(refusal)) {
                if (trial.refused.find(cause.substr(refusal.size())) != std::string::npos) return true;
            } else if (std::find(trial.warnings.begin(), trial.warnings.end(), cause) != trial.warnings.end()) {
                return true;
            }
        }
    return false;
}

void add_routes(RecordTrial& trial, const loops::LoopAnalysis& found, const RecordInMaking& record) {
    const auto add = [&](const char* name, double known, const Estimate& estimate) {
        trial.routes.push_back({name, known, estimate});
    };
    const auto& s = record.specimen;
    const double approach = s.work_approach < 1e-6 * s.work_retraction ? 0.0 : s.work_approach;
    add("E*", s.contact_modulus, found.loading.primary().contact_modulus);
    add("W", approach, found.loading.primary().work_of_adhesion);
    if (found.unloading) add("W_ret", s.work_retraction, found.unloading->primary().work_of_adhesion);
    if (found.pull_off) add("W_pull_off", s.work_retraction, found.pull_off->work_of_adhesion);
    if (found.retraction) add("W_last_points", s.work_retraction, found.retraction->work_of_adhesion);
    if (found.loop && record.closed) add("E_loss", record.energy_loss, found.loop->estimate());
}

RecordTrial trial_of(const Combination& kinds, std::uint64_t seed, RandomKey key) {
    RecordTrial trial{.seed = seed};
    for (const auto* kind : kinds) trial.kinds.push_back(kind->name);
    const RecordInMaking record = made_record(kinds, key);
    const loops::LensAndCounterBody bodies{.radius = record.specimen.radius,
                                           .counter_youngs_modulus = std::numeric_limits<double>::infinity()};
    try {
        const auto found = loops::analyse(record.loop, bodies, record.options);
        add_routes(trial, found, record);
        for (const auto& alert : found.alerts) trial.warnings.push_back(alert.code);
    } catch (const UndefinedDataError& error) {
        trial.refused = error.what();
    } catch (const InvalidArgument& error) {  // too few samples are left
        trial.refused = error.what();
    }
    trial.cause_named = names_cause(trial, kinds);
    return trial;
}

}  // namespace

int number_of_trials(const RecordTrialOptions& options) {
    return static_cast<int>(combinations(options).size()) * options.runs;
}

std::vector<RecordTrial> record_trials(const RecordTrialOptions& options) {
    if (options.runs < 1) throw InvalidArgument(fmt::format("{} runs; expected at least 1", options.runs));
    const auto sets = combinations(options);
    const auto runs = static_cast<std::size_t>(options.runs);
    std::vector<RecordTrial> trials(sets.size() * runs);
    std::mutex telling;
    int done = 0;
    parallel::for_each_index(trials.size(), options.threads, [&](std::size_t i) {
        const std::uint64_t seed = options.first_seed + i % runs;
        trials[i] = trial_of(sets[i / runs], seed, {seed, i / runs});
        const std::scoped_lock lock(telling);
        if (options.progress) options.progress(++done);
    });
    return trials;
}

}  // namespace setae::validation
