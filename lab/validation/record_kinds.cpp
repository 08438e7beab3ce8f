// SPDX-License-Identifier: GPL-3.0-or-later
#include "record_kinds.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "setae/core/constants.hpp"
#include "setae/validation/record_trials.hpp"

namespace setae::validation {
namespace {

/// First and last sample in contact.
std::pair<Index, Index> contact_of(const loops::Loop& loop) {
    // without noise the force is exactly 0 in free flight
    Index first = 0, last = loop.force.size() - 1;
    while (first < last && loop.force[first] == 0.0) ++first;
    while (last > first && loop.force[last] == 0.0) --last;
    return {first, last};
}

void keep(loops::Loop& loop, Index first, Index last) {
    for (Array1D* series : {&loop.time, &loop.force, &loop.displacement, &loop.contact_radius})
        if (series->size() > 0) *series = Array1D(series->segment(first, last - first + 1));
}

Array1D share_of_time(const loops::Loop& loop) { return Array1D::LinSpaced(loop.force.size(), 0.0, 1.0); }

void add_step(RecordInMaking& record, double share, double at) {
    auto& force = record.loop.force;
    const auto first = static_cast<Index>(at * static_cast<double>(force.size()));
    force.tail(force.size() - first) += share * record.pull_off;
}

/// Position between first contact and separation: 0 … 1; −1 … 0: in the free flight before.
double place(const RecordInMaking& record, double share) {
    const auto [first, last] = contact_of(record.loop);
    const auto n = static_cast<double>(record.loop.force.size());
    if (share < 0.0) return (1.0 + share) * static_cast<double>(first) / n;
    return (static_cast<double>(first) + share * static_cast<double>(last - first)) / n;
}

/// Partial releases at the turn, the edge pinned: a flat punch.
void add_cycles(RecordInMaking& record) {
    constexpr int cycles = 3;
    auto& loop = record.loop;
    Index turn = 0;
    loop.force.maxCoeff(&turn);
    const double step = std::abs(loop.displacement[turn] - loop.displacement[turn - 1]);
    const auto& s = record.specimen;
    const double radius = contact::jkr::contact_radius_at_force(loop.force[turn], s.approach());
    const double stiffness = 2.0 * radius * s.contact_modulus;
    // as deep as the edge stays pinned, at most a tenth of the penetration
    const auto unpinned = hysteresis::sphere_loop(s, record.protocol.pressing()).unpinned;
    const double depth = std::min(0.5 * (loop.displacement[turn] - unpinned.displacement), 0.1 * record.penetration);
    const auto steps = std::max<Index>(static_cast<Index>(depth / step), 4);
    const Index added = 2 * steps * cycles, n = loop.force.size();
    const auto widened = [&](const Array1D& series, const auto& value) {
        if (series.size() == 0) return Array1D();
        Array1D result(n + added);
        result.head(turn + 1) = series.head(turn + 1);
        for (Index i = 0; i < added; ++i) {
            const Index phase = i % (2 * steps) + 1;
            result[turn + 1 + i] = value(static_cast<double>(phase <= steps ? phase : 2 * steps - phase) * depth /
                                         static_cast<double>(steps));
        }
        result.tail(n - turn - 1) = series.tail(n - turn - 1);
        return result;
    };
    const double force = loop.force[turn], displacement = loop.displacement[turn];
    const double interval = loop.time[1] - loop.time[0];
    loop.force = widened(loop.force, [&](double back) { return force - stiffness * back; });
    loop.displacement = widened(loop.displacement, [&](double back) { return displacement - back; });
    loop.contact_radius = widened(loop.contact_radius, [&](double) { return radius; });
    loop.time = interval * Array1D::LinSpaced(n + added, 0.0, static_cast<double>(n + added - 1));
}

Array1D rounded(const Array1D& series, double step) { return step * (series / step).round(); }

/// As text with so many digits has it.
Array1D with_digits(const Array1D& series, int digits) {
    return series.unaryExpr([digits](double value) {
        if (value == 0.0) return value;
        const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - digits + 1.0);
        return unit * std::round(value / unit);
    });
}

using Change = std::function<void(RecordInMaking&)>;
using Changes = std::map<std::string, Change>;

double contact_stiffness(const RecordInMaking& record) {
    const auto& s = record.specimen;
    return 2.0 * s.contact_modulus * contact::jkr::contact_radius_at_force(record.protocol.maximum_force, s.approach());
}

const Changes& experiments() {
    static const Changes changes{
        {"force_exact", [](auto& r) { r.force_noise = 0.0; }},
        {"force_noise_0.3", [](auto& r) { r.force_noise = 0.003; }},
        {"force_noise_3", [](auto& r) { r.force_noise = 0.03; }},
        {"force_noise_10", [](auto& r) { r.force_noise = 0.1; }},
        {"force_correlated_0.8", [](auto& r) { r.force_correlation = 0.8; }},
        {"force_correlated_0.95", [](auto& r) { r.force_correlation = 0.95; }},
        {"stage_noise_0.1", [](auto& r) { r.displacement_noise = 0.001; }},
        {"stage_noise_1", [](auto& r) { r.displacement_noise = 0.01; }},
        {"stage_noise_3", [](auto& r) { r.displacement_noise = 0.03; }},
        {"stage_noise_10", [](auto& r) { r.displacement_noise = 0.1; }},
        {"stage_correlated_0.9",
         [](auto& r) {
             r.displacement_noise = 0.01;
             r.displacement_correlation = 0.9;
         }},
        {"camera", [](auto& r) { r.camera = true; }},
        {"camera_slow",
         [](auto& r) {
             r.camera = true;
             r.protocol.camera_rate = r.protocol.force_rate / 7.0;
         }},
        {"hold", [](auto& r) { r.protocol.hold_time = 100.0 / r.protocol.force_rate; }},
        {"no_snap_in", [](auto& r) { r.specimen.work_approach = 1e-9 * r.specimen.work_retraction; }},
        {"machine_as_stiff", [](auto& r) { r.protocol.machine_stiffness = contact_stiffness(r); }},
        {"machine_soft", [](auto& r) { r.protocol.machine_stiffness = 0.3 * contact_stiffness(r); }},
        {"stage_stiffness_given",
         [](auto& r) {
             r.protocol.machine_stiffness = 3.0 * contact_stiffness(r);
             r.options.machine_stiffness = r.protocol.machine_stiffness;
             r.compliance = 1.0 / r.protocol.machine_stiffness;
         }},
        {"stage_stiffness_not_given",
         [](auto& r) {
             r.protocol.machine_stiffness = 10.0 * contact_stiffness(r);
             r.compliance = 1.0 / r.protocol.machine_stiffness;
         }},
        {"no_contact", [](auto& r) { r.touches = false; }}};
    return changes;
}

const Changes& courses() {
    const auto drift = [](double share, double (*shape)(double)) {
        return [share, shape](RecordInMaking& r) {
            r.loop.force += share * r.pull_off * share_of_time(r.loop).unaryExpr(shape);
        };
    };
    constexpr auto line = [](double t) { return t; };
    constexpr auto square = [](double t) { return t * t; };
    constexpr auto settling = [](double t) { return std::exp(-t / 0.2); };
    constexpr auto wave = [](double t) { return 0.5 * std::sin(1.4 * pi * t + 1.0); };
    static const Changes changes{
        {"drift_3", drift(0.03, line)},
        {"drift_10", drift(0.1, line)},
        {"drift_30", drift(0.3, line)},
        {"drift_100", drift(1.0, line)},
        {"drift_-100", drift(-1.0, line)},
        {"drift_square_10", drift(0.1, square)},
        {"drift_square_100", drift(1.0, square)},
        {"drift_settling_30", drift(0.3, settling)},
        {"drift_wave_30", drift(0.3, wave)},
        {"step_5_in_free_flight", [](auto& r) { add_step(r, 0.05, place(r, -0.5)); }},
        {"step_20_in_free_flight", [](auto& r) { add_step(r, 0.2, place(r, -0.5)); }},
        {"step_5_in_contact", [](auto& r) { add_step(r, 0.05, place(r, 0.3)); }},
        {"step_20_in_contact", [](auto& r) { add_step(r, 0.2, place(r, 0.3)); }},
        {"offset", [](auto& r) { r.loop.force -= 3.0 * r.pull_off; }},
        {"cycles", [](auto& r) { add_cycles(r); }},
        {"baselines_short",
         [](auto& r) {
             const auto [first, last] = contact_of(r.loop);
             const Index left = std::max<Index>(12, (last - first) / 20);
             keep(r.loop, std::max<Index>(first - left, 0), std::min(last + left, r.loop.force.size() - 1));
         }},
        {"baseline_before_only",
         [](auto& r) {
             keep(r.loop, 0, contact_of(r.loop).second);
             r.closed = false;
         }},
        {"baseline_after_only",
         [](auto& r) {
             keep(r.loop, contact_of(r.loop).first + 8, r.loop.force.size() - 1);
             r.closed = false;
         }},
        {"no_baseline",
         [](auto& r) {
             const auto [first, last] = contact_of(r.loop);
             keep(r.loop, first + 8, last);
             r.closed = false;
         }},
        {"ends_at_largest_force",
         [](auto& r) {
             Index turn = 0;
             r.loop.force.maxCoeff(&turn);
             keep(r.loop, 0, turn);
             r.closed = false;
         }},
    };
    return changes;
}

const Changes& channels() {
    static const Changes changes{{"rounding_0.2",
                                  [](auto& r) {
                                      r.loop.force = rounded(r.loop.force, 0.002 * r.pull_off);
                                      r.loop.displacement = rounded(r.loop.displacement, 0.002 * r.penetration);
                                  }},
                                 {"rounding_2",
                                  [](auto& r) {
                                      r.loop.force = rounded(r.loop.force, 0.02 * r.pull_off);
                                      r.loop.displacement = rounded(r.loop.displacement, 0.02 * r.penetration);
                                  }},
                                 {"digits_6",
                                  [](auto& r) {
                                      r.loop.force = with_digits(r.loop.force, 6);
                                      r.loop.displacement = with_digits(r.loop.displacement, 6);
                                  }},
                                 {"no_time", [](auto& r) { r.loop.time = Array1D(); }},
                                 {"force_reversed", [](auto& r) { r.loop.force *= -1.0; }},
                                 {"displacement_reversed", [](auto& r) { r.loop.displacement *= -1.0; }},
                                 {"both_reversed",
                                  [](auto& r) {
                                      r.loop.force *= -1.0;
                                      r.loop.displacement *= -1.0;
                                  }},
                                 {"swapped", [](auto& r) { std::swap(r.loop.force, r.loop.displacement); }}};
    return changes;
}

void apply(const Changes& changes, const std::string& kind, RecordInMaking& record) {
    if (const auto change = changes.find(kind); change != changes.end()) change->second(record);
}

}  // namespace

void change_experiment(const std::string& kind, RecordInMaking& record) { apply(experiments(), kind, record); }
void change_course(const std::string& kind, RecordInMaking& record) { apply(courses(), kind, record); }
void change_channels(const std::string& kind, RecordInMaking& record) { apply(channels(), kind, record); }

const std::vector<RecordKind>& record_kinds() {
    const std::vector<std::string> curved{"DRIFT_NOT_LINEAR", "DRIFT_IRREGULAR"};
    static const std::vector<RecordKind> kinds{
        {"clean", "clean", "exact stage, force noise 1 %"},
        {"force_exact", "force noise", "no noise at all"},
        {"force_noise_0.3", "force noise", "force noise 0.3 %"},
        {"force_noise_3", "force noise", "force noise 3 %"},
        {"force_noise_10", "force noise", "force noise 10 %", {"NOISY_RECORD"}},
        {"force_correlated_0.8", "force correlation", "neighbours of the force noise correlated by 0.8"},
        {"force_correlated_0.95", "force correlation", "by 0.95"},
        {"stage_noise_0.1", "stage noise", "displacement noise 0.1 %"},
        {"stage_noise_1", "stage noise", "displacement noise 1 %"},
        {"stage_noise_3", "stage noise", "displacement noise 3 %"},
        {"stage_noise_10", "stage noise", "displacement noise 10 %", {"NOISY_RECORD"}},
        {"stage_correlated_0.9", "stage noise", "displacement noise 1 %, neighbours correlated by 0.9"},
        {"rounding_0.2", "rounding", "both channels rounded to 0.2 %"},
        {"rounding_2", "rounding", "to 2 %"},
        {"digits_6", "rounding", "six digits"},
        {"offset", "offset", "zero of force three pull-offs too low"},
        {"drift_3", "drift", "linear drift of the force by 3 %"},
        {"drift_10", "drift", "by 10 %"},
        {"drift_30", "drift", "by 30 %"},
        {"drift_100", "drift", "by 100 %"},
        {"drift_-100", "drift", "by -100 %"},
        {"drift_square_10", "drift", "drift with the square of time by 10 %", curved},
        {"drift_square_100", "drift", "by 100 %", curved},
        {"drift_settling_30", "drift", "exponential settling by 30 %, time constant a fifth of the record", curved},
        {"drift_wave_30", "drift", "0.7 periods of a sine of 30 % from peak to peak", curved},
        {"step_5_in_free_flight", "drift", "step by 5 % before contact", {"STEP_IN_FREE_FLIGHT"}},
        {"step_20_in_free_flight", "drift", "by 20 %", {"STEP_IN_FREE_FLIGHT"}},
        {"step_5_in_contact", "drift", "step by 5 % within contact", {"STEP_IN_CONTACT"}},
        {"step_20_in_contact", "drift", "by 20 %", {"STEP_IN_CONTACT"}},
        {"no_time", "time", "no column of time"},
        {"camera", "camera", "contact radius in every sample"},
        {"camera_slow", "camera", "in every seventh sample"},
        {"hold", "turn", "100 samples of rest at the largest force"},
        {"cycles", "turn", "three partial releases at the largest force"},
        {"no_snap_in", "approach", "no adhesion on approach"},
        {"machine_as_stiff", "machine", "the testing machine is as stiff as the contact"},
        {"machine_soft", "machine", "the testing machine has 0.3 of the contact's stiffness"},
        {"stage_stiffness_given", "machine", "stage position and stiffness given, three times that of the contact"},
        {"stage_stiffness_not_given",
         "machine",
         "stage position, stiffness ten times that of the contact and not given",
         {"POOR_FIT", "CONTACT_POINT_SPREAD"}},
        {"baselines_short", "free flight", "free flight of 5 % of the contact's samples"},
        {"baseline_before_only", "free flight", "the record ends at the last sample in contact", {"ONE_BASELINE"}},
        {"baseline_after_only", "free flight", "the record begins in contact", {"ONE_BASELINE"}},
        {"no_baseline", "free flight", "the record begins and ends in contact", {"refused:no free flight"}},
        {"ends_at_largest_force",
         "free flight",
         "the record ends at the largest force",
         {"ONE_BASELINE", "NO_RETRACTION"}},
        {"force_reversed", "columns", "tension is positive", {"refused:force seems to have the opposite sign"}},
        {"displacement_reversed",
         "columns",
         "the displacement falls on approach",
         {"refused:displacement seems to have the opposite sign"}},
        {"both_reversed", "columns", "both", {"refused:force and displacement seem to have the opposite sign"}},
        {"swapped", "columns", "force and displacement changed places", {"refused:seem to be exchanged"}},
        {"no_contact",
         "approach",
         "the sphere never touches",
         {"refused:no contact", "refused:never exceeds its noise"}}};
    return kinds;
}

}  // namespace setae::validation
